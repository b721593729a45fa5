/** A slice drawn with Canvas2D: outlines, the row's rays, its tiles, the selected pixel's rays, lamps and the eye. */
import { LINES, STAGE } from "../palette";
import type { Line } from "../state/lines";
import { CURVE, type Curve, type Flat } from "../state/section";
import { triple } from "../state/vectors";
import type { MaterialData, SceneData, Vec3 } from "../trace/types";
import { hexOf } from "../words";
import { arrowHead, disc, stroke, type Brush } from "./pen";
import type { Sheet, SliceView } from "./slice-sheet";

const FAINT = 0.34; // of a row's other rays
const HEAD = 9; // of an arrow
const INK = 0.55; // of a colour on a light page
const PALEST = 0.42; // mirrors and glass have no colour of their own: their outlines must be seen on the dark page

export function drawSlice(brush: Brush, { section, scene, chosen, tiles, costs, tile }: SliceView, sheet: Sheet) {
  const { at, on } = sheet;
  for (const curve of section.curves) drawCurve(brush, curve, sheet, scene, false);
  for (const curve of sheet.beside) drawCurve(brush, curve, sheet, scene, true);
  brush.globalAlpha = FAINT;
  for (const ray of section.rays) stroke(brush, at(section.eye), at(ray.end), LINES.camera.colour, 1);
  brush.globalAlpha = 1;
  for (const [k, ray] of section.rays.entries()) drawTile(brush, at(ray.tile[0]), at(ray.tile[1]), k === tile, costs && ray.ray < tiles ? triple(costs.colours, ray.ray) : null);
  for (const line of chosen) drawRay(brush, line, on(line.from), on(line.to));
  for (const line of chosen) if (line.kind === "blocked" && !line.growing) cross(brush, on(line.to), 7, LINES.blocked.colour);
  for (const { position, intensity } of scene.lights) {
    dot(brush, on(position), 7, intensity > 0 ? STAGE.lamp : STAGE.lampOff);
    if (intensity === 0) cross(brush, on(position), 9, STAGE.lampOff);
  }
  dot(brush, at(section.eye), 6, STAGE.camera);
}

/** A material's colour as a line's. */
const paintOf = ({ diffuse }: MaterialData) => hexOf(diffuse.map((v) => (STAGE.onPaper ? INK * v : PALEST + (1 - PALEST) * v)) as unknown as Vec3);

function pathOf({ kind, points }: Curve, { at, zoom }: Sheet): Path2D {
  const path = new Path2D();
  if (kind === CURVE.ellipse) {
    const [centre, u, v] = points;
    const unitCircle = new Path2D();
    unitCircle.arc(0, 0, 1, 0, 2 * Math.PI);
    path.addPath(unitCircle, new DOMMatrix([zoom * u[0], zoom * u[1], zoom * v[0], zoom * v[1], ...at(centre)]));
    return path;
  }
  for (const point of points) path.lineTo(...at(point));
  if (kind === CURVE.closed) path.closePath();
  return path;
}

function drawCurve(brush: Brush, curve: Curve, sheet: Sheet, scene: SceneData, isAside: boolean) {
  const material = scene.materials[scene.objects[curve.object].material];
  const path = pathOf(curve, sheet);
  brush.fillStyle = brush.strokeStyle = paintOf(material);
  if (curve.kind !== CURVE.open && !isAside) {
    brush.globalAlpha = material.transmit > 0 ? 0.12 : 0.3;
    brush.fill(path);
    brush.globalAlpha = 1;
  }
  brush.lineWidth = 2;
  brush.setLineDash(isAside ? [7, 6] : []);
  brush.stroke(path);
}

function drawTile(brush: Brush, from: Flat, to: Flat, isChosen: boolean, colour: Vec3 | null) {
  if (isChosen) stroke(brush, from, to, "#FFFFFF", 13);
  stroke(brush, from, to, colour ? `rgb(${colour.join()})` : STAGE.frustum, isChosen ? 9 : 6);
}

function drawRay(brush: Brush, { kind, leaves, growing }: Line, from: Flat, to: Flat) {
  const { colour, dash, wide } = LINES[kind];
  stroke(brush, from, to, colour, 3 * wide, dash);
  arrowHead(brush, from, to, colour, HEAD, { at: 0.6, back: 0, aside: 0.6, least: 3 * HEAD });
  if (!leaves && !growing) dot(brush, to, 5, colour);
}

function dot(brush: Brush, at: Flat, radius: number, colour: string) {
  disc(brush, at, radius, colour);
  brush.lineWidth = 1.5;
  brush.strokeStyle = "#0d1116";
  brush.stroke();
}

function cross(brush: Brush, [x, y]: Flat, arm: number, colour: string) {
  stroke(brush, [x - arm, y - arm], [x + arm, y + arm], colour, 3.5);
  stroke(brush, [x - arm, y + arm], [x + arm, y - arm], colour, 3.5);
}
