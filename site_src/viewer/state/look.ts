/** How the stage shows the scene: what a graphics card draws by itself, or what the rays found. */
import type { MaterialData, SceneData } from "../trace/types";
import type { ViewState } from "./types";

export type Look = ViewState["look"];
export const LOOKS: readonly Look[] = ["plain", "approximate", "traced"];

/** Shares from which on a surface is seen as a mirror, or as something to look through, as trace/surroundings.py has them. */
export const isMirror = ({ reflect }: Pick<MaterialData, "reflect">): boolean => reflect > 0.5;
export const isClear = ({ transmit }: Pick<MaterialData, "transmit">): boolean => transmit > 0.3;

const MANY = 1000; // objects from which on no shadow is drawn: each of a light's six sides would draw all

/** Does the approximate look draw shadows? */
export const drawsShadows = ({ shadows, objects }: Pick<SceneData, "shadows" | "objects">): boolean => shadows && objects.length < MANY;

/** The traced picture stands where the tiles stand: it is the scene only from the ray-tracing camera. */
export function withLook(state: ViewState, look: Look): ViewState {
  if (look === state.look) return { ...state, slice: "none" };
  const next = { ...state, look, wipe: 0, slice: "none" as const };
  if (look === "traced") return { ...next, observer: "camera", before: state.observer };
  return { ...next, observer: state.before ?? state.observer, before: null };
}

export const nextLook = ({ look }: ViewState): Look => LOOKS[(LOOKS.indexOf(look) + 1) % LOOKS.length];

/** From anywhere else than the ray-tracing camera the stage is rasterised again. */
export const withObserver = (state: ViewState, observer: ViewState["observer"]): ViewState => ({
  ...state,
  observer,
  before: observer === "camera" ? state.before : null, // the person has gone elsewhere
  wipe: observer === "camera" ? state.wipe : 0,
  look: state.look === "traced" && observer !== "camera" ? "approximate" : state.look,
});
