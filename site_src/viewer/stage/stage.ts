/** The stage: a renderer, the labels over it, and what the hand does on it. */
import { onPlane } from "../state/frustum";
import { createProjection, type Projection } from "../state/projection";
import { observerOf, orbit, pan, zoom, type ObserverChoice } from "../state/observer";
import type { LitLine, Observer } from "../state/types";
import { along, length, sub, triple } from "../state/vectors";
import { say, vector } from "../words";
import { createFlatRenderer } from "./flat";
import { listenToGestures } from "./gestures";
import { createLabels, type Box, type Label } from "./labels";
import type { Line } from "../state/lines";
import type { Trace } from "../trace/types";
import type { StageRenderer, StageView } from "./renderer";
import { createTracedPicture } from "./traced-picture";
import { slideSvg } from "./slide";
import { createWebglRenderer } from "./webgl";

export interface StageActs {
  move: (observer: ObserverChoice) => void;
  pick: (column: number, row: number) => void;
  light: (line: LitLine | null) => void;
  /** The tile under the pointer. */
  point: (tile: readonly [number, number] | null) => void;
  /** WebGL is refused or was lost, and the flat renderer has taken over; null: WebGL is back. */
  flat: (why: "refused" | "lost" | null) => void;
}

const ORBIT_DEGREES = 0.35; // a pixel of dragging
const RECOVER_AFTER = 1000; // ms: the driver needs a moment
const RECOVERIES = 2; // a graphics card that goes on dropping drawings is left alone
const NEAR_A_LINE = 9; // pixels
const BLOCKERS = 3; // named at most
const STROKES_OF = 40; // lines: with more, no label finds a clear place

