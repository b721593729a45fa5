/** From scene to scene and from grid to grid: what the address asks for is loaded, what is shown is written into it. */
import { createAddressBar } from "./address-bar";
import { createLoader } from "./load";
import type { Session } from "./session";
import { followAddress, readAddress } from "./state/address";
import * as player from "./state/play";
import type { Kept } from "./state/view-state";
import { troubleOfScene, troubleOfTrace } from "./trouble";
import { list, say } from "./words";

const ADDRESS_AFTER = 200; // ms of quiet: browsers refuse an address that changes too often
const PATIENCE = 150; // ms before a missing trace shows

export interface Place {
  root: string; // relative path to the site's root
  home: string; // the scene the page is for
  links: readonly HTMLAnchorElement[]; // data-scene names each one's scene
  withGl: boolean;
}

export interface Notice {
  say: (sentence: string) => void;
  hide: () => void;
  text: () => string;
  lasting: () => string; // what stays true in another scene, or ""
}

export function createNavigation(session: Session, { root, home, links, withGl }: Place, notice: Notice, draw: () => void) {
  const { body } = document;
  const onDisk = location.protocol === "file:";
  const ids = links.map((link) => link.dataset.scene!);
  const addressBar = createAddressBar({ home, onDisk, links });
  const loader = createLoader(root);
  const troublesOfTraces = new Set<string>();
  let asked = 0; // the newest request for a scene or a trace; older ones that arrive late are dropped
  let addressTimer = 0;
  let wanted = ""; // the scene whose boxes have been asked for

  function writeAddress(how: "replace" | "push") {
    clearTimeout(addressTimer);
    if (session.state && session.scene) addressBar.write(how, session.state, session.scene);
  }

  async function loadTrace() {
    if (!session.state) return;
    const mine = ++asked;
    const { scene: id, n } = session.state;
    const wait = window.setTimeout(draw, PATIENCE); // slow: say so, with an empty frustum
    try {
      const arrived = await loader.trace(id, n);
      if (mine !== asked) return;
      session.receive(arrived);
      if (troublesOfTraces.has(notice.text())) notice.hide();
    } catch (error) {
      if (mine !== asked) return;
      session.receive(null);
      session.missing = true;
      const sentence = troubleOfTrace(error, n);
      troublesOfTraces.add(sentence);
      notice.say(sentence);
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
      notice.say(say("trouble.sliceMissing"));
    }
  }

  /** The scene its address asks for, in this page. */
  async function show(id: string, fields: ReadonlyMap<string, string>, kept: Kept) {
    const mine = ++asked;
    const arrived = await loader.scene(id);
    if (mine !== asked) return;
    const followed = followAddress(fields, arrived, kept);
    session.scene = arrived;
    session.state = followed.state;
    session.receive(null);
    session.lit = null;
    notice.hide();
    if (notice.lasting()) notice.say(notice.lasting());
    body.classList.add("live");
    await loadTrace();
    const told = session.timeline();
    if (told && session.state?.event && session.state.event >= told.events.length) {
      followed.damaged.push("e");
      session.set({ ...session.state, ...player.NOT_TOLD });
    }
    if (followed.damaged.length) notice.say(say("trouble.address", { keys: list(followed.damaged) }));
  }

  /** lesson: at its first step. */
  async function open(id: string, lesson = false) {
    const kept = session.state;
    if (!kept || id === kept.scene) return;
    writeAddress("replace"); // what is left behind, before a new entry is made
    const fields = new Map(lesson ? [["step", "1"]] : kept.tiles === "empty" ? [] : [["tiles", "filled"]]);
    try {
      await show(id, fields, kept);
      writeAddress("push");
    } catch {
      // Its own page says everything that is known without its data.
      location.assign(links[ids.indexOf(id)].href);
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
      if (named && !ids.includes(named)) notice.say(say("trouble.unknownScene", { id: named }));
    } catch (error) {
      body.classList.remove("live");
      notice.say(troubleOfScene(error));
    }
  }

  let ready = Promise.resolve();
  const followPage = () => void (ready = follow());
  window.addEventListener("popstate", followPage);
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
      const whole = new URL(location.href);
      whole.searchParams.delete("embed");
      return whole.href;
    },
    open,
    /** The next or the previous scene, round and round. */
    turn(by: 1 | -1, intoLesson = false) {
      const at = ids.indexOf(session.state?.scene ?? home);
      void open(ids[(at + by + ids.length) % ids.length], intoLesson);
    },
    ofKey(key: string) {
      const link = links.find((each) => each.dataset.key === key);
      if (link) void open(link.dataset.scene!);
    },
    /** What tests are made on, where the tiles show their number: few want it, so it comes when asked for. */
    async wantBoxes() {
      const { state, scene } = session;
      if (state?.colours !== "tests" || !scene || !Object.keys(scene.meshes).length || wanted === scene.id) return;
      wanted = scene.id;
      try {
        session.boxes = await loader.boxes(scene.id);
        draw();
      } catch {
        notice.say(say("trouble.boxesMissing"));
      }
    },
    /** Writes the state into the address when it rests. */
    writeSoon() {
      clearTimeout(addressTimer);
      addressTimer = window.setTimeout(() => writeAddress("replace"), ADDRESS_AFTER);
    },
  };
}
