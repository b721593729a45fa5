/** The same stage drawn with Canvas2D, for browsers that give no WebGL: far things first, rays on top. */
import { lampColour, LINES, STAGE } from "../palette";
import type { BoxLines } from "../state/box-lines";
import { onPlane, planeCorners } from "../state/frustum";
import { faintness, worthOf, type Line } from "../state/lines";
import { memo } from "../state/memo";
import { seenPart, type Projection } from "../state/projection";
import { dot, length, sub, triple, type Vec3 } from "../state/vectors";
import { shapesOf, type Piece } from "./flat-shapes";
import { arrowHead, disc, stroke, type Brush, type Point } from "./pen";
import type { StageRenderer, StageView } from "./renderer";

const GRID_FROM = 5; // pixels a tile: below, grid lines would cover the tiles

const css = (colour: Vec3, alpha = 1, light = 1) =>
  `rgba(${colour.map((c) => Math.round(255 * Math.min(1, Math.max(0, c * light)))).join(",")},${alpha.toFixed(3)})`;

/** Both ends of what is seen of a segment. */
const endsOf = (projection: Projection, from: Vec3, to: Vec3, near: number) =>
  seenPart(projection, from, to, near)?.map(({ x, y }) => [x, y] as const) as [Point, Point] | undefined;

function path(brush: Brush, projection: Projection, points: readonly Vec3[]): boolean {
  const seen = points.map(projection.project);
  if (seen.some((p) => p.depth <= 0)) return false;
  brush.beginPath();
  seen.forEach((p, k) => (k ? brush.lineTo(p.x, p.y) : brush.moveTo(p.x, p.y)));
  brush.closePath();
  return true;
}

/** A stretched ball's outline: the ellipse its three axes span on the screen. */
function drawBall(brush: Brush, projection: Projection, { center, axes, colour, alpha }: Extract<Piece, { kind: "ball" }>) {
  const middle = projection.project(center);
  if (middle.depth <= Math.max(...axes.map(length))) return;
  const scale = projection.focal / middle.depth;
  const [xs, ys] = [axes.map((a) => scale * dot(a, projection.right)), axes.map((a) => -scale * dot(a, projection.up))];
  const sum = (a: number[], b: number[]) => a.reduce((total, v, k) => total + v * b[k], 0);
  const [xx, xy, yy] = [sum(xs, xs), sum(xs, ys), sum(ys, ys)];
  const spread = Math.hypot((xx - yy) / 2, xy);
  const [long, short] = [Math.sqrt((xx + yy) / 2 + spread), Math.sqrt(Math.max(0, (xx + yy) / 2 - spread))];
  const paint = brush.createRadialGradient(-0.35 * long, -0.4 * long, 0, 0, 0, 1.15 * long);
  paint.addColorStop(0, css(colour.map((c) => 0.25 + 0.75 * c) as unknown as Vec3, alpha));
  paint.addColorStop(0.35, css(colour, alpha, 0.9));
  paint.addColorStop(1, css(colour, Math.min(1, 1.6 * alpha), 0.25));
  const turned = 0.5 * Math.atan2(2 * xy, xx - yy);
  brush.save();
  brush.translate(middle.x, middle.y);
  brush.beginPath();
  brush.ellipse(0, 0, long, short, turned, 0, 2 * Math.PI);
  brush.fillStyle = paint;
  brush.fill();
  brush.restore();
}

function drawTiles(brush: Brush, projection: Projection, { plane, state, costs, tiles, ring }: StageView) {
  const { n } = state;
  const corners = (column: number, row: number) =>
    [[0, 0], [1, 0], [1, 1], [0, 1]].map(([c, r]) => onPlane(plane, column + c, row + r, n));
  for (let k = 0; costs && k < tiles; k++) {
    if (!path(brush, projection, corners(k % n, Math.floor(k / n)))) continue;
    brush.fillStyle = brush.strokeStyle = `rgb(${triple(costs.colours, k).join()})`;
    brush.fill();
    brush.stroke(); // closes the hairline gaps between neighbours
  }
  const outline = planeCorners(plane).map(projection.project);
  const tilePixels = Math.hypot(outline[2].x - outline[0].x, outline[2].y - outline[0].y) / n / Math.SQRT2;
  brush.strokeStyle = tiles === n * n ? STAGE.gridFilled : STAGE.gridEmpty;
  brush.globalAlpha = 0.45;
  for (let k = 0; tilePixels >= GRID_FROM && k <= n; k++) {
    if (path(brush, projection, [onPlane(plane, k, 0, n), onPlane(plane, k, n, n)])) brush.stroke();
    if (path(brush, projection, [onPlane(plane, 0, k, n), onPlane(plane, n, k, n)])) brush.stroke();
  }
  brush.globalAlpha = 1;
  brush.strokeStyle = STAGE.gridEmpty;
  if (path(brush, projection, planeCorners(plane))) brush.stroke();
  if (!ring || !path(brush, projection, corners(...state.pixel))) return;
  brush.strokeStyle = ring;
  brush.lineWidth = 2.5;
  brush.stroke();
  brush.lineWidth = 1;
}

function drawLine(brush: Brush, projection: Projection, { kind, from, to }: Line, width: number, near: number) {
  const seen = endsOf(projection, from, to, near);
  if (!seen) return;
  const { colour, dash, wide } = LINES[kind];
  if (width >= 1) stroke(brush, ...seen, STAGE.casing, width + 4);
  stroke(brush, ...seen, colour, width * wide, dash);
  const head = 4 * Math.sqrt(width);
  if (width >= 1) arrowHead(brush, ...seen, colour, head, { at: 0.56, back: 1, aside: 0.8, least: 4 * head });
}

