/** Three-component vectors as plain tuples. */
import type { Vec3 } from "../trace/types";

export type { Vec3 };

export const add = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const sub = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (a: Vec3, by: number): Vec3 => [a[0] * by, a[1] * by, a[2] * by];
/** Part by part, as colours are multiplied. */
export const times = (a: Vec3, b: Vec3): Vec3 => [a[0] * b[0], a[1] * b[1], a[2] * b[2]];
export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const length = (a: Vec3): number => Math.hypot(a[0], a[1], a[2]);
export const along = (from: Vec3, to: Vec3, share: number): Vec3 => add(from, scale(sub(to, from), share));

export const isAll = (v: Vec3, value: number): boolean => v.every((each) => each === value);

/** Unit length; `a` must not be zero. */
export const unit = (a: Vec3): Vec3 => scale(a, 1 / length(a));

/** The k-th triple of a flat array. */
export const triple = (values: ArrayLike<number>, k: number): Vec3 => [
  values[3 * k],
  values[3 * k + 1],
  values[3 * k + 2],
];
