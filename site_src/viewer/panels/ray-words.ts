/** A ray's first words, and a shadow ray's: in the list, in the tree and in copies alike. */
import type { LightRow, RayRow } from "../state/ray-rows";
import { phrases, the, type Phrase } from "../words";

export const rayWords = (row: RayRow): Phrase[] => (row.object ? phrases(`card.hits.${row.kind}`, { object: the(row.object) }) : phrases(`card.leaves.${row.kind}`));
export const lightWords = ({ seen, name, by }: LightRow): Phrase[] =>
  seen === "blocked" ? phrases("card.blocked", { light: the(name), name: the(by) }) : phrases(seen === "reached" ? "card.arrives" : seen === "away" ? "card.away" : seen === "off" ? "card.off" : "card.unasked", { light: the(name) });
