/** A sweep of one value: a slider that stops where the scene was traced. */
import { element, named } from "../element";
import type { Place, Sweep } from "../state/swept";
import type { MoverActs } from "./types";

const THUMB = 16; // CSS pixels

export function createSlider({ to, hold }: MoverActs, sweep: Sweep, name: string) {
  const count = sweep.values.length;
  const range = named(element("input", "stops"), name);
  Object.assign(range, { type: "range", min: "1", max: String(count), step: "1" });
  range.addEventListener("input", () => to(Number(range.value)));
  /** The thumb keeps to the stops; the finger need not. */
  function place({ clientX }: PointerEvent): Place {
    const { left, width } = range.getBoundingClientRect();
    const share = Math.max(0, Math.min(1, (clientX - left - THUMB / 2) / (width - THUMB)));
    return [(range.matches(":dir(rtl)") ? 1 - share : share) * (count - 1), 0];
  }
  range.addEventListener("pointermove", (event) => event.buttons && hold(place(event)));
  for (const end of ["pointerup", "pointercancel", "lostpointercapture"]) range.addEventListener(end, () => hold(null));
  return {
    element: range,
    show(stop: number, text: string) {
      range.value = String(stop);
      range.setAttribute("aria-valuetext", text);
    },
  };
}
