/** The stage: a drawing, the labels over it, and what the hand does on it. */
import type { Actions } from "../actions";
import { element, named } from "../element";
import { onPlane } from "../state/frustum";
import { observerOf, orbit, pan, zoom, type Moves, type ObserverChoice } from "../state/observer";
import { createProjection } from "../state/projection";
import type { Observer } from "../state/types";
import { along, length } from "../state/vectors";
import { say } from "../words";
import { createDrawing, type DrawingActs } from "./drawing";
import { listenToGestures } from "./gestures";
import { clearOf } from "./clear";
import { createLabels, type Label } from "./labels";
import type { Box } from "../state/outlines";
import type { Drawn, StageView } from "./renderer";
import { namesOf } from "./stage-names";
import type { TracedPicture } from "./traced-picture";
import { lineUnder, nearestTile, tileUnder } from "./under";

export interface StageActs extends Pick<DrawingActs, "flat" | "flatRenderer">, Pick<Actions, "pick" | "light" | "point"> {
  move: (observer: ObserverChoice) => void;
  /** What lies over the drawing in the traced look; null until its part has come, and then `come` is called. */
  scrolled: () => void;
  traced: (isWanted: boolean, come: () => void) => TracedPicture | null;
  /** With what a lesson's step points at, and its names. */
  marked: (drawn: Drawn, labels: Label[], come: () => void) => Label[];
}

const ORBIT_DEGREES = 0.35; // a pixel of dragging

/** over: what stands on the stage and must not hide a label. */
export function createStage(acts: StageActs, withGl: boolean, over: () => readonly Element[]) {
  const labels = createLabels();
  const root = named(element("div", "stage-view", labels.element), say("stage.label"), "application");
  root.tabIndex = 0;
  let size = { width: 1, height: 1 };
  let drawn: Drawn | null = null;
  let frames = 0;
  const drawing = createDrawing(root, withGl, { ...acts, replaced: () => measure() });
  new ResizeObserver(() => measure()).observe(root);

  /** ratio: device pixels in each of the stage's. */
  function measure(ratio = Math.min(2, window.devicePixelRatio)) {
    size = { width: Math.max(1, root.clientWidth), height: Math.max(1, root.clientHeight) };
    drawing.renderer().resize(size.width, size.height, ratio);
    redraw();
  }

  const observerFor = (choice: ObserverChoice, { scene, switched, plane }: StageView) => observerOf(choice, { ...scene, camera: switched.camera }, plane, size.width / size.height);

  function draw(view: StageView) {
    const { switched, plane, state, recombined } = view;
    const observer = observerFor(state.observer, view);
    const projection = createProjection(observer, size.width, size.height);
    drawn = { view, observer, projection };
    drawing.renderer().draw(drawn);
    const seen = state.look === "traced" && state.observer === "camera";
    acts.traced(seen, redraw)?.show(seen ? switched : null, plane, projection, recombined, state.wipe);
    labels.show(acts.marked(drawn, namesOf(drawn), redraw), size.width, size.height, clearOf(drawn, takenOn(root, over())), state.projector ? parseFloat(getComputedStyle(labels.element).fontSize) / 14 : 1);
    frames++;
  }
  const redraw = () => drawn && draw(drawn.view);

  /** Known at once: two moves may come before the next drawing. */
  function move(next: (from: Observer, radius: number) => ObserverChoice) {
    if (!drawn) return;
    const choice = next(drawn.observer, drawn.view.scene.bounds.radius);
    if (typeof choice !== "string" && !Number.isFinite(length(choice.eye) + length(choice.target))) return; // nowhere
    drawn = { ...drawn, observer: observerFor(choice, drawn.view) };
    acts.move(choice);
  }
  const moves: Moves = {
    turn: (right, up) => move((from) => orbit(from, right, up)),
    shift: (right, up) => move((from) => pan(from, right, up)),
    come: (factor) => move((from, radius) => zoom(from, factor, radius)),
  };
  listenToHand(root, () => drawn, acts, moves);

  return {
    element: root,
    show: draw,
    drawn: () => drawn,
    ...moves,
    /** Colours are others now. */
    recolour: () => drawing.renderer().forget(),
    /** The drawing with so many device pixels in each of the stage's, as many as the screen has if none are named: drawn this
     *  moment, as later the browser may have cleared it, and so from now on. */
    redrawn(ratio?: number) {
      measure(ratio);
      return drawing.renderer().canvas;
    },
    /** For tests. */
    stats: () => ({ frames, renderer: drawing.renderer().isFlat ? "flat" : "webgl", ...size, gpu: drawing.renderer().held(), ...placesOf(drawn) }),
    /** For tests: as if the driver took the context away. */
    loseContext: () => drawing.renderer().canvas.getContext("webgl2")?.getExtension("WEBGL_lose_context")?.loseContext(),
  };
}

export type Stage = ReturnType<typeof createStage>;

/** What the hand does: on the tiles it selects, elsewhere it moves the observer; what it only points at lights up. */
function listenToHand(stage: HTMLElement, now: () => Drawn | null, acts: StageActs, { turn, shift, come }: Moves) {
  const under = <T>(find: (drawn: Drawn, x: number, y: number) => T, x: number, y: number): T | null => {
    const drawn = now();
    return drawn && find(drawn, x, y);
  };
  const shorter = () => Math.max(1, Math.min(stage.clientWidth, stage.clientHeight)); // a hidden stage has no size
  listenToGestures(stage, {
    isOnTiles: (x, y) => under(tileUnder, x, y) !== null,
    pick(x, y) {
      const tile = under(nearestTile, x, y);
      if (tile) acts.pick(...tile);
    },
    hover(x, y) {
      const tile = under(tileUnder, x, y);
      acts.point(tile);
      stage.classList.toggle("on-tiles", !!tile);
      acts.light(tile ? null : under(lineUnder, x, y));
    },
    leave() {
      acts.light(null);
      acts.point(null);
    },
    orbit: (dx, dy) => turn(-dx * ORBIT_DEGREES, dy * ORBIT_DEGREES),
    pan: (dx, dy) => shift(-dx / shorter(), dy / shorter()),
    zoom: come,
    scrolled: acts.scrolled,
  });
}

/** What stands on the stage at this moment: panels open and close. */
function takenOn(stage: HTMLElement, over: readonly Element[]): Box[] {
  const at = stage.getBoundingClientRect();
  const boxes = over.map((each) => each.getBoundingClientRect());
  return boxes.map(({ left, right, top, bottom }) => ({ left: left - at.left, right: right - at.left, top: top - at.top, bottom: bottom - at.top }));
}

/** For tests: from where it is drawn, and where on the stage is what. */
const placesOf = (drawn: Drawn | null) => ({
  ...drawn?.observer,
  /** Near the end of the k-th of the selected pixel's lines. */
  onLine: (k: number) => drawn!.projection.project(along(drawn!.view.chosen[k].from, drawn!.view.chosen[k].to, 0.8)),
  /** A tile's middle. */
  tile: (column: number, row: number) => drawn!.projection.project(onPlane(drawn!.view.plane, column + 0.5, row + 0.5, drawn!.view.state.n)),
});
