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

export function readLights(header: Header, columns: Columns, tree: Structure, known: Known): Lit {
  const count = tree.count * header.lights.length;
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
  header.lights.forEach((_, l) => {
    readShadows(header, columns, tree, known.object, point, lit, l);
    for (const name of ["diffuse", "specular"] as const) {
      readFactor(header, columns, tree, known.material, features, name, lit[name], l);
    }
  });
  return lit;
}

function readShadows(
  header: Header, columns: Columns, tree: Structure, object: Int16Array, point: Float64Array[], lit: Lit, l: number,
) {
  const { lights, steps } = header;
  const table = header.tables.visibility;
  const isHit = (row: number) => object[row] >= 0;
  const seen = columns.symbols(
    `visibility${l}`,
    ints(tree.count, (row) => (isHit(row) ? tree.way[row] : ABSENT)),
    ints(tree.count, (row) => (isHit(row) ? tree.surface[row] : ABSENT)),
    tree.sides,
    table.length,
  );
  const isBlocked = (row: number) => isHit(row) && table[seen[row]][0] === VISIBILITY.blocked;
  const group = ints(tree.count, (row) => (isBlocked(row) ? tree.way[row] * table.length + seen[row] : ABSENT));
  const kind = ints(tree.count, (row) => (isBlocked(row) ? 2 * seen[row] + below(tree, row) : ABSENT));
  const left = columns.numbers(`blocked${l}`, group, kind, tree.sides, point);
  const [lightX, lightY, lightZ] = lights[l].position;
  for (let row = 0; row < tree.count; row++) {
    if (!isHit(row)) continue;
    const at = row * lights.length + l;
    lit.visibility[at] = table[seen[row]][0];
    lit.blocker[at] = table[seen[row]][1];
    if (group[row] === ABSENT) continue;
    const x = lightX - point[0][row], y = lightY - point[1][row], z = lightZ - point[2][row];
    lit.blockedAt[at] = 1 - (left[row] * steps.blocked) / Math.sqrt(x * x + y * y + z * z);
  }
}

/** A factor is stored where it multiplies a colour that is not black. */
function readFactor(
  header: Header, columns: Columns, tree: Structure, material: Int16Array, features: Float64Array[],
  name: "diffuse" | "specular", out: Float64Array, l: number,
) {
  const { materials, lights } = header;
  const surfaces = header.tables.surface.length;
  const coloured = materials.map((of) => of.local > 0 && of[name].some((part) => part > 0));
  const isLit = (row: number) => material[row] >= 0 && coloured[material[row]];
  const group = ints(tree.count, (row) => (isLit(row) ? tree.way[row] * surfaces + tree.surface[row] : ABSENT));
  const kind = ints(tree.count, (row) => (isLit(row) ? 2 * tree.surface[row] + below(tree, row) : ABSENT));
  const number = columns.numbers(`${name}${l}`, group, kind, tree.sides, features);
  for (let row = 0; row < tree.count; row++) {
    if (group[row] !== ABSENT) out[row * lights.length + l] = number[row] * materials[material[row]].step;
  }
}

const below = (tree: Structure, row: number) => (tree.level[row] > 0 ? 1 : 0);
