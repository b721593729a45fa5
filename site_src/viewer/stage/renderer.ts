/** What a stage shows, and what each of its two renderers (WebGL, Canvas2D) can do. */
import type { BoxLines } from "../state/box-lines";
import type { Costs } from "../state/costs";
import type { PicturePlane } from "../state/frustum";
import type { Line } from "../state/lines";
import type { LitLine, Observer, ViewState } from "../state/types";
import type { Projection } from "../state/projection";
import type { TilePicture } from "../tile-picture";
import type { SceneData, Trace } from "../trace/types";

export interface StageView {
  scene: SceneData; // as it was traced
  switched: SceneData; // as the switches make it: its lights and materials
  recombined: TilePicture | null; // the picture with the switches set; null where nothing is switched
  plane: PicturePlane;
  trace: Trace | null; // null while it loads or if it is missing
  state: ViewState;
  tiles: number; // filled, in scan order
  costs: Costs | null; // their colours
  boxLines: BoxLines;
  chosen: readonly Line[]; // of the selected pixel, or of the one being rendered
  thin: readonly Line[]; // of a row, a column or all
  lit: LitLine | null;
  ring: string | null; // outline of the selected tile; null while it blinks off
}

/** What is drawn just now, and from where. */
export interface Drawn {
  view: StageView;
  observer: Observer;
  projection: Projection; // CSS pixels
}

export interface StageRenderer {
  canvas: HTMLCanvasElement;
  isFlat: boolean;
  draw: (now: Drawn) => void;
  /** Colours are others now: what was made with the old ones goes. */
  forget: () => void;
  /** CSS pixels, and device pixels in each. */
  resize: (width: number, height: number, ratio: number) => void;
  dispose: () => void;
  /** For tests: how many things the graphics card keeps for it. */
  held: () => Readonly<Record<string, number>>;
}
