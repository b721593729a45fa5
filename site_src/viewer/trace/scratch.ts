/** Arrays that decoding needs for a while, kept from one level to the next: fresh memory costs a
 *  decoder more than its arithmetic. */
import { BRANCHES } from "./kinds";
import { noSides } from "./neighbours";

export type Scratch = ReturnType<typeof made>;

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

function made(count: number) {
  const column = () => new Int32Array(count), numbers = () => new Float64Array(count);
  return {
    // Of each ray while the tree grows; see structure.ts.
    before: column(), born: Array.from({ length: BRANCHES }, column), surface: column(), patch: column(), children: column(), history: column(), sides: noSides(count),
    // Of one column or a few. counting: 0, 1, 2 ... nearAlike: of all rays, those of the same history.
    counting: column().map((_, k) => k), zeros: column(), near: noSides(count), nearAlike: noSides(count), nearLit: noSides(count),
    group: column(), kind: column(), kindLit: column(), kindHit: column(), rows: column(), moreRows: column(), evenMoreRows: column(), symbol: column(),
    number: [numbers(), numbers(), numbers()] as const, off: numbers(), size: new Int32Array(count + 1),
  };
}
