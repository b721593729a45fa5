/** The viewer: one state, one render. Reads as the table of contents of what a person can do. */
import { giveKeysBack, listenToLinks } from "./links";
import { createLoader } from "./load";
import { createAddressBar } from "./address-bar";
import { countsOf, exposeForTests } from "./for-tests";
import { listenToKeys } from "./keys";
import { contrastWith } from "./palette";
import { createCard, type CardLine } from "./panels/card";
import { createControls } from "./panels/controls";
import { element } from "./panels/element";
import { createLegend } from "./panels/legend";
import { createLesson } from "./panels/lesson";
import { createNotice } from "./panels/notice";
import { createPage } from "./panels/page";
import { createPicture } from "./panels/picture";
import { createPlayer } from "./panels/player";
import { createViewPad } from "./panels/view-pad";
import { createStage } from "./stage/stage";
import { followAddress, readAddress } from "./state/address";
import { createBeat } from "./beat";
import { createShown } from "./state/shown";
import * as player from "./state/play";
import type { Timeline } from "./state/timeline";
import * as change from "./state/view-state";
import type { ViewState } from "./state/view-state";
import type { SceneData, Trace } from "./trace/types";
import { troubleOfScene, troubleOfTrace } from "./trouble";
import { TROUBLE } from "./words";

const ADDRESS_AFTER = 200; // ms of quiet: browsers refuse an address that changes too often
const BLINK_UP_TO = 5000; // lines: more would be drawn anew twice a second for one blinking tile
const PATIENCE = 150; // ms before a missing trace shows

