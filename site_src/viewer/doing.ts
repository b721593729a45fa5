/** How each act changes the state: what it makes of the present one, and nothing while there is none. */
import type { Session } from "./session";
import type { ViewState } from "./state/types";
import type { SceneData } from "./trace/types";

export type Doing = (act: (now: ViewState, scene: SceneData) => ViewState) => void;

export const doingOn =
  (session: Session): Doing =>
  (act) => {
    const { state } = session;
    const scene = session.here();
    if (state && scene) session.set(act(state, scene));
  };
