/** All that is found out about a picture of a scene: the page shows it, `raywalk compare` prints it. */
import type { About } from "./atlas";
import { compare, type Comparison } from "./compare";
import type { Picture } from "./formats/picture";
import { whereWrong, type Where } from "./places";
import { isAsRight, type Recognised, type recogniserOf } from "./recognise";
import type { Square } from "./square";
import { gridFor, worstTiles, type Tile } from "./tiles";

export interface Checked extends Recognised {
  comparison: Comparison;
  where: Where;
  tiles: Tile[];
}

export interface Scene {
  about: About;
  places: Picture;
  recogniser: ReturnType<typeof recogniserOf> | null; // null: it has no atlas
}

/** right: of the square's size. isExact: as source.isExact. */
export function check({ picture }: Square, right: Picture, isExact: boolean, { about, places, recogniser }: Scene): Checked {
  const comparison = compare(picture, right);
  const recognised = recogniser?.recognise(picture, right, isExact) ?? { isRight: isAsRight(picture, right, isExact), answers: [], isPair: false };
  const none = { where: { told: [], objects: [] }, tiles: [] };
  if (recognised.isRight) return { ...recognised, comparison, ...none };
  return { ...recognised, comparison, where: whereWrong(picture, right, places), tiles: worstTiles(picture, right, places, gridFor(right.width, about.grids)) };
}
