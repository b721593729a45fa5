/** What a panel of worked-out numbers is given, and what it can do. */
import type { Drawn } from "../stage/renderer";
import type { View, WorkedData } from "../trace/types";

/** What a maker of a panel gets with each frame. */
export interface Worked {
  drawn: Drawn;
  data: WorkedData;
  view: View; // of the step
  isAsking: boolean; // a question: its answer is not shown yet
  isNew: boolean; // the step was not shown before
}

export interface WorkedPanel {
  element: HTMLElement;
  /** False where there is nothing of the selected pixel. Draws on the stage into `lines`. */
  show: (worked: Worked, lines: SVGElement) => boolean;
}
