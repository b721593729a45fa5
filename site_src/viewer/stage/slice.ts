/** The slice view: a row's or a column's plane of camera rays as a flat drawing, in place of the stage. */
import { hexOf, say } from "../words";
import { LINES, STAGE } from "../palette";
import type { Line } from "../state/lines";
import { CURVE, frameOf, type Curve, type Flat, type Section } from "../state/section";
import { silhouetteOf } from "../state/silhouette";
import type { Costs } from "../state/costs";
import { triple } from "../state/vectors";
import type { SceneData, Trace, Vec3 } from "../trace/types";
import { createLabels, type Label } from "./labels";

const EDGE = 34; // CSS pixels round the drawing, for labels
const ASIDE = 140; // more on its left, for the switch
const ABOVE = 24; // and over it
const NARROW = 700; // narrower, all of these stand outside
const FAINT = 0.34; // of a row's other rays
const HEAD = 9; // of an arrow
const INK = 0.55; // of a colour on a light page
const PALEST = 0.42; // mirrors and glass have no colour of their own: their outlines must be seen on the dark page

export interface SliceView {
  section: Section;
  scene: SceneData; // as the switches make it
  trace: Trace;
  tile: number; // the selected one along the section
  tiles: number; // filled, in scan order
  costs: Costs | null; // their colours
  chosen: readonly Line[];
  large: boolean; // words, on a projector
}

