/** The card's head: which pixel, its colour, arrows to its neighbours, and copies to take away. */
import type { Actions } from "../actions";
import { say } from "../words";
import { sayDone } from "./done";
import { button, disable, element, swatch } from "../element";

export type Copy = "text" | "table";

const MOVES = [["\u2190", "left", -1, 0], ["\u2191", "up", 0, -1], ["\u2193", "down", 0, 1], ["\u2192", "right", 1, 0]] as const;

/** copy: calls `done` when the clipboard has it. */
export function createCardHead(acts: Pick<Actions, "move"> & { copy: (what: Copy, done: () => void) => void }) {
  const chip = swatch("#000");
  const name = element("span", "pixel-name");
  const rgb = element("span", "pixel-colour numbers");
  const arrows = MOVES.map(([sign, side, right, down]) => button(sign, say(`controls.moves.${side}`), () => acts.move(right, down), { className: "sign" }));
  const copies = (["text", "table"] as const).map((what) => {
    const made = button(say(`copy.${what}.word`), say(`copy.${what}.help`), () => acts.copy(what, () => sayDone(made, say(`copy.${what}.done`))));
    return made;
  });
  return {
    element: element("div", "card-head", chip, element("h2", "pixel", name, rgb), element("p", "pixel-ray", say("card.oneRay")), element("div", "joined arrows", ...arrows), element("div", "copies", ...copies)),
    /** colour: null while it is not known, or would give an answer away. */
    show([column, row]: readonly [number, number], colour: readonly number[] | null) {
      name.textContent = say("card.pixel", { column, row });
      rgb.textContent = colour?.join(", ") ?? "";
      chip.style.backgroundColor = colour ? `rgb(${colour.join()})` : "transparent";
      for (const each of copies) disable(each, !colour);
    },
  };
}
