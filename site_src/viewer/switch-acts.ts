/** What if: what sets switches, and with it what recombines the trace. */
import { doingOn } from "./doing";
import type { Session } from "./session";
import { NO_EVENT } from "./state/play";
import { AS_TRACED, lampsOf, type Part, type Switches } from "./state/switches";
import * as switches from "./state/switching";
import { eventLike } from "./state/timeline";
import { setSwitches } from "./state/view-state";
import type { SceneData } from "./trace/types";

export { createWhatIf } from "./state/what-if";

export function createSwitchActs(session: Session) {
  const doing = doingOn(session);
  /** The player stays at its event, where that is still there. */
  const switching = (make: (now: Switches, scene: SceneData) => Switches) => {
    const before = session.currentEvent();
    doing((now, of) => setSwitches(now, make(now.switches, of)));
    const timeline = session.timeline();
    if (!before || !timeline || !session.state) return;
    const event = eventLike(timeline, before);
    if (event !== session.state.event) session.set(event === null ? { ...session.state, ...NO_EVENT } : { ...session.state, event });
  };
  return {
    bounces: (by: 1 | -1) => switching((now, of) => switches.stepBounces(now, of, by)),
    lamp: (lamp: number, factor: number) => switching((now, of) => switches.setLamp(now, of, lamp, factor)),
    stepLamp: (lamp: number, by: 1 | -1) => switching((now, of) => switches.stepLamp(now, of, lamp, by)),
    turnLamp: (lamp: number) => switching((now, of) => (lampsOf(of)[lamp] ? switches.turnLamp(now, of, lamp) : now)),
    shadows: () => switching((now, of) => (of.shadows ? switches.turnShadows(now, of) : now)),
    part: (part: Part) => switching((now, of) => switches.turnPart(now, of, part)),
    asTraced: () => switching(() => AS_TRACED),
  };
}

export type SwitchActs = ReturnType<typeof createSwitchActs>;
