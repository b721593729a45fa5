/** From scene to scene and from grid to grid: what the address asks for is loaded, what is shown is written into it. */
import { createAddressBar } from "./address-bar";
import { createLoader } from "./load";
import type { Notice } from "./panels/notice";
import type { Session } from "./session";
import { isSwitched } from "./state/switches";
import { followAddress, readAddress } from "./state/address";
import * as player from "./state/play";
import type { Kept } from "./state/types";
import type { SceneData } from "./trace/types";
import { troubleOfNextScene, troubleOfScene, troubleOfTrace, type Trouble } from "./trouble";
import { list, say } from "./words";

const ADDRESS_AFTER = 200; // ms of quiet: browsers refuse an address that changes too often
const PATIENCE = 150; // ms before a missing trace shows
const SLOW = 8000; // ms after which it is said that something is still on its way
const TOLD_KEYS = 6; // of an address; more, and longer ones, would only be noise
const TOLD_LETTERS = 16;

type Fields = ReadonlyMap<string, string>;
const firstStep = (scene: SceneData): Fields => new Map(scene.lesson.length ? [["step", "1"]] : []);

export interface Place {
  root: string; // relative path to the site's root
  home: string; // the scene the page is for
  links: readonly HTMLAnchorElement[]; // data-scene names each one's scene
  withGl: boolean;
}

