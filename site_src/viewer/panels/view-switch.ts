/** In the stage's corner: the scene in space, or the plane of a row's or a column's rays drawn flat. */
import { SLICES, type Slice } from "../state/section";
import type { ViewState } from "../state/view-state";
import { say } from "../words";
import { button, element, pressed } from "./element";

export function createViewSwitch(acts: { slice: (slice: Slice) => void }) {
  const choices = SLICES.map((slice) => {
    return { slice, choice: button(say(`slice.${slice}.word`), say(`slice.${slice}.help`), () => acts.slice(slice)) };
  });
  const [space, ...slices] = choices.map((each) => each.choice);
  const note = element("p", "slice-note");
  const root = element("div", "view-switch", element("div", "joined", space, element("span", "between", say("slice.slice")), ...slices), note);
  root.setAttribute("role", "group");
  root.setAttribute("aria-label", say("slice.view"));
  return {
    element: root,
    show({ slice }: ViewState) {
      for (const each of choices) pressed(each.choice, each.slice === slice);
      note.hidden = slice === "none";
      if (slice !== "none") note.textContent = say(`slice.${slice}.note`);
    },
  };
}
