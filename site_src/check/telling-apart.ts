/** What tells the first answer from the second: where the pictures of both differ most, and what each makes of a pixel there. */
import type { Picture } from "./formats/picture";
import { meansOf, NOISE, sampled } from "./layer";
import { liesIn, placeAt, whereWrong, type Told } from "./places";
import type { Recognised } from "./recognise";

export interface Apart {
  place: Told; // that holds most of what differs
  x: number; // a pixel of the student's picture
  y: number;
  first: number[]; // bytes
  second: number[];
  own: number[];
}

/** Pixels along of a block: what tells must be more than a speckle. */
const BLOCK = 7;

/** null: there are no two, or they differ in nothing that is seen. pictureOf: what a mistake makes of the scene. */
export function apartOf({ answers: [a, b], isPair }: Recognised, pictureOf: (name: string) => Uint8Array | null, student: Picture, right: Picture, places: Picture): Apart | null {
  const [one, other] = a && b && !isPair ? [a, b].map(({ names }) => pictureOf(names[0])) : [];
  if (!one || !other) return null;
  const size = Math.sqrt(one.length / 3);
  const of = (values: Uint8Array): Picture => ({ ...right, width: size, height: size, values });
  const { told, objects } = whereWrong(of(one), of(other), places);
  if (!objects.length) return null;
  const [{ object, ofWrong }] = objects;
  const place: Told = told[0] ?? { kind: object < 0 ? "background" : "object", object, ofWrong, ofPicture: 0 };
  const at = mostApart(one, other, size, places, place);
  if (!at) return null;
  const bytes = (values: ArrayLike<number>, i: number) => [0, 1, 2].map((c) => Math.round(values[i + c]));
  const [x, y] = at.map((along) => Math.floor(((along + 0.5) * student.width) / size));
  const i = 3 * (at[1] * size + at[0]);
  return { place, x, y, first: bytes(one, i), second: bytes(other, i), own: bytes(student.values, 3 * (y * student.width + x)) };
}

/** The middle of the block that differs most, of those whose middle lies in the place; the less, the more either picture changes there:
 *  a student's pixels have their centres elsewhere. */
function mostApart(one: Uint8Array, other: Uint8Array, size: number, places: Picture, place: Told): [number, number] | null {
  const along = Math.floor(size / BLOCK);
  const [p, q] = [one, other].map((values) => meansOf(sampled(values, size, size), size, BLOCK));
  let [most, best] = [NOISE, -1];
  for (let k = 0; k < along * along; k++) {
    const [x, y] = [k % along, Math.floor(k / along)].map((block) => BLOCK * block + (BLOCK >> 1));
    const i = 3 * (y * size + x);
    const apart = Math.max(...[0, 1, 2].map((c) => Math.min(Math.abs(p[3 * k + c] - q[3 * k + c]), Math.abs(one[i + c] - other[i + c]))));
    if (apart <= most) continue;
    const steady = apart - changeAt(one, size, i) - changeAt(other, size, i);
    if (steady <= most) continue;
    const { object, bits } = placeAt(places, size, x, y);
    if (liesIn(place, object, bits)) [most, best] = [steady, k];
  }
  return best < 0 ? null : [BLOCK * (best % along) + (BLOCK >> 1), BLOCK * Math.floor(best / along) + (BLOCK >> 1)];
}

/** How far a pixel's colours are from those of the four beside it. i: of its red, which is on no rim. */
const changeAt = (values: Uint8Array, size: number, i: number) => Math.max(...[-3, 3, -3 * size, 3 * size].flatMap((step) => [0, 1, 2].map((c) => Math.abs(values[i + step + c] - values[i + c]))));
