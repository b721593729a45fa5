/** What each light gives at each hit, and what stands in between. */
import type { Columns } from "./columns";
import type { Header } from "./header";
import { ABSENT, alike } from "./neighbours";
import type { Scratch } from "./scratch";
import type { Structure } from "./structure";
import { VISIBILITY, type Trace } from "./types";

/** What each light gives each ray: the trace's columns. */
export type Lit = Pick<Trace, "visibility" | "blocker" | "blockedAt" | "passed" | "diffuse" | "specular">;

/** What is known before. */
export type Known = Pick<Trace, "object" | "material" | "point" | "normal">;

/** As it is where there is no light; prepareLights writes the rest. */
export const darkness = (count: number): Lit => ({
  visibility: new Uint8Array(count).fill(VISIBILITY.behind),
  blocker: new Int32Array(count).fill(-1),
  blockedAt: new Float64Array(count).fill(1),
  passed: new Float64Array(count).fill(1),
  diffuse: new Float64Array(count),
  specular: new Float64Array(count),
});

/** Gives what reads light l; the lights are read one after the other. */
export function prepareLights(header: Header, columns: Columns, tree: Structure, known: Known, scratch: Scratch, lit: Lit): (l: number) => void {
  const factors = colouredRays(header, tree, known, scratch);
  const { kindHit } = scratch;
  for (let row = 0; row < tree.count; row++) kindHit[row] = known.object[row] < 0 ? ABSENT : tree.surface[row];
  return (l) => {
    readShadows(header, columns, tree, known, l, lit, scratch);
    for (const name of FACTORS) readFactors(header, columns, factors[name], known, name, l, lit, scratch);
  };
}

/** Whether a light is seen, and if not what stops it where. */
function readShadows(
  header: Header, columns: Columns, tree: Structure, { point }: Known, l: number, lit: Lit,
  { symbol: seen, group, kind, kindHit, rows: stopped, near, nearAlike, zeros, number: [number] }: Scratch,
) {
  const { history, depth, count } = tree;
  const { visibility, blocker, passed, blockedAt } = lit;
  const table = header.tables.visibility, lights = header.lights.length;
  const visibilities = Uint8Array.from(table, (each) => each[0]);
  const blockers = Int32Array.from(table, (each) => each[1]);
  const shares = Float64Array.from(table, (each) => each[2] ?? 1);
  const isDimmed = shares.some((share) => share !== 1);
  columns.symbols(`visibility${l}`, 0, count, zeros, kindHit, header.tables.surface.length, nearAlike, table.length, seen);
  let blocked = 0;
  for (let row = 0, at = l; row < count; row++, at += lights) {
    group[row] = ABSENT;
    if (kindHit[row] < 0) continue;
    const of = seen[row];
    visibility[at] = visibilities[of];
    if (isDimmed) passed[at] = shares[of];
    if (blockers[of] >= 0) blocker[at] = blockers[of];
    if (visibilities[of] !== VISIBILITY.blocked) continue;
    group[row] = history[row] * table.length + of;
    kind[row] = 2 * of + (depth[row] > 0 ? 1 : 0);
    stopped[blocked++] = row;
  }
  const rows = stopped.subarray(0, blocked);
  alike(rows, group, tree.sides, near);
  columns.numbers(`blocked${l}`, rows, kind, 2 * table.length, near, { width: 3, first: point, second: point }, number);
  const step = header.steps.blocked, [lightX, lightY, lightZ] = header.lights[l].position;
  for (let k = 0; k < rows.length; k++) {
    const row = rows[k];
    const x = lightX - point[3 * row], y = lightY - point[3 * row + 1], z = lightZ - point[3 * row + 2];
    blockedAt[row * lights + l] = 1 - (number[row] * step) / Math.sqrt(x * x + y * y + z * z);
  }
}

const FACTORS = ["diffuse", "specular"] as const;
type Factor = (typeof FACTORS)[number];

/** A factor is stored where it multiplies a colour that is not black. Works out the neighbours. */
function colouredRays(header: Header, tree: Structure, { material }: Known, { group, moreRows, evenMoreRows, nearLit, kindLit }: Scratch): Record<Factor, Int32Array> {
  const { count, surface, history, depth } = tree;
  const surfaces = header.tables.surface.length;
  for (let row = 0; row < count; row++) {
    group[row] = history[row] * surfaces + surface[row];
    kindLit[row] = 2 * surface[row] + (depth[row] > 0 ? 1 : 0);
  }
  const rows = (name: Factor, out: Int32Array) => {
    const is = Uint8Array.from(header.materials, (of) => (of.local > 0 && of[name].some((part) => part > 0) ? 1 : 0));
    let k = 0;
    for (let row = 0; row < count; row++) if (material[row] >= 0 && is[material[row]] === 1) out[k++] = row;
    const found = out.subarray(0, k);
    alike(found, group, tree.sides, nearLit);
    return found;
  };
  return { diffuse: rows("diffuse", moreRows), specular: rows("specular", evenMoreRows) };
}

function readFactors(
  header: Header, columns: Columns, rows: Int32Array, { material, point, normal }: Known, name: Factor, l: number, lit: Lit,
  { nearLit, kindLit, number: [number] }: Scratch,
) {
  const lights = header.lights.length, { passed } = lit, out = lit[name];
  const step = Float64Array.from(header.materials, (of) => of.step);
  columns.numbers(`${name}${l}`, rows, kindLit, 2 * header.tables.surface.length, nearLit, { width: 6, first: normal, second: point }, number);
  for (let k = 0; k < rows.length; k++) {
    const row = rows[k], at = row * lights + l;
    out[at] = number[row] * step[material[row]] * passed[at];
  }
}
