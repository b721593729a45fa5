/** What each light gives at each hit, and who stands between. */
import { ABSENT, storedRays, type Columns, type Features, type Stored } from "./columns";
import { floats } from "./fill";
import type { Header } from "./header";
import type { Structure } from "./structure";
import { VISIBILITY } from "./types";

export interface Lit {
  visibility: Uint8Array;
  blocker: Int16Array;
  blockedAt: Float64Array;
  passed: Float64Array;
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
  const { lights } = header;
  const count = tree.count * lights.length;
  const lit: Lit = {
    visibility: new Uint8Array(count).fill(VISIBILITY.behind),
    blocker: new Int16Array(count).fill(-1),
    blockedAt: new Float64Array(count).fill(1),
    passed: new Float64Array(count).fill(1),
    diffuse: new Float64Array(count),
    specular: new Float64Array(count),
  };
  const place: Features = { width: 3, values: known.point };
  const features: Features = { width: 6, values: new Float64Array(6 * tree.count) };
  for (let row = 0; row < tree.count; row++)
    for (let c = 0; c < 3; c++) {
      features.values[6 * row + c] = known.normal[3 * row + c];
      features.values[6 * row + 3 + c] = known.point[3 * row + c];
    }
  const number = new Float64Array(tree.count); // scratch, as are the next
  const blocked = { group: new Int32Array(tree.count), kind: new Int32Array(tree.count) };
  const hits = hitRays(tree, known.object);
  const factors = colouredRays(header, tree, known);
  const step = floats(tree.count, (row) => header.materials[known.material[row]]?.step ?? 0);
  for (let l = 0; l < lights.length; l++) {
    readShadows(header, columns, tree, hits, place, lit, l, number, blocked);
    for (const { name, stored } of factors) {
      columns.numbers(`${name}${l}`, stored, features, number);
      const { rows } = stored;
      const out = lit[name];
      for (let k = 0; k < rows.length; k++) {
        const row = rows[k], at = row * lights.length + l;
        out[at] = number[row] * step[row] * lit.passed[at];
      }
    }
  }
  return lit;
}

function hitRays(tree: Structure, object: Int16Array): Stored {
  const group = new Int32Array(tree.count).fill(ABSENT);
  const kind = new Int32Array(tree.count).fill(ABSENT);
  for (let row = 0; row < tree.count; row++) {
    if (object[row] < 0) continue;
    group[row] = tree.way[row];
    kind[row] = tree.surface[row];
  }
  return storedRays(group, kind, tree.sides);
}

const FACTORS = ["diffuse", "specular"] as const;

/** A factor is stored where it multiplies a colour that is not black. */
function colouredRays(header: Header, tree: Structure, known: Known) {
  const colouredBy = FACTORS.map((name) => header.materials.map((of) => of.local > 0 && of[name].some((part) => part > 0)));
  const alike = colouredBy[0].every((is, k) => is === colouredBy[1][k]);
  const surfaces = header.tables.surface.length;
  const stored = (coloured: boolean[]) => {
    const group = new Int32Array(tree.count).fill(ABSENT);
    const kind = new Int32Array(tree.count).fill(ABSENT);
    for (let row = 0; row < tree.count; row++) {
      if (!coloured[known.material[row]]) continue;
      group[row] = tree.way[row] * surfaces + tree.surface[row];
      kind[row] = 2 * tree.surface[row] + (tree.level[row] > 0 ? 1 : 0);
    }
    return storedRays(group, kind, tree.sides);
  };
  const diffuse = stored(colouredBy[0]);
  const specular = alike ? diffuse : stored(colouredBy[1]);
  return [{ name: FACTORS[0], stored: diffuse }, { name: FACTORS[1], stored: specular }];
}

function readShadows(
  header: Header, columns: Columns, tree: Structure, hits: Stored, place: Features, lit: Lit, l: number,
  number: Float64Array, blocked: { group: Int32Array; kind: Int32Array },
) {
  const { lights, steps } = header;
  const table = header.tables.visibility;
  const seen = columns.symbols(`visibility${l}`, hits, tree.count, table.length);
  const group = blocked.group.fill(ABSENT), kind = blocked.kind.fill(ABSENT);
  const visibilities = Uint8Array.from(table, (each) => each[0]);
  const blockers = Int16Array.from(table, (each) => each[1]);
  const shares = Float64Array.from(table, (each) => each[2] ?? 1);
  for (let k = 0; k < hits.rows.length; k++) {
    const row = hits.rows[k], of = seen[row];
    const at = row * lights.length + l;
    lit.visibility[at] = visibilities[of];
    lit.blocker[at] = blockers[of];
    lit.passed[at] = shares[of];
    if (visibilities[of] !== VISIBILITY.blocked) continue;
    group[row] = tree.way[row] * table.length + of;
    kind[row] = 2 * of + (tree.level[row] > 0 ? 1 : 0);
  }
  const stored = storedRays(group, kind, tree.sides);
  columns.numbers(`blocked${l}`, stored, place, number);
  const [lightX, lightY, lightZ] = lights[l].position;
  for (let k = 0; k < stored.rows.length; k++) {
    const row = stored.rows[k];
    const x = lightX - place.values[3 * row], y = lightY - place.values[3 * row + 1], z = lightZ - place.values[3 * row + 2];
    lit.blockedAt[row * lights.length + l] = 1 - (number[row] * steps.blocked) / Math.sqrt(x * x + y * y + z * z);
  }
}