export function createSlice(acts: { pick: (along: number) => void }) {
  const canvas = document.createElement("canvas");
  const labels = createLabels();
  const element = document.createElement("div");
  element.className = "slice";
  element.hidden = true;
  element.append(canvas, labels.element);
  canvas.setAttribute("role", "img");
  const brush = canvas.getContext("2d")!;
  let now: SliceView | null = null;
  let back: (x: number, y: number) => Flat = () => [0, 0];

  function draw() {
    if (!now || element.hidden) return;
    const { clientWidth: width, clientHeight: height } = element;
    const ratio = Math.min(2, window.devicePixelRatio);
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    brush.setTransform(ratio, 0, 0, ratio, 0, 0);
    const { section, scene, chosen, tiles, costs, tile, large } = now;
    const isWide = width >= NARROW;
    const aside = isWide ? ASIDE : 0, above = isWide ? ABOVE : 0;
    const [left, top, right, bottom] = frameOf({ ...section, curves: [...section.curves, ...besidePlane()] }, scene);
    const zoom = Math.min((width - aside - 2 * EDGE) / Math.max(right - left, 1e-9), (height - above - 2 * EDGE) / Math.max(bottom - top, 1e-9));
    const [shiftX, shiftY] = [(width + aside) / 2 - (zoom * (left + right)) / 2, (height + above) / 2 - (zoom * (top + bottom)) / 2];
    const at = ([x, y]: Flat): Flat => [shiftX + zoom * x, shiftY + zoom * y];
    back = (x, y) => [(x - shiftX) / zoom, (y - shiftY) / zoom];
    const on = (point: Vec3) => at(section.flat(point));

    for (const curve of section.curves) drawCurve(curve, at, zoom, scene, false);
    for (const curve of besidePlane()) drawCurve(curve, at, zoom, scene, true);
    brush.lineWidth = 1;
    brush.globalAlpha = FAINT;
    for (const ray of section.rays) stroke([at(section.eye), at(ray.end)], LINES.camera.colour, []);
    brush.globalAlpha = 1;
    for (const [k, ray] of section.rays.entries()) drawTile(ray.tile.map(at), k === tile, costs && ray.ray < tiles ? triple(costs.colours, ray.ray) : null);
    const drawnLines = chosen.map((line) => ({ line, from: on(line.from), to: on(line.to) }));
    for (const { line, from, to } of drawnLines) drawRay(line, from, to);
    for (const { line, to } of drawnLines) if (line.kind === "blocked" && !line.growing) cross(to, 7, LINES.blocked.colour);
    for (const { position, intensity } of scene.lights) {
      dot(on(position), 7, intensity > 0 ? STAGE.lamp : STAGE.lampOff);
      if (intensity === 0) cross(on(position), 9, STAGE.lampOff);
    }
    dot(at(section.eye), 6, STAGE.camera);
    const strokes = drawnLines.flatMap(({ from, to }) => Array.from({ length: 24 }, (_, k) => [from[0] + ((to[0] - from[0]) * k) / 24, from[1] + ((to[1] - from[1]) * k) / 24]).flat());
    labels.show(named(at, on, aside, width, height), width, height, [], strokes, large);
  }

  /** Outlines of what blocks a light and does not reach into the plane, as seen from above it. */
  function besidePlane(): Curve[] {
    const { section, scene, trace, chosen } = now!;
    const blockers = new Set(chosen.filter(({ kind }) => kind === "blocked").map(({ ray, light }) => trace.blocker[ray * trace.lights + light]));
    for (const { object } of section.curves) blockers.delete(object);
    return [...blockers].flatMap((object) => (object < 0 ? [] : (silhouetteOf(object, scene, section.flat) ?? [])));
  }

  function named(at: (f: Flat) => Flat, on: (p: Vec3) => Flat, left: number, width: number, height: number): Label[] {
    const { section, scene, trace, chosen } = now!;
    const met = new Set(chosen.map(({ ray }) => trace.object[ray])); // a narrow drawing names these alone
    const label = (key: string, text: string, [x, y]: Flat, below = false): Label => ({ key, text, x, y, kind: "sign", below });
    const inside = ([x, y]: Flat) => x >= left && y >= 0 && x <= width && y <= height;
    const found = [label("eye", say("slice.eye"), at(section.eye), true)];
    for (const light of scene.lights) if (inside(on(light.position))) found.push(label(`light ${light.name}`, light.intensity > 0 ? light.name : say("stage.off", { light: light.name }), on(light.position)));
    const seen = new Set<number>();
    for (const curve of section.curves) {
      if (seen.has(curve.object) || (width < NARROW && !met.has(curve.object))) continue;
      seen.add(curve.object);
      const place = anchor(curve, at, inside);
      if (place) found.push(label(`object ${curve.object}`, scene.objects[curve.object].name, place, curve.kind !== CURVE.open || isFlat(curve)));
    }
    for (const curve of besidePlane()) {
      const place = anchor(curve, at, inside);
      if (place) found.push({ ...label(`aside ${curve.object}`, say("slice.aside", { name: scene.objects[curve.object].name }), place, true), kind: "stop" });
    }
    return found;
  }

  /** A name beside a line that runs across would be struck through. */
  const isFlat = ({ points }: Curve) => Math.abs(points[0][1] - points[points.length - 1][1]) < Math.abs(points[0][0] - points[points.length - 1][0]);

  /** Where a curve's name belongs: beneath its middle; beside a place of a line that is in the picture. */
  function anchor({ kind, points }: Curve, at: (f: Flat) => Flat, inside: (f: Flat) => boolean): Flat | null {
    if (kind === CURVE.ellipse) return at(points[0]);
    if (kind === CURVE.closed) return at([0, 1].map((axis) => points.reduce((sum, p) => sum + p[axis], 0) / points.length) as unknown as Flat);
    const [from, to] = [at(points[0]), at(points[points.length - 1])];
    for (const share of [0.5, 0.6, 0.4, 0.7, 0.3, 0.55, 0.45]) {
      const place: Flat = [from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])];
      if (inside(place)) return place;
    }
    return inside(from) ? from : inside(to) ? to : null;
  }

  function drawCurve({ object, kind, points }: Curve, at: (f: Flat) => Flat, zoom: number, scene: SceneData, isAside: boolean) {
    const material = scene.materials[scene.objects[object].material];
    const paint = hexOf(material.diffuse.map((v) => (STAGE.onPaper ? INK * v : PALEST + (1 - PALEST) * v)) as unknown as Vec3);
    const path = new Path2D();
    if (kind === CURVE.ellipse) {
      const [centre, u, v] = points;
      const unitCircle = new Path2D();
      unitCircle.arc(0, 0, 1, 0, 2 * Math.PI);
      const [x, y] = at(centre);
      path.addPath(unitCircle, new DOMMatrix([zoom * u[0], zoom * u[1], zoom * v[0], zoom * v[1], x, y]));
    } else {
      for (const [k, point] of points.entries()) k ? path.lineTo(...at(point)) : path.moveTo(...at(point));
      if (kind === CURVE.closed) path.closePath();
    }
    if (kind !== CURVE.open && !isAside) {
      brush.globalAlpha = material.transmit > 0 ? 0.12 : 0.3;
      brush.fillStyle = paint;
      brush.fill(path);
      brush.globalAlpha = 1;
    }
    brush.lineWidth = 2;
    brush.strokeStyle = paint;
    brush.setLineDash(isAside ? [7, 6] : []);
    brush.stroke(path);
  }

  function drawTile([from, to]: readonly Flat[], isChosen: boolean, colour: readonly [number, number, number] | null) {
    brush.lineCap = "butt";
    if (isChosen) {
      brush.lineWidth = 13;
      stroke([from, to], "#FFFFFF", []);
    }
    brush.lineWidth = isChosen ? 9 : 6;
    stroke([from, to], colour ? `rgb(${colour.join(",")})` : STAGE.frustum, []);
  }

  function drawRay({ kind, leaves, growing }: Line, from: Flat, to: Flat) {
    const { colour, dash, wide } = LINES[kind];
    brush.lineWidth = 3 * wide;
    stroke([from, to], colour, dash[0] === 1 ? [] : [...dash]);
    const way = [to[0] - from[0], to[1] - from[1]];
    const long = Math.hypot(way[0], way[1]);
    if (long > 3 * HEAD) {
      const [x, y] = [way[0] / long, way[1] / long];
      const [mx, my] = [from[0] + way[0] * 0.6, from[1] + way[1] * 0.6];
      brush.fillStyle = colour;
      brush.beginPath();
      brush.moveTo(mx + HEAD * x, my + HEAD * y);
      brush.lineTo(mx - HEAD * 0.6 * y, my + HEAD * 0.6 * x);
      brush.lineTo(mx + HEAD * 0.6 * y, my - HEAD * 0.6 * x);
      brush.fill();
    }
    if (!leaves && !growing) dot(to, 5, colour);
  }

  function stroke([from, to]: readonly Flat[], colour: string, dash: number[]) {
    brush.strokeStyle = colour;
    brush.setLineDash(dash);
    brush.beginPath();
    brush.moveTo(...from);
    brush.lineTo(...to);
    brush.stroke();
  }

  function dot([x, y]: Flat, radius: number, colour: string) {
    brush.fillStyle = colour;
    brush.beginPath();
    brush.arc(x, y, radius, 0, 2 * Math.PI);
    brush.fill();
    brush.lineWidth = 1.5;
    brush.setLineDash([]);
    brush.strokeStyle = "#0d1116";
    brush.stroke();
  }

  function cross([x, y]: Flat, arm: number, colour: string) {
    brush.lineWidth = 3.5;
    stroke([[x - arm, y - arm], [x + arm, y + arm]], colour, []);
    stroke([[x - arm, y + arm], [x + arm, y - arm]], colour, []);
  }

  function pick(event: PointerEvent) {
    if (!now || !event.buttons) return;
    const box = canvas.getBoundingClientRect();
    acts.pick(now.section.pixelAt(back(event.clientX - box.left, event.clientY - box.top)));
  }
  canvas.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    canvas.setPointerCapture(event.pointerId);
    pick(event);
  });
  canvas.addEventListener("pointermove", pick);
  new ResizeObserver(draw).observe(element);

  return {
    element,
    /** null: the stage is seen instead. */
    show(view: SliceView | null) {
      now = view;
      element.hidden = !view;
      if (!view) return;
      canvas.setAttribute("aria-label", say(`slice.${view.section.direction}.label`, { pixel: view.tile }));
      draw();
    },
  };
}
