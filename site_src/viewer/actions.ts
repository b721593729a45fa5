/** What a person can do, whatever the hand does it with: each act makes the next state out of this one. */
import type { CardLine } from "./panels/card";
import type { Session } from "./session";
import type { RayEvent } from "./state/events";
import { nextLook, withLook, withObserver, type Look } from "./state/look";
import * as player from "./state/play";
import type { Timeline } from "./state/timeline";
import * as change from "./state/view-state";
import type { ViewState } from "./state/view-state";
import type { SceneData } from "./trace/types";

export interface Outside {
  draw: () => void;
  turnScene: (by: 1 | -1, intoLesson?: boolean) => void;
  sceneOfKey: (key: string) => void;
}

export function createActions(session: Session, outside: Outside) {
  const doing = (act: (now: ViewState, scene: SceneData) => ViewState) => {
    const { state, scene } = session;
    if (state && scene) session.set(act(state, scene));
  };
  /** Of the player: without a timeline nothing can be told. */
  const telling = (act: (now: ViewState, told: Timeline) => ViewState) => {
    const told = session.timeline();
    if (session.state && told) session.set(act(session.state, told));
  };

  return {
    render: () => doing((now) => (session.trace() ? change.pressRender(now) : now)),
    speed: () => doing((now) => ({ ...now, speed: change.nextSpeed(now.speed) })),
    rays: (choice: change.RayChoice) => doing((now) => change.toggleRays(now, choice)),
    level: (by: 1 | -1) => doing((now, of) => change.stepLevel(now, of, by)),
    move: (right: number, down: number) => doing((now) => change.move(now, right, down)),
    pick: (column: number, row: number) =>
      doing((now) => (now.pixel[0] === column && now.pixel[1] === row ? now : change.select(now, column, row))),
    observer: (observer: ViewState["observer"]) => doing((now) => withObserver(now, observer)),
    camera: () => doing((now) => ({ ...now, observer: "camera" })),
    look: (look: Look) => doing((now) => withLook(now, look)),
    nextLook: () => doing((now) => withLook(now, nextLook(now))),
    slice: (slice: ViewState["slice"]) => doing((now) => ({ ...now, slice: now.slice === slice ? "none" : slice })),
    nextSlice: () => doing((now) => ({ ...now, slice: change.nextSlice(now.slice) })),
    pickAlong: (along: number) =>
      doing((now) => change.select(now, now.slice === "column" ? now.pixel[0] : along, now.slice === "column" ? along : now.pixel[1])),

    step: (step: number | null) => doing((now, of) => change.goToStep(of, now, step)),
    turn: (by: 1 | -1) => doing((now, of) => change.turnStep(of, now, by)),
    /** As clickers turn pages: through the lesson that is given and on to the next one; else through the scenes. */
    page(by: 1 | -1) {
      const { state, scene } = session;
      if (!state || !scene) return;
      const next = change.turnStep(scene, state, by);
      if (next !== state) session.set(next);
      else if (state.step === null || by > 0) outside.turnScene(by, state.step !== null);
    },

    play: () => telling(player.pressPlay),
    event: (by: 1 | -1) => telling((now, of) => player.stepEvent(now, of, by)),
    time: (seconds: number) => telling((now, of) => player.goToTime({ ...now, playing: false }, of, seconds)),
    /** To the event in which that happens to a ray, its arrival if nothing is named. */
    tell: (ray: number, light: number, ...whats: RayEvent["what"][]) =>
      telling((now, of) => {
        const wanted = whats.length || light >= 0 ? whats : ["meets", "background"];
        const at = of.events.findIndex((event) => event.ray === ray && event.light === light && (!wanted.length || wanted.includes(event.what)));
        return at < 0 ? now : player.goToEvent(now, of, at);
      }),
    endEvents: () => telling((now, of) => (now.event === null ? now : player.goToEvent(now, of, null))),

    light(line: CardLine | null) {
      if (line?.ray === session.lit?.ray && line?.light === session.lit?.light) return;
      session.lit = line;
      outside.draw();
    },

    projector: () => doing((now) => ({ ...now, projector: !now.projector })),

    sceneKey: outside.sceneOfKey,
  };
}

export type Actions = ReturnType<typeof createActions>;
