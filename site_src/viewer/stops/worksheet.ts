/** Which grid a lesson's worksheet is about, and which of its pixels the lesson walks: the tracer chooses those that are
 *  asked about (trace/sheet_pixels.py). */
import { isSwitched } from "../state/switches";
import { pixelIndex } from "../state/view-state";
import { walksPixel, type Stop } from "./seen";

export interface Worksheet {
  n: number; // of the first grid that the lesson shows as it was traced; 0: there is none
  walked: readonly number[]; // pixels, row * n + column
}

export function worksheetOf(stops: readonly Stop[]): Worksheet {
  const states = stops.map(({ state }) => state).filter(({ switches, sweep }) => !isSwitched(switches) && !sweep);
  if (!states.length) return { n: 0, walked: [] };
  const [{ n }] = states;
  return { n, walked: [...new Set(states.filter((state) => state.n === n && walksPixel(state)).map(pixelIndex))] };
}
