/** A sweep and its stops in words, for the page and for paper. */
import type { SceneData } from "./trace/types";
import { number, vector } from "./words";

export type Sweep = NonNullable<SceneData["sweeps"]>[number];

export const sweepName = ({ sweeps = [], sweepNames = [] }: SceneData, id: string): string => {
  const k = sweeps.findIndex((each) => each.id === id);
  return sweepNames[k] ?? sweeps[k].name;
};

/** What a stop's value is, as a person writes it. */
export function valueAt(sweep: Sweep, stop: number): string {
  const value = sweep.values[stop - 1];
  if (typeof value === "number") return number(value);
  return value.length === 3 ? vector([value[0], value[1], value[2]]) : value.map((each) => number(each)).join(" \u00b7 ");
}
