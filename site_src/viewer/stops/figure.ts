/** A stop of the lesson as a figure on paper: what is drawn, in points from the figure's top left, y down. Cutting at
 *  the figure's edge is left to whoever draws it. */
import type { PicturePlane } from "../state/frustum";
import type { BoxLine } from "./boxes";
import { planeCorners } from "../state/frustum";
import type { Line } from "../state/lines";
import { seenPart, type Projection } from "../state/projection";
import { ringsOf, type Ring } from "../state/rings";
import { factorsOf, type Switches } from "../state/switches";
import { add, along, scale, sub, triple, type Vec3 } from "../state/vectors";
import type { LineKind } from "../trace/kinds";
import type { SceneData, Trace, View } from "../trace/types";

const NEAR = 1 / 300; // of the scene's radius: what is nearer to the observer is cut
const NORMAL_LONG = 0.13; // of the scene's radius

export type Point = readonly [number, number];
type Ends = readonly [number, number, number, number]; // x, y, x, y

/** Where a line is hidden from the observer: shares of its way. */
export type Stretches = readonly (readonly [number, number])[];

export interface Piece {
  ends: Ends;
  hidden: boolean;
  arrives: boolean; // at the line's end
}

export interface DrawnLine {
  kind: LineKind;
  pieces: readonly Piece[];
}

export interface ChosenLine extends DrawnLine {
  ray: number; // as the card numbers it; of a shadow ray: the ray whose hit it leaves
  light: number; // of a shadow ray, else -1
  leaves: boolean;
  to: Vec3;
  whole: Ends | null;
  end: Point | null;
  tip: Point | null; // of the normal at its end
}

export interface Figure {
  /** Row by row: takes (column, row, 1) of the grid's corners to (x w, y w, w), w the depth before the observer. */
  grid: readonly [Vec3, Vec3, Vec3];
  near: number; // least depth that is drawn
  eye: Point | null; // of the ray-tracing camera; null behind the observer, as all points
  edges: readonly (Ends | null)[]; // from there to the picture plane's corners
  lamps: readonly { name: string; at: Point | null; off: boolean }[];
  rings: readonly { name: string; isLamp: boolean; outline: readonly Point[] }[]; // round what the stop points at
  boxes: readonly { what: BoxLine["what"]; ends: Ends }[]; // of a mesh, edge by edge
}

const ROUND = 48; // corners of a circle

/** A ring as a closed line. */
function outlineOf({ left, right, top, bottom, isRound }: Ring): Point[] {
  if (!isRound) return [[left, top], [right, top], [right, bottom], [left, bottom]];
  const [x, y, across, down] = [(left + right) / 2, (top + bottom) / 2, (right - left) / 2, (bottom - top) / 2];
  return Array.from({ length: ROUND }, (_, k): Point => [x + across * Math.cos((2 * Math.PI * k) / ROUND), y + down * Math.sin((2 * Math.PI * k) / ROUND)]);
}

export class Sheet {
  private readonly near: number;

  constructor(
    private readonly scene: SceneData,
    private readonly view: Projection,
    private readonly eye: Vec3, // the observer's
  ) {
    this.near = NEAR * scene.bounds.radius;
  }

  at(point: Vec3): Point | null {
    const { x, y, depth } = this.view.project(point);
    return depth > this.near ? [x, y] : null;
  }

  /** What of a segment is before the observer. */
  ends(from: Vec3, to: Vec3): Ends | null {
    const seen = seenPart(this.view, from, to, this.near);
    return seen && [seen[0].x, seen[0].y, seen[1].x, seen[1].y];
  }

  drawn({ kind, from, to }: Line, hidden: Stretches): DrawnLine {
    const borders = [...new Set([0, 1, ...hidden.flat()])].sort((a, b) => a - b);
    const pieces = borders.slice(1).flatMap((b, k) => {
      const a = borders[k];
      const ends = this.ends(along(from, to, a), along(from, to, b));
      return ends ? [{ ends, hidden: hidden.some(([low, high]) => low <= (a + b) / 2 && (a + b) / 2 <= high), arrives: b === 1 && this.at(to) !== null }] : [];
    });
    return { kind, pieces };
  }

  chosen(line: Line, hidden: Stretches, trace: Trace, number: number): ChosenLine {
    const { from, to, light, leaves } = line;
    const tip = add(to, scale(triple(trace.normal, line.ray), NORMAL_LONG * this.scene.bounds.radius));
    return { ...this.drawn(line, hidden), ray: number, light, leaves, to, whole: this.ends(from, to), end: this.at(to), tip: this.at(tip) };
  }

  figure(plane: PicturePlane, n: number, switches: Switches, pointing: View, boxes: readonly BoxLine[]): Figure {
    const axes = [scale(plane.across, 1 / n), scale(plane.down, 1 / n), sub(plane.origin, this.eye)].map(this.view.homogeneous);
    const factors = factorsOf(switches, this.scene);
    return {
      grid: [0, 1, 2].map((k) => axes.map((axis) => axis[k])) as unknown as Figure["grid"],
      near: this.near,
      eye: this.at(plane.eye),
      edges: planeCorners(plane).map((corner) => this.ends(plane.eye, corner)),
      lamps: this.scene.lights.map(({ name, position }, light) => ({ name, at: this.at(position), off: factors[light] === 0 })),
      boxes: boxes.flatMap(({ what, from, to }) => {
        const ends = this.ends(from, to);
        return ends ? [{ what, ends }] : [];
      }),
      rings: ringsOf(pointing, this.scene, this.view, this.near).map((ring) => ({ name: ring.name, isLamp: ring.isLamp, outline: outlineOf(ring) })),
    };
  }
}
