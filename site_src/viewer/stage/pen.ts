/** Strokes and signs on a flat canvas. Points and lengths in CSS pixels. */
export type Brush = CanvasRenderingContext2D;
export type Point = readonly [number, number];

/** dash: [drawn, gap]; [1, 0] is a solid line. */
export function stroke(brush: Brush, from: Point, to: Point, colour: string, width: number, [drawn, gap]: readonly [number, number] = [1, 0]) {
  brush.strokeStyle = colour;
  brush.lineWidth = width;
  brush.setLineDash(gap ? [drawn, gap] : []);
  brush.beginPath();
  brush.moveTo(...from);
  brush.lineTo(...to);
  brush.stroke();
  brush.setLineDash([]);
}

export function disc(brush: Brush, [x, y]: Point, radius: number, colour: string) {
  brush.beginPath();
  brush.arc(x, y, radius, 0, 2 * Math.PI);
  brush.fillStyle = colour;
  brush.fill();
}

/** An arrow head on the line between two points. at: share of the line; back, aside: how far its corners are from
 *  there, as shares of `size`, which is how far its tip is. None on a line that is shorter than `least`. */
export function arrowHead(brush: Brush, from: Point, to: Point, colour: string, size: number, { at, back, aside, least }: { at: number; back: number; aside: number; least: number }) {
  const run = [to[0] - from[0], to[1] - from[1]];
  const long = Math.hypot(...run);
  if (long < least) return;
  const [ux, uy] = run.map((each) => (each / long) * size);
  const [x, y] = [from[0] + at * run[0], from[1] + at * run[1]];
  brush.fillStyle = colour;
  brush.beginPath();
  brush.moveTo(x + ux, y + uy);
  brush.lineTo(x - back * ux - aside * uy, y - back * uy + aside * ux);
  brush.lineTo(x - back * ux + aside * uy, y - back * uy - aside * ux);
  brush.fill();
}