/** A bounding volume's edges. */
function drawEdges(brush: Brush, projection: Projection, edges: BoxLines["entered"], colour: string, near: number) {
  for (const [from, to] of edges) {
    const seen = endsOf(projection, from, to, near);
    if (seen) stroke(brush, ...seen, colour, 0.8);
  }
}

function drawDot(brush: Brush, projection: Projection, at: Vec3, radius: number, colour: string) {
  const { x, y, depth } = projection.project(at);
  if (depth > 0) disc(brush, [x, y], radius, colour);
}

/** A cross where a light is blocked; with a ring, a lamp that is off. */
function drawCross(brush: Brush, projection: Projection, at: Vec3, radius: number, colour: string, ring: boolean) {
  const { x, y, depth } = projection.project(at);
  if (depth <= 0) return;
  const arm = radius * Math.SQRT1_2;
  brush.beginPath();
  brush.moveTo(x - arm, y - arm);
  brush.lineTo(x + arm, y + arm);
  if (!ring) brush.moveTo(x - arm, y + arm), brush.lineTo(x + arm, y - arm);
  else brush.moveTo(x + radius, y), brush.arc(x, y, radius, 0, 2 * Math.PI);
  for (const [width, stroke] of [[6, STAGE.casing], [3, colour]] as const) {
    brush.lineWidth = width;
    brush.strokeStyle = stroke;
    brush.stroke();
  }
  brush.lineWidth = 1;
}

/** Bodies, far ones first, with the tiles in between where they stand. */
function drawBodies(brush: Brush, view: StageView, projection: Projection, pieces: readonly Piece[]) {
  const planeDepth = projection.project(onPlane(view.plane, 0.5, 0.5, 1)).depth;
  const behind = pieces.findIndex(({ depth }) => depth < planeDepth);
  const split = behind < 0 ? pieces.length : behind;
  for (const piece of pieces.slice(0, split)) drawPiece(brush, projection, piece);
  if (!view.state.wipe) drawTiles(brush, projection, view); // else the bodies are compared
  for (const piece of pieces.slice(split)) drawPiece(brush, projection, piece);
}

function drawPiece(brush: Brush, projection: Projection, piece: Piece) {
  if (piece.kind === "ball") return drawBall(brush, projection, piece);
  if (!path(brush, projection, piece.points)) return;
  brush.fillStyle = brush.strokeStyle = css(piece.colour, piece.alpha);
  brush.fill();
  if (piece.alpha === 1) brush.stroke();
}

function drawLines(brush: Brush, { thin, chosen, lit, boxLines }: StageView, projection: Projection, near: number) {
  brush.globalAlpha = faintness(thin.length);
  for (const line of thin) drawLine(brush, projection, line, 0.9, near);
  brush.globalAlpha = 1;
  for (const line of chosen) drawLine(brush, projection, line, lit?.ray === line.ray && lit.light === line.light ? 5 : 3 * worthOf(line), near);
  drawEdges(brush, projection, boxLines.missed, STAGE.boxMissed, near);
  drawEdges(brush, projection, boxLines.entered, STAGE.boxEntered, near);
}

/** Where rays end, what blocks lights, lamps. */
function drawSigns(brush: Brush, { thin, chosen, switched }: StageView, projection: Projection) {
  const ends = (lines: readonly Line[], radius: number) => {
    for (const line of lines) if (line.light < 0 && !line.leaves && !line.growing) drawDot(brush, projection, line.to, radius, LINES[line.kind].colour);
  };
  ends(thin, 2);
  ends(chosen, 4.5);
  for (const line of chosen) if (line.kind === "blocked" && !line.growing) drawCross(brush, projection, line.to, 9, LINES.blocked.colour, false);
  for (const { position, intensity, colour } of switched.lights)
    if (intensity > 0) drawDot(brush, projection, position, 8, lampColour(colour));
    else drawCross(brush, projection, position, 8, STAGE.lampOff, true);
}

export function createFlatRenderer(): StageRenderer {
  const canvas = document.createElement("canvas");
  const brush = canvas.getContext("2d")!;
  const shapes = memo<ReturnType<typeof shapesOf>>();
  let size = { width: 1, height: 1, ratio: 1 };

  return {
    canvas,
    isFlat: true,
    draw({ view, observer, projection }) {
      brush.setTransform(size.ratio, 0, 0, size.ratio, 0, 0);
      brush.clearRect(0, 0, size.width, size.height);
      brush.lineWidth = 1;
      drawBodies(brush, view, projection, shapes([view.scene, view.switched.objects], () => shapesOf({ ...view.scene, objects: view.switched.objects }))(observer.eye, projection));
      const near = view.scene.bounds.radius / 300;
      const { eye } = view.plane;
      const fromAside = length(sub(observer.eye, eye)) > near;
      brush.strokeStyle = STAGE.frustum;
      if (fromAside) for (const corner of planeCorners(view.plane)) if (path(brush, projection, [eye, corner])) brush.stroke();
      drawLines(brush, view, projection, near);
      drawSigns(brush, view, projection);
      if (fromAside) drawDot(brush, projection, eye, 7, STAGE.camera);
    },
    resize(width, height, ratio) {
      size = { width, height, ratio };
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(height * ratio);
    },
    forget: () => {}, // it keeps none
    held: () => ({}),
    dispose: () => canvas.remove(),
  };
}
