/** All that a person can do, by whatever means: each act makes the next state out of this one. */
import type { Session } from "./session";
import { TILE_VIEWS, type TileView } from "./state/tile-views";
import type { RayEvent } from "./state/event-types";
import { nextLook, withLook, withObserver, type Look } from "./state/look";
import * as player from "./state/play";
import type { Timeline } from "./state/timeline";
import * as change from "./state/view-state";
import type { LitLine, Tab, ViewState } from "./state/types";
import { doingOn, type Doing } from "./doing";
import type { SwitchActs } from "./switch-acts";

export interface Outside {
  draw: () => void;
  turnScene: (by: 1 | -1, intoLesson?: boolean) => void;
  sceneOfKey: (key: string) => void;
  /** Acts on the switches as soon as their part is there. */
  switching: (act: (acts: SwitchActs) => void) => void;
}

const tileActs = (session: Session, doing: Doing) => ({
  render: () => doing((now) => (session.trace() ? change.pressRender(now) : now)),
  speed: () => doing((now) => ({ ...now, speed: change.nextSpeed(now.speed) })),
  rays: (choice: change.RayChoice) => doing((now) => change.toggleRays(now, choice)),
  level: (by: 1 | -1) => doing((now, of) => change.stepLevel(now, of, by)),
  move: (right: number, down: number) => doing((now) => change.move(now, right, down)),
  pick: (column: number, row: number) => doing((now) => (now.pixel[0] === column && now.pixel[1] === row ? now : change.select(now, column, row))),
  pickAlong: (along: number) => doing((now) => change.select(now, now.slice === "column" ? now.pixel[0] : along, now.slice === "column" ? along : now.pixel[1])),
  colours: (view: TileView) => doing((now) => change.setColours(now, view)),
  nextColours: () => doing((now) => change.setColours(now, TILE_VIEWS[(TILE_VIEWS.indexOf(now.colours) + 1) % TILE_VIEWS.length])),
});

const viewActs = (doing: Doing) => ({
  observer: (observer: ViewState["observer"]) => doing((now) => withObserver(now, observer)),
  camera: () => doing((now) => ({ ...now, observer: "camera" })),
  look: (look: Look) => doing((now) => withLook(now, look)),
  wipe: (wipe: number) => doing((now) => ({ ...now, wipe })),
  nextLook: () => doing((now) => withLook(now, nextLook(now))),
  slice: (slice: ViewState["slice"]) => doing((now) => ({ ...now, slice: now.slice === slice ? "none" : slice })),
  nextSlice: () => doing((now) => ({ ...now, slice: change.nextSlice(now.slice) })),
  /** Chosen again, a tab closes. */
  tab: (tab: Tab) => doing((now) => ({ ...now, tab: now.tab === tab ? "none" : tab })),
  projector: () => doing((now) => ({ ...now, projector: !now.projector })),
});

const lessonActs = (session: Session, doing: Doing, turnScene: Outside["turnScene"]) => ({
  step: (step: number | null) => doing((now, of) => change.goToStep(of, now, step)),
  turn: (by: 1 | -1) => doing((now, of) => change.turnStep(of, now, by)),
  /** As a clicker turns pages, which has no other keys: into the lesson, through it and on to the next one; back without a
   *  lesson, through the scenes. */
  page(by: 1 | -1) {
    const { state, scene } = session;
    if (!state || !scene) return;
    const next = state.step === null && by > 0 ? change.goToStep(scene, state, 0) : change.turnStep(scene, state, by);
    if (next !== state) session.set(next);
    else turnScene(by, state.step !== null);
  },
});

function playerActs(session: Session) {
  /** Nothing without a timeline. */
  const playing = (act: (now: ViewState, timeline: Timeline) => ViewState) => {
    const timeline = session.timeline();
    if (session.state && timeline) session.set(act(session.state, timeline));
  };
  return {
    play: () => playing(player.pressPlay),
    event: (by: 1 | -1) => playing((now, of) => player.stepEvent(now, of, by)),
    time: (seconds: number) => playing((now, of) => player.goToTime({ ...now, playing: false }, of, seconds)),
    /** To the event in which that happens to a ray, its arrival if nothing is named. */
    goToEvent: (ray: number, light: number, ...whats: RayEvent["what"][]) =>
      playing((now, of) => {
        const wanted = whats.length || light >= 0 ? whats : ["meets", "background"];
        const at = of.events.findIndex((event) => event.ray === ray && event.light === light && (!wanted.length || wanted.includes(event.what)));
        return at < 0 ? now : player.goToEvent(now, of, at);
      }),
    endEvents: () => playing((now, of) => (now.event === null ? now : player.goToEvent(now, of, null))),
  };
}

/** What the pointer is on: no state of the page, only drawn. */
const pointerActs = (session: Session, draw: () => void) => ({
  point(tile: readonly [number, number] | null) {
    if (tile?.join() === session.pointed?.join()) return;
    session.pointed = tile;
    if (session.state?.colours !== "picture") draw();
  },
  light(line: LitLine | null) {
    if (line?.ray === session.lit?.ray && line?.light === session.lit?.light) return;
    session.lit = line;
    draw();
  },
});

const SWITCHING = ["bounces", "lamp", "stepLamp", "turnLamp", "shadows", "part", "asTraced"] as const satisfies readonly (keyof SwitchActs)[];

const switchActs = (switching: Outside["switching"]) =>
  Object.fromEntries(SWITCHING.map((name) => [name, (...of: never[]) => switching((acts) => (acts[name] as (...of: never[]) => void)(...of))])) as unknown as SwitchActs;

export function createActions(session: Session, { draw, turnScene, sceneOfKey, switching }: Outside) {
  const doing = doingOn(session);
  return {
    ...tileActs(session, doing),
    ...viewActs(doing),
    ...lessonActs(session, doing, turnScene),
    ...playerActs(session),
    ...switchActs(switching),
    ...pointerActs(session, draw),
    sceneKey: sceneOfKey,
  };
}

export type Actions = ReturnType<typeof createActions>;
