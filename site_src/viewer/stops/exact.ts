/** A few pixels' rays as the tracer has them, in all digits: trace files round, and what is printed must not. */
import { treeOf } from "../state/lines";
import { recombine } from "../trace/rebuild";
import type { SceneData, Trace } from "../trace/types";

/** Rays of some pixels of one grid, parents first: columns of Trace by its names, parents as rows of these. */
export interface ExactRays {
  n: number;
  sweep?: string; // at which stop
  pixel: readonly number[];
  parent: readonly number[];
  kind: readonly number[];
  object: readonly number[];
  columns: Readonly<Record<(typeof COLUMNS)[number], readonly number[]>>;
  hitsStart: readonly number[]; // along the camera rays, which come first
  hitsT: readonly number[];
}

const COLUMNS = ["t", "point", "normal", "weight", "localWeight", "blockedAt", "passed", "diffuse", "specular", "base"] as const;

/** The trace's row of each exact ray. A ray has one child of a kind at most, so both trees are walked alike. */
function rowsOf(trace: Trace, exact: ExactRays): number[] {
  const pixels = new Set(exact.pixel);
  const children = new Map([...pixels].flatMap((pixel) => treeOf(trace, pixel).map((ray): [string, number] => [`${trace.parent[ray]} ${trace.kind[ray]}`, ray])));
  const rows: number[] = [];
  for (const [k, parent] of exact.parent.entries()) rows.push((parent < 0 ? exact.pixel[k] : children.get(`${rows[parent]} ${exact.kind[k]}`)) ?? -1);
  const pixelsRays = [...pixels].reduce((sum, pixel) => sum + treeOf(trace, pixel).length, 0);
  const unlike = rows.findIndex((row, k) => row < 0 || trace.object[row] !== exact.object[k]);
  if (unlike >= 0 || rows.length !== pixelsRays) {
    const [column, row] = [exact.pixel[Math.max(unlike, 0)] % trace.n, Math.floor(exact.pixel[Math.max(unlike, 0)] / trace.n)];
    throw new Error(`${trace.scene}: the rays of pixel ${column},${row} in ${trace.n}.json.gz are not those that the tracer sends`);
  }
  return rows;
}

/** The trace with these rays' numbers in place of its own. Throws if it has other rays. */
export function withExact(trace: Trace, scene: SceneData, exact: ExactRays): Trace {
  const rows = rowsOf(trace, exact);
  const laid: Trace = { ...trace };
  for (const name of COLUMNS) {
    const column = trace[name].slice();
    const width = column.length / trace.count;
    for (const [k, row] of rows.entries()) {
      if (name === "t" && exact.object[k] < 0) continue; // Infinity, which JSON has not
      for (let part = 0; part < width; part++) column[row * width + part] = exact.columns[name][k * width + part];
    }
    laid[name] = column;
  }
  laid.hitsT = trace.hitsT.slice();
  for (let k = 0; k < exact.hitsStart.length - 1; k++) laid.hitsT.set(exact.hitsT.slice(exact.hitsStart[k], exact.hitsStart[k + 1]), trace.hitsStart[rows[k]]);
  return { ...laid, colour: recombine(scene, laid) };
}