/** root: relative path to the site's root. over: what stands on the stage and must not hide a label. */
export function createStage(acts: StageActs, root: string, withGl: boolean, over: () => readonly Element[]) {
  const element = document.createElement("div");
  element.className = "stage-view";
  element.tabIndex = 0;
  element.setAttribute("role", "application");
  element.setAttribute("aria-label", say("stage.label"));
  const labels = createLabels();
  const traced = createTracedPicture(root);
  let view: StageView | null = null;
  let observer: Observer | null = null;
  let projection: Projection | null = null;
  let size = { width: 1, height: 1 };
  let frames = 0;

  let renderer: StageRenderer = (withGl && createWebglRenderer(fallBack)) || createFlatRenderer();
  let isFlat = !withGl || renderer.canvas.dataset.flat === "yes";
  if (withGl && isFlat) queueMicrotask(() => acts.flat("refused"));
  element.append(renderer.canvas, traced.element, labels.element);

  let losses = 0;
  function replaceBy(other: StageRenderer, flat: boolean) {
    renderer.dispose();
    renderer.canvas.remove();
    renderer = other;
    isFlat = flat;
    element.prepend(renderer.canvas);
    measure();
  }
  function fallBack() {
    replaceBy(createFlatRenderer(), true);
    acts.flat("lost");
    if (++losses <= RECOVERIES) setTimeout(recover, RECOVER_AFTER);
  }
  function recover() {
    const anew = createWebglRenderer(fallBack);
    if (!anew) return;
    replaceBy(anew, false);
    acts.flat(null);
  }

  /** What stands on the stage at this moment: panels open and close. */
  function taken(): Box[] {
    const stage = element.getBoundingClientRect();
    const boxes = [...over()].map((each) => each.getBoundingClientRect());
    return boxes.map(({ left, right, top, bottom }) => ({ left: left - stage.left, right: right - stage.left, top: top - stage.top, bottom: bottom - stage.top }));
  }

  function measure() {
    size = { width: Math.max(1, element.clientWidth), height: Math.max(1, element.clientHeight) };
    renderer.resize(size.width, size.height, Math.min(2, window.devicePixelRatio));
    draw();
  }

  function labelsOf({ scene, switched, trace, chosen, state }: StageView): Label[] {
    const label = (key: string, text: string, at: readonly [number, number, number], kind: Label["kind"]): Label[] => {
      const seen = projection!.project(at);
      const inside = seen.depth > 0 && seen.x > 0 && seen.y > 0 && seen.x < size.width && seen.y < size.height;
      return inside ? [{ key, text, x: seen.x, y: seen.y, kind }] : [];
    };
    if (state.observer === "camera" && (view!.tiles > 0 || state.look === "traced")) return []; // the tiles hide what they would name
    const first = chosen.find((line) => line.light < 0);
    const lit = view!.lit ? view!.lit.ray : first?.ray;
    const arrived = chosen.some((line) => line.ray === lit && line.light < 0 && !line.growing);
    const hit = trace && lit !== undefined && arrived && state.tiles !== "filling" && trace.object[lit] >= 0 ? triple(trace.point, lit) : null;
    return [
      ...(hit ? label("hit", vector(hit), hit, "hit") : []),
      ...blockersOf(chosen, trace).flatMap(({ line, by }) => label(`stop ${line.ray} ${line.light}`, say("stage.blocked", { name: scene.objects[by].name }), line.to, "stop")),
      ...(state.observer === "camera" ? [] : label("camera", say("stage.camera"), scene.camera.eye, "sign").map((each) => ({ ...each, below: true }))),
      ...scene.lights.flatMap(({ name, position }, k) => label(`light ${name}`, switched.lights[k].intensity > 0 ? name : say("stage.off", { light: name }), position, "sign")),
    ];
  }

  /** Where shadow rays end too early, and at what: of the ray that is told, else of the first few. */
  function blockersOf(chosen: readonly Line[], trace: Trace | null) {
    const ended = trace ? chosen.filter((line) => line.kind === "blocked" && !line.growing) : [];
    const told = ended.filter((line) => line.ray === view!.lit?.ray);
    return (told.length ? told : ended).slice(0, BLOCKERS).flatMap((line) => {
      const by = trace!.blocker[line.ray * trace!.lights + line.light];
      return by < 0 ? [] : [{ line, by }];
    });
  }

  /** Places every few pixels along the chosen lines, for labels to keep clear of. */
  function strokesOf(lines: readonly Line[]): number[] {
    const strokes: number[] = [];
    for (const { from, to } of lines.slice(0, STROKES_OF)) {
      const [a, b] = [projection!.project(from), projection!.project(to)];
      if (a.depth <= 0 || b.depth <= 0) continue;
      const steps = Math.min(300, Math.ceil(Math.hypot(b.x - a.x, b.y - a.y) / 6));
      for (let k = 0; k <= steps; k++) strokes.push(a.x + (k / steps) * (b.x - a.x), a.y + (k / steps) * (b.y - a.y));
    }
    return strokes;
  }

  function draw() {
    if (!view) return;
    observer = observerOf(view.state.observer, view.scene, view.plane, size.width / size.height);
    projection = createProjection(observer, size.width, size.height);
    renderer.draw(view, observer, projection);
    traced.show(view.state.look === "traced" && view.state.observer === "camera" ? view.scene : null, view.plane, projection, view.recombined);
    labels.show(labelsOf(view), size.width, size.height, taken(), strokesOf(view.chosen), view.state.projector);
    frames++;
  }

  function tileAt(x: number, y: number): readonly [number, number] | null {
    const share = view && projection!.onPicturePlane(view.plane, x, y);
    if (!share) return null;
    const at = share.map((s) => Math.floor(s * view!.state.n));
    return [at[0], at[1]];
  }
  const isTile = (tile: readonly [number, number] | null) => !!tile && tile.every((k) => k >= 0 && k < view!.state.n);

  /** The selected pixel's line nearest to a place on the stage, measured on the screen. */
  function lineAt(x: number, y: number): LitLine | null {
    let nearest = NEAR_A_LINE;
    let found: LitLine | null = null;
    for (const line of view?.chosen ?? []) {
      const [a, b] = [projection!.project(line.from), projection!.project(line.to)];
      if (a.depth <= 0 || b.depth <= 0) continue;
      const [dx, dy] = [b.x - a.x, b.y - a.y];
      const share = Math.max(0, Math.min(1, ((x - a.x) * dx + (y - a.y) * dy) / (dx * dx + dy * dy || 1)));
      const away = Math.hypot(a.x + share * dx - x, a.y + share * dy - y);
      if (away < nearest) [nearest, found] = [away, { ray: line.ray, light: line.light }];
    }
    return found;
  }

  const shorter = () => Math.min(size.width, size.height);
  /** Known at once: two moves may come before the next drawing. */
  function go(choice: ObserverChoice) {
    observer = observerOf(choice, view!.scene, view!.plane, size.width / size.height);
    acts.move(choice);
  }
  const turn = (right: number, up: number) => observer && go(orbit(observer, right, up));
  const shift = (right: number, up: number) => observer && go(pan(observer, right, up));
  const come = (factor: number) => observer && go(zoom(observer, factor, view!.scene.bounds.radius));
  const gestures = listenToGestures(element, {
    isOnTiles: (x, y) => isTile(tileAt(x, y)),
    pick(x, y) {
      const tile = tileAt(x, y);
      const within = (k: number) => Math.max(0, Math.min(view!.state.n - 1, k));
      if (tile) acts.pick(within(tile[0]), within(tile[1]));
    },
    hover(x, y) {
      const tile = tileAt(x, y);
      const onTile = isTile(tile);
      acts.point(onTile ? tile : null);
      element.classList.toggle("on-tiles", onTile);
      acts.light(onTile ? null : lineAt(x, y));
    },
    leave() {
      acts.light(null);
      acts.point(null);
    },
    orbit: (dx, dy) => turn(-dx * ORBIT_DEGREES, dy * ORBIT_DEGREES),
    pan: (dx, dy) => shift(-dx / shorter(), dy / shorter()),
    zoom: come,
  });
  const watcher = new ResizeObserver(measure);
  watcher.observe(element);

  return {
    element,
    show(next: StageView) {
      view = next;
      draw();
    },
    /** Degrees; shares of the stage; a factor on the distance. */
    turn,
    shift,
    come,
    /** Colours are others now. */
    recolour: () => renderer.forget(),
    /** The drawing, drawn this moment: later the browser may have cleared it. */
    redrawn() {
      draw();
      return renderer.canvas;
    },
    /** The view as an SVG with a line under it; null before there is anything. */
    slide(caption: string): string | null {
      if (!view || !observer || !projection) return null;
      renderer.draw({ ...view, chosen: [], lit: null }, observer, projection);
      const picture = renderer.canvas.toDataURL(); // at once: later the browser may have cleared it
      draw();
      return slideSvg(picture, view.chosen, labels.element, caption, projection, view.scene.bounds.radius / 300);
    },
    /** For tests: what is drawn where. */
    stats: () => ({
      frames,
      renderer: isFlat ? "flat" : "webgl",
      width: size.width,
      height: size.height,
      eye: observer?.eye ?? null,
      target: observer?.target ?? null,
      gpu: renderer.held(),
      reach: observer ? length(sub(observer.eye, observer.target)) : 0,
      /** Stage pixel near the end of the k-th of the selected pixel's lines. */
      onLine: (k: number) => projection!.project(along(view!.chosen[k].from, view!.chosen[k].to, 0.8)),
      /** Stage pixel of a tile's middle. */
      tile: (column: number, row: number) =>
        projection!.project(onPlane(view!.plane, column + 0.5, row + 0.5, view!.state.n)),
    }),
    /** For tests: as if the driver took the context away. */
    loseContext: () => renderer.canvas.getContext("webgl2")?.getExtension("WEBGL_lose_context")?.loseContext(),
    dispose() {
      watcher.disconnect();
      gestures.dispose();
      renderer.dispose();
      element.remove();
    },
  };
}
