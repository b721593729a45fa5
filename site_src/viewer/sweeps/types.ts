/** What a slider and a pad do. */
import type { Place } from "../state/swept";

export interface MoverActs {
  /** The stop that the state has, which may not be here yet. */
  now: () => number;
  to: (stop: number) => void;
  /** Where the finger is; null: it was let go. */
  hold: (place: Place | null) => void;
}
