/** What each light gives at each hit, and who stands between. */
import { ABSENT, type Columns } from "./columns";
import { floats, ints } from "./fill";
import type { Header } from "./header";
import type { Structure } from "./structure";
import { VISIBILITY } from "./types";

export interface Lit {
  visibility: Uint8Array;
  blocker: Int16Array;
  blockedAt: Float64Array;
  diffuse: Float64Array;
  specular: Float64Array;
}

interface Known {
  object: Int16Array;
  material: Int16Array;
  point: Float64Array;
  normal: Float64Array;
}

/** Rays that store something in a column: their group and kind, ABSENT for the others. */
interface Stored {
  group: Int32Array;
  kind: Int32Array;
}

export function readLights(header: Header, columns: Columns, tree: Structure, known: Known): Lit {
  const { lights } = header;
  const count = tree.count * lights.length;
  const lit: Lit = {
    visibility: new Uint8Array(count).fill(VISIBILITY.behind),
    blocker: new Int16Array(count).fill(-1),
    blockedAt: new Float64Array(count).fill(1),
    diffuse: new Float64Array(count),
    specular: new Float64Array(count),
  };
  const axes = (of: Float64Array) => [0, 1, 2].map((c) => floats(tree.count, (row) => of[3 * row + c]));
  const point = axes(known.point);
  const features = [...axes(known.normal), ...point];
  const hits = hitRays(tree, known.object);
  const coloured = { diffuse: colouredRays(header, tree, known, "diffuse"), specular: colouredRays(header, tree, known, "specular") };
  const step = floats(tree.count, (row) => header.materials[known.material[row]]?.step ?? 0);
  for (let l = 0; l < lights.length; l++) {
    readShadows(header, columns, tree, hits, point, lit, l);
    for (const name of ["diffuse", "specular"] as const) {
      const { group, kind } = coloured[name];
      const number = columns.numbers(`${name}${l}`, group, kind, tree.sides, features);
      const out = lit[name];
      for (let row = 0; row < tree.count; row++) out[row * lights.length + l] = number[row] * step[row];
    }
  }
  return lit;
}

function hitRays(tree: Structure, object: Int16Array): Stored {
  return {
    group: ints(tree.count, (row) => (object[row] >= 0 ? tree.way[row] : ABSENT)),
    kind: ints(tree.count, (row) => (object[row] >= 0 ? tree.surface[row] : ABSENT)),
  };
}

/** A factor is stored where it multiplies a colour that is not black. */
function colouredRays(header: Header, tree: Structure, known: Known, name: "diffuse" | "specular"): Stored {
  const coloured = header.materials.map((of) => of.local > 0 && of[name].some((part) => part > 0));
  const surfaces = header.tables.surface.length;
  const group = new Int32Array(tree.count).fill(ABSENT);
  const kind = new Int32Array(tree.count).fill(ABSENT);
  for (let row = 0; row < tree.count; row++) {
    if (!coloured[known.material[row]]) continue;
    group[row] = tree.way[row] * surfaces + tree.surface[row];
    kind[row] = 2 * tree.surface[row] + (tree.level[row] > 0 ? 1 : 0);
  }
  return { group, kind };
}

function readShadows(
  header: Header, columns: Columns, tree: Structure, hits: Stored, point: Float64Array[], lit: Lit, l: number,
) {
  const { lights, steps } = header;
  const table = header.tables.visibility;
  const seen = columns.symbols(`visibility${l}`, hits.group, hits.kind, tree.sides, table.length);
  const group = new Int32Array(tree.count).fill(ABSENT);
  const kind = new Int32Array(tree.count).fill(ABSENT);
  for (let row = 0; row < tree.count; row++) {
    if (hits.kind[row] === ABSENT) continue;
    const at = row * lights.length + l, of = seen[row];
    lit.visibility[at] = table[of][0];
    lit.blocker[at] = table[of][1];
    if (table[of][0] !== VISIBILITY.blocked) continue;
    group[row] = tree.way[row] * table.length + of;
    kind[row] = 2 * of + (tree.level[row] > 0 ? 1 : 0);
  }
  const left = columns.numbers(`blocked${l}`, group, kind, tree.sides, point);
  const [lightX, lightY, lightZ] = lights[l].position;
  for (let row = 0; row < tree.count; row++) {
    if (kind[row] === ABSENT) continue;
    const x = lightX - point[0][row], y = lightY - point[1][row], z = lightZ - point[2][row];
    lit.blockedAt[row * lights.length + l] = 1 - (left[row] * steps.blocked) / Math.sqrt(x * x + y * y + z * z);
  }
}