export function createNavigation(session: Session, { root, home, links, withGl }: Place, notice: Notice, draw: () => void) {
  const { body } = document;
  const onDisk = location.protocol === "file:";
  const ids = links.map((link) => link.dataset.scene!);
  const addressBar = createAddressBar({ home, onDisk, links });
  const loader = createLoader(root);
  let sceneAsked = 0; // the newest request; older ones that arrive late, or never, are dropped
  let traceAsked = 0;
  let heading = home; // the scene that is shown, or on its way
  let addressTimer = 0;
  let wanted = ""; // the scene whose boxes have been asked for
  let finest = ""; // the scene whose finest rays have been asked for

  function writeAddress(how: "replace" | "push") {
    clearTimeout(addressTimer);
    if (session.state && session.scene) addressBar.write(how, session.state, session.scene);
  }

  const tell = ({ sentence, more }: Trouble) => notice.say(sentence, more);

  /** Says so if it takes long. */
  async function awaited<T>(what: Promise<T>, about: "scene" | "trace"): Promise<T> {
    const wait = window.setTimeout(() => notice.say(say("trouble.slow"), { about }), SLOW);
    try {
      return await what;
    } finally {
      clearTimeout(wait);
    }
  }

  async function loadTrace() {
    if (!session.state) return;
    const mine = ++traceAsked;
    const { scene: id, n } = session.state;
    const wait = window.setTimeout(draw, PATIENCE); // slow: say so, with an empty frustum
    try {
      const arrived = await awaited(loader.trace(id, n), "trace");
      if (mine !== traceAsked) return;
      session.receive(arrived);
      notice.hide("trace");
    } catch (error) {
      if (mine !== traceAsked) return;
      session.receive(null);
      session.missing = true;
      tell(troubleOfTrace(error, n, () => void loadTrace()));
    } finally {
      clearTimeout(wait);
    }
    session.lit = null;
    session.changed();
  }

  /** The outlines of slices, the first time a slice of this scene is looked at. */
  async function loadSections() {
    const { state } = session;
    if (!state || state.slice === "none" || session.sections?.scene === state.scene) return;
    try {
      const arrived = await loader.sections(state.scene);
      if (session.state?.scene !== state.scene) return;
      session.sections = arrived;
      draw();
    } catch {
      if (session.state?.scene !== state.scene) return;
      session.set({ ...session.state, slice: "none" });
      const { slice } = state;
      notice.say(say("trouble.sliceMissing"), { again: () => session.state && session.set({ ...session.state, slice }) });
    }
  }

  /** What tests are made on, where the tiles show their number: few want it, so it comes when asked for. */
  async function wantBoxes() {
    const { state, scene } = session;
    if (state?.colours !== "tests" || !scene || !Object.keys(scene.meshes).length || wanted === scene.id) return;
    wanted = scene.id;
    try {
      const arrived = await loader.boxes(scene.id);
      if (session.scene !== scene) return;
      session.boxes = arrived;
      draw();
    } catch {
      if (session.scene === scene) notice.say(say("trouble.boxesMissing"), { again: () => ((wanted = ""), void wantBoxes()) });
    }
  }

  /** The scene its address asks for, in this page; false if another one was asked for meanwhile. */
  async function show(id: string, asksFor: Fields | ((scene: SceneData) => Fields), kept: Kept): Promise<boolean> {
    const mine = ++sceneAsked;
    heading = id;
    let arrived: SceneData;
    try {
      arrived = await awaited(loader.scene(id), "scene");
    } catch (error) {
      if (mine !== sceneAsked) return false;
      heading = session.state?.scene ?? home;
      throw error;
    }
    if (mine !== sceneAsked) return false;
    const followed = followAddress(typeof asksFor === "function" ? asksFor(arrived) : asksFor, arrived, kept);
    session.scene = arrived;
    session.state = followed.state;
    session.receive(null);
    session.lit = null;
    notice.leaveScene();
    body.classList.add("live");
    await loadTrace();
    if (mine !== sceneAsked) return false;
    const told = session.timeline();
    if (told && session.state?.event && session.state.event >= told.events.length) {
      followed.damaged.push("e");
      session.set(player.goToEvent(session.state, told, told.events.length - 1));
    }
    if (followed.damaged.length) notice.say(say("trouble.address", { keys: list(shortened(followed.damaged)) }), { about: "address" });
    return true;
  }

  /** lesson: at its first step. */
  async function open(id: string, lesson = false) {
    if (id === heading && session.state) return;
    const kept = session.state ?? { speed: 1, still: false, gl: withGl, tiles: "empty" };
    if (id === session.state?.scene) {
      sceneAsked++; // back to where one still is: what is on its way may come, but is not wanted
      heading = id;
      return;
    }
    writeAddress("replace"); // what is left behind, before a new entry is made
    const fields = new Map(kept.tiles === "empty" ? [] : [["tiles", "filled"]]);
    try {
      if (await show(id, lesson ? firstStep : fields, kept)) writeAddress("push");
    } catch {
      const { title, href } = links[ids.indexOf(id)];
      tell(troubleOfNextScene(title, href, () => void open(id, lesson)));
    }
  }

  /** A scene's lesson from its start, whatever was shown before; false if the scene cannot be had. */
  async function begin(id: string): Promise<boolean> {
    const { still = false, gl = withGl } = session.state ?? {};
    try {
      if (await show(id, firstStep, { speed: 1, still, gl })) writeAddress("replace");
      return true;
    } catch {
      return false;
    }
  }

  function sceneOfPath(): string {
    const path = (href: string) => new URL(href).pathname.replace(/index\.html$/, "");
    return links.find((link) => path(link.href) === path(location.href))?.dataset.scene ?? home;
  }

  async function follow() {
    const { fields, scene: named, still, gl } = readAddress(location.hash, location.search);
    const id = named && ids.includes(named) ? named : onDisk ? home : sceneOfPath();
    try {
      await show(id, fields, { speed: 1, still, gl: gl && withGl });
      if (named && !ids.includes(named)) notice.say(say("trouble.unknownScene", { id: shortened([named])[0] }), { about: "scene" });
    } catch (error) {
      body.classList.remove("live");
      tell(troubleOfScene(error, followPage));
    }
  }

  let ready = Promise.resolve();
  const followPage = () => void (ready = follow());
  window.addEventListener("popstate", followPage);
  window.addEventListener("online", notice.tryAgain);
  window.addEventListener("pagehide", () => writeAddress("replace"));

  return {
    /** What the page's address asks for, now and whenever the person goes back or on. */
    followPage,
    ready: () => ready,
    loadTrace,
    loadSections,
    /** The view's whole address; embedded, that of the page it belongs to. */
    link() {
      writeAddress("replace");
      const whole = new URL(session.state && session.scene ? addressBar.addressOf(session.state, session.scene) : location.href);
      whole.searchParams.delete("embed");
      return whole.href;
    },
    open,
    begin,
    /** The next or the previous scene, round and round. */
    turn(by: 1 | -1, intoLesson = false) {
      const at = ids.indexOf(heading);
      void open(ids[(at + by + ids.length) % ids.length], intoLesson);
    },
    ofKey(key: string) {
      const link = links.find((each) => each.dataset.key === key);
      if (link) void open(link.dataset.scene!);
    },
    /** The finest rays, where switches are set: the picture follows in as many pixels as there are. */
    async wantFinest() {
      const { state, scene } = session;
      if (!state || !scene || !isSwitched(state.switches) || finest === scene.id) return;
      finest = scene.id;
      try {
        session.finest = await loader.trace(scene.id, scene.levels[scene.levels.length - 1]);
        draw();
      } catch {
        // The picture follows in the tiles that are here.
      }
    },
    wantBoxes,
    /** Writes the state into the address when it rests. */
    writeSoon() {
      clearTimeout(addressTimer);
      addressTimer = window.setTimeout(() => writeAddress("replace"), ADDRESS_AFTER);
    },
  };
}

/** What an address asks for may be anything: so much of it is said again. */
const shortened = (keys: readonly string[]): string[] => {
  const short = keys.slice(0, TOLD_KEYS).map((key) => (key.length > TOLD_LETTERS ? `${key.slice(0, TOLD_LETTERS)}\u2026` : key));
  return keys.length > TOLD_KEYS ? [...short, "\u2026"] : short;
};