function start() {
  const body = document.body;
  const root = body.dataset.root ?? "";
  const home = body.dataset.scene ?? "";
  const onDisk = location.protocol === "file:";
  const find = <E extends HTMLElement>(selector: string) => document.querySelector<E>(selector)!;
  const links = [...document.querySelectorAll<HTMLAnchorElement>("nav.scenes a[data-scene]")];
  const ids = links.map((link) => link.dataset.scene!);

  const addressBar = createAddressBar({ home, onDisk, links });
  const loader = createLoader(root);
  const notice = createNotice(find("#notice"));
  const page = createPage({ root, article: find("#page"), title: find("#title"), links });
  const shown = createShown();
  const reducedMotion = matchMedia("(prefers-reduced-motion: reduce)");

  let state: ViewState | null = null;
  let scene: SceneData | null = null;
  let trace: Trace | null = null;
  let missing = false;
  let lit: CardLine | null = null; // what the pointer is on
  let held = false; // by a test: time moves only when it says so
  let asked = 0; // the newest request for a scene or a trace; older ones that arrive late are dropped
  let addressTimer = 0;
  let simpler = ""; // why the stage is drawn without WebGL, once it is
  let renders = 0;
  let drawn = { scene: "", n: 0, tiles: 0, lines: 0 }; // by the last render

  // ---- what a person can do ----
  const set = (next: ViewState) => {
    if (!state || next === state) return;
    const levelChanged = next.n !== state.n;
    state = next;
    if (levelChanged) void loadTrace();
    else changed();
  };
  const doing = (act: (now: ViewState, scene: SceneData) => ViewState) => state && scene && set(act(state, scene));
  /** Of the selected pixel; null until its rays are here. */
  const timeline = () => (state && scene ? shown.of(state, scene, current()).timeline : null);
  const telling = (act: (now: ViewState, told: Timeline) => ViewState) => {
    const told = timeline();
    if (state && told) set(act(state, told));
  };
  /** The event the player is at. */
  const told = () => (state && state.event !== null ? (timeline()?.events[state.event] ?? null) : null);
  const acts = {
    render: () => doing((now) => (current() ? change.pressRender(now) : now)),
    speed: () => doing((now) => ({ ...now, speed: change.nextSpeed(now.speed) })),
    rays: (choice: change.RayChoice) => doing((now) => change.toggleRays(now, choice)),
    level: (by: 1 | -1) => doing((now, of) => change.stepLevel(now, of, by)),
    move: (right: number, down: number) => doing((now) => change.move(now, right, down)),
    pick: (column: number, row: number) =>
      doing((now) => (now.pixel[0] === column && now.pixel[1] === row ? now : change.select(now, column, row))),
    observer: (observer: ViewState["observer"]) => doing((now) => ({ ...now, observer })),
    step: (step: number | null) => doing((now, of) => change.goToStep(of, now, step)),
    turn: (by: 1 | -1) => doing((now, of) => change.turnStep(of, now, by)),
    play: () => telling(player.pressPlay),
    event: (by: 1 | -1) => telling((now, of) => player.stepEvent(now, of, by)),
    time: (seconds: number) => telling((now, of) => player.goToTime({ ...now, playing: false }, of, seconds)),
    endEvents: () => telling((now, of) => (now.event === null ? now : player.goToEvent(now, of, null))),
    light(line: CardLine | null) {
      if (line?.ray === lit?.ray && line?.light === lit?.light) return;
      lit = line;
      beat.draw();
    },
    scene(by: 1 | -1) {
      const at = ids.indexOf(state?.scene ?? home);
      openScene(ids[(at + by + ids.length) % ids.length]);
    },
    sceneKey(key: string) {
      const link = links.find((each) => each.dataset.key === key);
      if (link) openScene(link.dataset.scene!);
    },
  };

  // ---- the page's parts ----
  const first = readAddress(location.hash, location.search);
  const stage = createStage(
    {
      move: acts.observer,
      pick: acts.pick,
      light: acts.light,
      flat: (why) => {
        simpler = TROUBLE[why];
        notice.say(simpler);
        body.dataset.renderer = "flat";
      },
    },
    first.gl,
    () => document.querySelector(".view-pad"),
  );
  const pad = createViewPad({
    turn: stage.turn,
    shift: stage.shift,
    come: stage.come,
    start: () => acts.observer("start"),
    camera: () => acts.observer("camera"),
  });
  const picture = createPicture(root, { pick: acts.pick, failed: () => notice.say(TROUBLE.pictureMissing) });
  const card = createCard({ move: acts.move, light: acts.light });
  const controls = createControls(acts);
  const legend = createLegend();
  const lesson = createLesson(acts);
  const steps = createPlayer(acts);
  find("#viewer").append(
    element(
      "div",
      "work",
      element("section", "stage", stage.element, legend.element, pad.element),
      lesson.element,
      steps.element,
      controls.element,
    ),
    element("div", "side", picture.element, card.element),
  );
  listenToKeys({ ...acts, camera: () => acts.observer("camera") });
  giveKeysBack(body);
  listenToLinks(document.querySelectorAll<HTMLAnchorElement>("nav.scenes a"), { open: openScene, turn: acts.scene });

  // ---- time ----
  const beat = createBeat({
    draw: render,
    runs: () => !held && (state?.tiles === "filling" || state?.playing === true),
    step: pass,
    blinks: () => !!state && !state.still && !reducedMotion.matches && drawn.lines < BLINK_UP_TO,
  });
  reducedMotion.addEventListener("change", () => beat.draw());

  function pass(seconds: number) {
    if (!state) return;
    const before = state;
    const of = timeline();
    state = change.advance(state, seconds);
    if (of) state = player.advancePlay(state, of, seconds);
    if (state.tiles !== before.tiles || state.event !== before.event || state.playing !== before.playing) changed();
  }

  /** The state has changed: draw it soon, write it into the address when it rests. */
  function changed() {
    beat.draw();
    clearTimeout(addressTimer);
    addressTimer = window.setTimeout(() => writeHash("replace"), ADDRESS_AFTER);
  }

  function writeHash(how: "replace" | "push") {
    clearTimeout(addressTimer);
    if (state && scene) addressBar.write(how, state, scene);
  }

  // ---- loading ----
  async function loadTrace() {
    if (!state) return;
    const mine = ++asked;
    const { scene: id, n } = state;
    const wait = window.setTimeout(() => beat.draw(), PATIENCE); // slow: say so, with an empty frustum
    try {
      const arrived = await loader.trace(id, n);
      if (mine !== asked) return;
      trace = arrived;
      missing = false;
      if (TROUBLE_OF_TRACE.has(notice.text())) notice.hide();
    } catch (error) {
      if (mine !== asked) return;
      trace = null;
      missing = true;
      const sentence = troubleOfTrace(error, n);
      TROUBLE_OF_TRACE.add(sentence);
      notice.say(sentence);
    } finally {
      clearTimeout(wait);
    }
    lit = null;
    changed();
  }

  /** The scene its address asks for, in this page. */
  async function show(id: string, fields: ReadonlyMap<string, string>, kept: Pick<ViewState, "speed" | "still" | "gl">) {
    const mine = ++asked;
    const arrived = await loader.scene(id);
    if (mine !== asked) return;
    const followed = followAddress(fields, arrived, kept);
    scene = arrived;
    state = followed.state;
    trace = null;
    missing = false;
    lit = null;
    notice.hide();
    if (simpler) notice.say(simpler);
    body.classList.add("live");
    await loadTrace();
    const of = timeline();
    if (of && state?.event && state.event >= of.events.length) {
      followed.damaged.push("e");
      set({ ...state, ...player.NOT_TOLD });
    }
    if (followed.damaged.length) notice.say(TROUBLE.address(followed.damaged));
  }

  async function openScene(id: string) {
    if (!state || id === state.scene) return;
    writeHash("replace"); // what is left behind, before a new entry is made
    const kept = state;
    const fields = new Map(kept.tiles === "empty" ? [] : [["tiles", "filled"]]);
    try {
      await show(id, fields, kept);
      writeHash("push");
    } catch {
      // Its own page says everything that is known without its data.
      location.assign(links[ids.indexOf(id)].href);
    }
  }

  async function followPage() {
    const { fields, scene: named, still, gl } = readAddress(location.hash, location.search);
    const id = named && ids.includes(named) ? named : onDisk ? home : sceneOfPath();
    try {
      await show(id, fields, { speed: 1, still, gl: gl && first.gl });
      if (named && !ids.includes(named)) notice.say(TROUBLE.unknownScene(named));
    } catch (error) {
      body.classList.remove("live");
      notice.say(troubleOfScene(error));
    }
  }

  function sceneOfPath(): string {
    const here = location.pathname.replace(/index\.html$/, "");
    return links.find((link) => new URL(link.href).pathname.replace(/index\.html$/, "") === here)?.dataset.scene ?? home;
  }

  /** The trace of what the state shows; null while another one is on its way. */
  const current = () => (trace && trace.scene === state?.scene && trace.n === state.n ? trace : null);

  // ---- one render ----
  function render() {
    if (!state || !scene) return;
    renders++;
    const trace = current();
    const view = shown.of(state, scene, trace);
    const ring = beat.isDark() ? null : contrastWith(view.ringOn);
    const event = told();
    stage.show({ ...view, scene, trace, state, lit: lit ?? event, ring });
    legend.show(view.kinds, view.left);
    picture.show(state, scene, trace);
    card.show(state, scene, trace, missing);
    card.light(lit ?? event, !lit);
    controls.show(state, scene);
    lesson.show(state, scene, event);
    steps.show(state, view.timeline);
    page.show(scene, trace);
    drawn = { scene: scene.id, n: state.n, tiles: trace ? view.tiles : 0, lines: view.thin.length };
  }

  let ready = followPage();
  window.addEventListener("popstate", () => (ready = followPage()));
  window.addEventListener("pagehide", () => writeHash("replace"));
  exposeForTests({
    state: () => state,
    ready: () => ready,
    stats() {
      const bright = lit ?? told();
      const shownNow = state && scene ? shown.of(state, scene, current()) : null;
      return { ...stage.stats(), ...countsOf(shownNow), lit: bright && { ray: bright.ray, light: bright.light }, shown: drawn, renders, notice: notice.text(), tiles: [...(current()?.tiles ?? [])] };
    },
    lesson: () => scene?.lesson.map((step) => step.view) ?? [],
    loseContext: stage.loseContext,
    hold: () => void (held = true),
    advance(seconds: number) {
      pass(seconds);
      render();
    },
  });
}

const TROUBLE_OF_TRACE = new Set<string>();

start();
