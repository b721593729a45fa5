/** All that is found out about a picture of a scene: the page shows it, `raywalk compare` prints it. */
import type { About } from "./atlas";
import { compare, type Comparison } from "./compare";
import type { Picture } from "./formats/picture";
import { whereWrong, type Where } from "./places";
import { isAsRight, type Recognised, type recogniserOf } from "./recognise";
import type { Square } from "./square";
import { apartOf, type Apart } from "./telling-apart";
import { gridFor, worstTiles, type Tile } from "./tiles";

export interface Checked extends Recognised {
  comparison: Comparison;
  where: Where;
  tiles: Tile[];
  areBeside: boolean; // no pixel's middle is that of a tile
  apart: Apart | null; // what tells the first answer from the second
}

export interface Scene {
  about: About;
  places: Picture;
  recogniser: ReturnType<typeof recogniserOf> | null; // null: it has no atlas
}

/** Whether the scene's right colours at tiles are wanted for a picture n pixels along, which has none of them itself. */
export const wantsTiles = (n: number, { grids }: About) => !gridFor(n, grids).isShared;

/** right: of the square's size. isExact: as source.isExact. exact: the right colours of tiles, where they are wanted. */
export function check({ picture }: Square, right: Picture, isExact: boolean, { about, places, recogniser }: Scene, exact = right): Checked {
  const comparison = compare(picture, right);
  const recognised = recogniser?.recognise(picture, right, isExact) ?? { isRight: isAsRight(picture, right, isExact), answers: [], isPair: false };
  if (recognised.isRight) return { ...recognised, comparison, where: { told: [], objects: [] }, tiles: [], areBeside: false, apart: null };
  const where = whereWrong(picture, right, places);
  const { n, isShared } = gridFor(right.width, about.grids);
  const tiles = worstTiles(picture, right, isShared ? right : exact, places, n, where.told);
  const apart = recogniser && apartOf(recognised, recogniser.pictureOf, picture, right, places);
  return { ...recognised, comparison, where, tiles, areBeside: !isShared, apart };
}
