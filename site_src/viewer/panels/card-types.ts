/** What the card's views have in common. */
import type { Actions } from "../actions";
import type { RayEvent } from "../state/event-types";
import type { RayRow } from "../state/ray-rows";
import type { LitLine } from "../state/types";
import type { SceneData, Trace } from "../trace/types";

/** What the card is about. */
export interface PixelRays {
  rows: readonly RayRow[];
  scene: SceneData;
  trace: Trace;
  pixel: number; // index into the trace
}

/** A pixel's rays as shares of its colour, as a list, a tree, a sum or code. */
export interface RaysView {
  element: HTMLElement;
  show: (of: PixelRays) => void;
  /** Marks what belongs to the line that is lit up on the stage, or else to the current event, and scrolls to it. */
  light: (line: LitLine | null, event: RayEvent | null) => void;
}

export type LineActs = Pick<Actions, "light" | "goToEvent">;
