/**
 * In the stage's corner: the scene in space as a graphics card draws it or as the rays found it, or the plane of a
 * row's or a column's rays drawn flat. Under it one sentence says what is seen.
 */
import type { Actions } from "../actions";
import { drawsShadows, isClear, isMirror, LOOKS, type Look } from "../state/look";
import { SLICES, type Slice, type ViewState } from "../state/view-state";
import type { MaterialData, SceneData } from "../trace/types";
import { list, say } from "../words";
import { button, element, named, pressed } from "../element";

type Direction = Exclude<Slice, "none">;
const DIRECTIONS = SLICES.filter((slice): slice is Direction => slice !== "none");

/** What is seen, and by which tricks: only those that the scene needs. */
function noteOf(look: Look, scene: SceneData): string {
  const { files, materials } = scene;
  if (look !== "approximate") return say(`look.${look}.note`);
  const looksUp = (is: (material: MaterialData) => boolean) => "surroundings" in files && materials.some(is);
  const tricks = [...(drawsShadows(scene) ? [say("look.tricks.shadows")] : []), ...(looksUp(isMirror) ? [say("look.tricks.mirrors")] : []), ...(looksUp(isClear) ? [say("look.tricks.glass")] : [])];
  if (tricks.length) tricks.push(say("look.tricks.everywhere"));
  return tricks.length ? say("look.approximate.note", { tricks: list(tricks) }) : say("look.plain.note");
}

export function createViewSwitch(acts: Pick<Actions, "look" | "slice">) {
  const looks = LOOKS.map((look) => ({ look, choice: button(say(`look.${look}.word`), say(`look.${look}.help`), () => acts.look(look)) }));
  const slices = DIRECTIONS.map((slice) => ({ slice, choice: button(say(`slice.${slice}.word`), say(`slice.${slice}.help`), () => acts.slice(slice)) }));
  const joined = (...parts: HTMLElement[]) => element("div", "joined", ...parts);
  const note = element("p", "view-note");
  const root = element(
    "div",
    "view-switch",
    joined(...looks.map((each) => each.choice)),
    joined(element("span", "between", say("slice.slice")), ...slices.map((each) => each.choice)),
  );
  return {
    element: named(root, say("slice.view"), "group"),
    note,
    show({ look, slice }: ViewState, scene: SceneData) {
      for (const each of looks) pressed(each.choice, slice === "none" && each.look === look);
      for (const each of slices) pressed(each.choice, each.slice === slice);
      note.textContent = slice === "none" ? noteOf(look, scene) : say(`slice.${slice}.note`);
    },
  };
}
