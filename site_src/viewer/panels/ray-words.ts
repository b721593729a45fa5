/** A ray's first words, and a shadow ray's: in the list, in the tree and in copies alike. */
import { the } from "../articles";
import type { LightRow, RayRow } from "../state/ray-rows";
import { phrases, type Phrase } from "../words";

export const rayWords = (row: RayRow): Phrase[] => (row.object ? phrases(`card.hits.${row.kind}`, { object: the(row.object) }) : phrases(`card.leaves.${row.kind}`));
export const lightWords = ({ seen, name, by }: LightRow): Phrase[] => phrases(`card.${seen}`, { light: the(name), name: the(by) });
