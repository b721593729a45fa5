/** From scene to scene, and to what an address asks for. */
import type { AddressBar } from "./address-bar";
import type { Loader } from "./load";
import type { Notice } from "./panels/notice";
import type { Session } from "./session";
import { followAddress, readAddress } from "./state/address";
import { goToEvent } from "./state/play";
import type { Kept } from "./state/types";
import type { SceneData } from "./trace/types";
import { awaited, troubleOfNextScene, troubleOfScene } from "./trouble";
import { list, say } from "./words";

const SHOWN_KEYS = 6; // of an address; more, and longer ones, would only be noise
const SHOWN_LETTERS = 16;

/** An address's fields; some depend on the scene, which is known by then. */
type Fields = (scene: SceneData) => ReadonlyMap<string, string>;
/** A lesson's first step, or its last, answered if it asks. */
const lessonFrom = (by: 1 | -1): Fields => ({ lesson }) => new Map(lesson.length ? (by > 0 ? [["step", "1"]] : [["step", `${lesson.length}`], ...(lesson.at(-1)!.answer ? [["answer", "1"]] as const : [])]) : null);

/** Puts one scene in the place of another. home: the scene the page is for. */
function createScenes(session: Session, home: string, loader: Loader, notice: Notice, loadTrace: () => Promise<void>) {
  let asked = 0; // the newest request; older ones that arrive late, or never, are dropped
  let heading = home; // the scene that is shown, or on its way

  /** The scene its address asks for, in this page; false if another one was asked for meanwhile. */
  async function show(id: string, fields: Fields, kept: Kept): Promise<boolean> {
    const mine = ++asked;
    heading = id;
    try {
      const scene = await awaited(loader.scene(id), "scene", notice);
      if (mine !== asked) return false;
      const { state, damaged } = followAddress(fields(scene), scene, kept);
      session.enter(scene, state);
      notice.leaveScene();
      document.body.classList.add("live");
      await loadTrace();
      if (mine !== asked) return false;
      if (stepBack()) damaged.push("e");
      if (damaged.length) notice.say(say("trouble.address", { keys: list(shortened(damaged)) }), { about: "address" });
      return true;
    } catch (error) {
      if (mine !== asked) return false;
      heading = session.state?.scene ?? home;
      throw error;
    }
  }

  /** Steps back to the last event where a later one was asked for, and says whether it was: how many there are is known
   *  only with the trace. */
  function stepBack(): boolean {
    const { state } = session;
    const timeline = session.timeline();
    if (!timeline || !state?.event || state.event < timeline.events.length) return false;
    session.set(goToEvent(state, timeline, timeline.events.length - 1));
    return true;
  }

  return {
    show,
    heading: () => heading,
    /** Stays with the scene that is shown: what was on its way is no longer wanted. */
    stay(id: string) {
      asked++;
      heading = id;
    },
  };
}

export interface SitePage {
  home: string; // the scene the page is for
  onDisk: boolean; // then the page stays, whatever scene it shows
  links: readonly HTMLAnchorElement[]; // data-scene names each one's scene
  withGl: boolean;
}

export function createNavigation(session: Session, { home, onDisk, links, withGl }: SitePage, { loader, bar, notice, loadTrace }: { loader: Loader; bar: AddressBar; notice: Notice; loadTrace: () => Promise<void> }) {
  const ids = links.map((link) => link.dataset.scene!);
  const scenes = createScenes(session, home, loader, notice, loadTrace);

  /** at: a place in its lesson; none: without it. */
  async function open(id: string, at?: Fields) {
    const { state } = session;
    if (state && id === scenes.heading()) return;
    if (id === state?.scene) return scenes.stay(id);
    bar.write("replace"); // what is left behind, before a new entry is made
    try {
      if (await scenes.show(id, at ?? (() => new Map(state && [["tiles", state.tiles]])), state ?? { speed: 1, still: false, gl: withGl })) bar.write("push");
    } catch {
      notice.say(...troubleOfNextScene(links[ids.indexOf(id)], () => void open(id, at)));
    }
  }

  /** A scene's lesson from its start, whatever was shown before; false if the scene cannot be had. */
  async function begin(id: string): Promise<boolean> {
    const { still = false, gl = withGl } = session.state ?? {};
    try {
      if (await scenes.show(id, lessonFrom(1), { speed: 1, still, gl })) bar.write("replace");
      return true;
    } catch {
      return false;
    }
  }

  async function follow() {
    const { fields, scene: named, still, gl } = readAddress(location.hash, location.search);
    const isKnown = named && ids.includes(named);
    try {
      await scenes.show(isKnown ? named : (onDisk ? home : (sceneOfPath(links) ?? home)), () => fields, { speed: 1, still, gl: gl && withGl });
      if (named && !isKnown) notice.say(say("trouble.unknownScene", { id: shortened([named])[0] }), { about: "scene" });
    } catch (error) {
      document.body.classList.remove("live");
      notice.say(...troubleOfScene(error, followPage));
    }
  }

  let ready = Promise.resolve();
  const followPage = () => void (ready = follow());
  window.addEventListener("popstate", followPage);
  window.addEventListener("online", notice.tryAgain);

  return {
    /** The scenes', in the course's order. */
    ids,
    /** What the page's address asks for, now and whenever the person goes back or on. */
    followPage,
    ready: () => ready,
    open,
    begin,
    /** The next or the previous scene, round and round; from lesson to lesson, back to where the other one ended. */
    turn(by: 1 | -1, intoLesson = false) {
      const at = ids.indexOf(scenes.heading());
      void open(ids[(at + by + ids.length) % ids.length], intoLesson ? lessonFrom(by) : undefined);
    },
    ofKey(key: string) {
      const link = links.find((each) => each.dataset.key === key);
      if (link) void open(link.dataset.scene!);
    },
  };
}

function sceneOfPath(links: readonly HTMLAnchorElement[]): string | undefined {
  const path = (href: string) => new URL(href).pathname.replace(/index\.html$/, "");
  return links.find((link) => path(link.href) === path(location.href))?.dataset.scene;
}

/** An address may ask for anything: so much of it is repeated in the sentence. */
const shortened = (keys: readonly string[]): string[] => {
  const short = keys.slice(0, SHOWN_KEYS).map((key) => (key.length > SHOWN_LETTERS ? `${key.slice(0, SHOWN_LETTERS)}\u2026` : key));
  return keys.length > SHOWN_KEYS ? [...short, "\u2026"] : short;
};
