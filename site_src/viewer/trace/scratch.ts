/** Arrays that decoding needs for a while, kept from one level to the next: fresh memory costs a
 *  decoder more than its arithmetic. */
import { BRANCHES } from "./kinds";
import { noSides, type Sides } from "./neighbours";

export interface Scratch {
  /** Of each ray while the tree grows; see structure.ts. */
  before: Int32Array;
  born: readonly Int32Array[];
  surface: Int32Array;
  patch: Int32Array;
  children: Int32Array;
  history: Int32Array;
  sides: Sides;
  /** Of one column or a few. */
  counting: Int32Array; // 0, 1, 2 ...
  zeros: Int32Array;
  near: Sides;
  nearLit: Sides;
  group: Int32Array;
  kind: Int32Array;
  kindLit: Int32Array;
  kindHit: Int32Array;
  rows: Int32Array;
  moreRows: Int32Array;
  evenMoreRows: Int32Array;
  symbol: Int32Array;
  number: readonly [Float64Array, Float64Array, Float64Array];
  off: Float64Array;
}

let kept: Scratch | undefined;

/** Arrays of at least `count`, which hold anything, for one level until they are given back. */
export function takeScratch(count: number): Scratch {
  const scratch = kept && kept.off.length >= count ? kept : made(count);
  kept = undefined;
  return scratch;
}

/** Keeps the longest. */
export function giveBack(scratch: Scratch) {
  if (!kept || kept.off.length < scratch.off.length) kept = scratch;
}

function made(count: number): Scratch {
  const column = () => new Int32Array(count), numbers = () => new Float64Array(count);
  return {
    before: column(), born: Array.from({ length: BRANCHES }, column), surface: column(), patch: column(), children: column(), history: column(), sides: noSides(count),
    counting: column().map((_, k) => k), zeros: column(), near: noSides(count), nearLit: noSides(count),
    group: column(), kind: column(), kindLit: column(), kindHit: column(), rows: column(), moreRows: column(), evenMoreRows: column(), symbol: column(),
    number: [numbers(), numbers(), numbers()], off: numbers(),
  };
}
