/** What a stage shows, and what each of its two renderers (WebGL, Canvas2D) can do. */
import type { Projection } from "../state/projection";
import type { Shown } from "../state/shown";
import type { LitLine, Observer, ViewState } from "../state/types";
import type { TilePicture } from "../tile-picture";
import type { SceneData, Trace } from "../trace/types";
import type { Surrounded } from "../state/surrounded";

export interface StageView extends Pick<Shown, "plane" | "tiles" | "costs" | "boxLines" | "chosen" | "thin"> {
  scene: SceneData; // as it was traced
  switched: SceneData; // as the switches make it: its lights and materials
  recombined: TilePicture | null; // the picture with the switches set; null where nothing is switched
  trace: Trace | null; // null while it loads or if it is missing
  state: ViewState;
  lit: LitLine | null;
  surroundings: Surrounded | null; // of mirrors and glass, once they have come
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
  /** The colours have changed: what was made with the old ones goes. */
  forget: () => void;
  /** CSS pixels, and device pixels in each. */
  resize: (width: number, height: number, ratio: number) => void;
  dispose: () => void;
  /** For tests: how many things the graphics card keeps for it. */
  held: () => Readonly<Record<string, number>>;
}
