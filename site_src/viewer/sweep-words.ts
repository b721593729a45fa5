/** A sweep and its stops in words, for the page and for paper. */
import type { SceneData } from "./trace/types";
import { placeOf } from "./state/swept";
import { number, vector } from "./words";

const BETWEEN = " \u00b7 ";

export type Sweep = NonNullable<SceneData["sweeps"]>[number];

export const sweepName = ({ sweeps = [], sweepNames = [] }: SceneData, id: string): string => {
  const k = sweeps.findIndex((each) => each.id === id);
  return sweepNames[k] ?? sweeps[k].name;
};

export const acrossName = ({ sweeps = [], acrossNames = [] }: SceneData, id: string): string => {
  const k = sweeps.findIndex((each) => each.id === id);
  return acrossNames[k] || sweeps[k].across?.name || "";
};

/** 0.25 and 3, not 0.250 and 3.000: it was typed so. */
const typed = (value: number) => number(value).replace(/\D?0+$/, "");

/** What a value is, as a person writes it. */
export function written(value: Sweep["values"][number], unit?: Sweep["unit"]): string {
  if (typeof value === "number") return `${typed(value)}${unit ? "\u00b0" : ""}`;
  return value.length === 3 ? vector([value[0], value[1], value[2]]) : value.map(typed).join(BETWEEN);
}

/** What a stop's value is; of a grid both. */
export function valuesAt({ across, ...sweep }: Sweep, stop: number): string[] {
  const [column, row] = placeOf(sweep, stop);
  return [written(sweep.values[column], sweep.unit), ...(across ? [written(across.values[row], across.unit)] : [])];
}

export const valueAt = (sweep: Sweep, stop: number): string => valuesAt(sweep, stop).join(BETWEEN);

/** The same where there is little room: of a place only what is other at other stops. */
export function shortValueAt({ values, across, unit }: Sweep, stop: number): string {
  const few = (all: Sweep["values"], value: Sweep["values"][number]) => (typeof value === "number" ? value : value.filter((part, k) => all.some((each) => (each as number[])[k] !== part)));
  const shown = (all: Sweep["values"], at: number, of?: Sweep["unit"]) => {
    const parts = few(all, all[at]);
    return typeof parts === "number" ? written(parts, of) : parts.map(typed).join(BETWEEN);
  };
  const [column, row] = placeOf({ values } as Sweep, stop);
  return [shown(values, column, unit), ...(across ? [shown(across.values, row, across.unit)] : [])].join(BETWEEN);
}
