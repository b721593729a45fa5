/** What a state needs besides its scene: a trace, and what only some states need, which comes when one of them does. */
import type { Loader } from "./load";
import type { OnDemand } from "./on-demand";
import type { Notice } from "./panels/notice";
import type { Session } from "./session";
import { isSwitched } from "./state/switches";
import type { ViewState } from "./state/types";
import { wantsBoxes } from "./state/view-state";
import type { SceneData } from "./trace/types";
import { awaited, troubleOfTrace } from "./trouble";
import { say } from "./words";

const PATIENCE = 150; // ms before a missing trace shows

interface Supply<T> {
  isWanted: (state: ViewState, scene: SceneData) => boolean;
  load: (scene: SceneData) => Promise<T>;
  /** It did not come. again: asks once more. state: that wanted it. */
  missing: (again: () => void, state: ViewState) => void;
}

/** Asked for once while it is wanted; what comes when another scene is shown is dropped. */
function supply<K extends "sections" | "boxes" | "finest" | "surroundings">(session: Session, draw: () => void, name: K, { isWanted, load, missing }: Supply<Session[K]>) {
  let asked = ""; // the scene it was asked for
  return async function ask() {
    const { state, scene } = session;
    if (!state || !scene || session[name]?.scene === scene.of) return;
    if (!isWanted(state, scene)) return void (asked = "");
    if (asked === scene.id) return;
    asked = scene.id;
    try {
      const arrived = await load(scene);
      if (session.scene?.id !== scene.id) return;
      session[name] = arrived;
      draw();
    } catch {
      if (session.scene?.id === scene.id) missing(() => ((asked = ""), void ask()), state);
    }
  };
}

export function createSupplies(session: Session, loader: Loader, onDemand: OnDemand, notice: Notice, draw: () => void) {
  const supplies = [
    supply(session, draw, "sections", {
      isWanted: ({ slice }) => slice !== "none",
      load: ({ of }) => loader.sections(`${of}/sections`), // with what draws it
      missing(_, { slice }) {
        session.set({ ...session.state!, slice: "none" });
        notice.say(say("trouble.sliceMissing"), { again: () => session.set({ ...session.state!, slice }) });
      },
    }),
    // What mirrors and glass have round them; without it they are painted.
    supply(session, draw, "surroundings", {
      isWanted: ({ look, gl }, { files }) => gl && look !== "plain" && "surroundings" in files,
      load: async ({ of }) => (await onDemand.come("surroundings")).createSurroundings(await loader.surroundings(`${of}/surroundings`)),
      missing: () => {},
    }),
    // The boxes that rays are tested against, where the tiles show how many tests there were.
    supply(session, draw, "boxes", {
      isWanted: (state, scene) => wantsBoxes(state, scene) && Object.keys(scene.meshes).length > 0,
      load: ({ of }) => loader.boxes(`${of}/boxes`),
      missing: (again) => notice.say(say("trouble.boxesMissing"), { again }),
    }),
    // Where switches are set the picture is recombined from the finest grid; without that, from the one that is here.
    supply(session, draw, "finest", {
      isWanted: ({ switches }) => isSwitched(switches),
      load: ({ of, levels }) => loader.trace(of, levels.at(-1)!),
      missing: () => {},
    }),
  ];

  let traceAsked = 0; // the newest request; older ones that arrive late, or never, are dropped
  async function trace() {
    const { state, scene } = session;
    if (!state || !scene) return;
    const mine = ++traceAsked;
    const { n, sweep } = state;
    const wait = window.setTimeout(draw, PATIENCE); // slow: say so, with an empty frustum
    try {
      const arrived = await awaited(sweep ? onDemand.come("sweeps").then(({ stopAt }) => stopAt(session, loader, notice)) : loader.trace(scene.of, n), "trace", notice);
      if (mine !== traceAsked) return;
      session.receive(arrived);
      notice.hide("trace");
    } catch (error) {
      if (mine !== traceAsked) return;
      session.receive(null);
      session.missing = true;
      notice.say(...troubleOfTrace(error, n, () => void trace()));
    } finally {
      clearTimeout(wait);
    }
    session.lit = null;
    session.changed();
  }

  return { trace, more: () => supplies.forEach((ask) => void ask()) };
}
