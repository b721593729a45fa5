/** The way from the eye to a surface in words: which mirrors it goes by, which glass it goes through. */
import { the } from "./articles";
import type { Passing } from "./state/event-types";
import { list, say } from "./words";

const MOST = 4; // surfaces that are named one by one

/** "by the mirror, through the glass sphere"; "" on a camera ray's way. */
export function wayWords(way: readonly Passing[]): string {
  const said: string[] = [];
  way.forEach(({ what, name, enters }, k) => {
    const before = way[k - 1];
    const isOut = what === "refracted" && !enters;
    const isThrough = isOut && before?.what === "refracted" && before.enters && before.name === name;
    if (isThrough) said.pop();
    const how = isThrough ? "through" : isOut ? "outOf" : !enters ? "within" : what === "refracted" ? "into" : "by";
    said.push(say(`way.${how}`, { name: the(name) }));
  });
  if (said.length > MOST) said.splice(MOST - 2, said.length - MOST + 1, say("way.more", { count: said.length - MOST + 1 }));
  return list(said);
}
