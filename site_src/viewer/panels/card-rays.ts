/** The selected pixel's rays as an indented list: every number of every ray. */
import { isGiving } from "../state/events";
import type { LightRow, RayRow } from "../state/ray-rows";
import type { LitLine } from "../state/types";
import type { Vec3 } from "../trace/types";
import { hexOf, list as listed, number, percent, phrases, say, tone, vector } from "../words";
import { clickable, element, marked, swatch } from "../element";
import type { LineActs, RaysView } from "./card-types";
import { lightsUp } from "./lights-up";
import { markRow } from "./lit-row";
import { lightWords, rayWords } from "./ray-words";

const MOST_ROWS = 160; // of a tree: more is no longer read
const DEEPEST = 6; // indents; deeper rays stay there, or no room is left for words

const joined = (...parts: string[]) => parts.join(" \u00b7 ");
const sample = (colour: Vec3, words: string) => element("span", "shown-colour", swatch(hexOf(colour)), words);
const figures = (className: string, ...parts: (Node | string)[]) => element("span", `${className} numbers`, ...parts);

export function createRays(acts: LineActs): RaysView {
  const list = element("ul", "rays");

  function item(kind: string, depth: number, line: LitLine, ...content: Node[]) {
    const made = element("li", `ray ${kind}`, ...content);
    Object.assign(made.dataset, { depth: Math.min(depth, DEEPEST), ray: line.ray, light: line.light });
    lightsUp(made, (on) => acts.light(on ? line : null));
    return clickable(made, () => acts.goToEvent(line.ray, line.light));
  }

  function rayItem(row: RayRow) {
    const says = element("span", "says", element("span", "ray-number", String(row.number)), ...marked(rayWords(row)));
    if (row.material && row.material !== row.object) says.append(element("span", "material", ` \u00b7 ${row.material}`));
    const tests = say("card.tests", { count: row.tests });
    const where = row.object
      ? [
          figures("where", say("card.t", { t: number(row.t) }), "\u2003", vector(row.point)),
          figures("where", joined(say("card.normal", { normal: vector(row.normal) }), tests)),
        ]
      : [figures("where", tests)];
    const brings = figures("brings", sample(row.colour, listed(row.colour.map(number))));
    brings.title = say("card.brings");
    if (row.of) brings.append(` \u00b7 ${say("card.share", { share: percent(row.weight), ray: row.of })}`);
    const [nearest, ...others] = row.hits.map(({ name, t }) => `${name} ${number(t)}`);
    const meets = others.length ? [figures("meets", ...marked(phrases("card.meets", { nearest, others: listed(others) })))] : [];
    const own = row.lights.length ? [figures("where", ...(row.base ? [say("card.base", { colour: tone(row.base) }), " \u00b7 "] : []), say("card.ambient", { colour: tone(row.ambient) }), ...(row.keeps < 1 ? [` \u00b7 ${say("card.keeps", { share: percent(row.keeps) })}`] : []))] : [];
    return item(row.kind, row.depth, { ray: row.ray, light: -1 }, says, ...where, ...meets, ...own, brings);
  }

  function lightItem(row: RayRow, light: LightRow) {
    const kind = light.seen === "reached" || light.seen === "blocked" ? light.seen : "away";
    const gives = figures("where", joined(say("card.light", { diffuse: number(light.diffuse), specular: number(light.specular) }), say("card.gives")), " ", sample(light.gives, tone(light.gives)));
    const says = element("span", "says", ...marked(lightWords(light)));
    return item(kind, row.depth + 1, { ray: row.ray, light: light.light }, says, ...(isGiving(light) ? [gives] : []));
  }

  return {
    element: list,
    show({ rows }) {
      const made = rows.slice(0, MOST_ROWS).flatMap((row) => [rayItem(row), ...row.lights.map((light) => lightItem(row, light))]);
      const left = rows.length - MOST_ROWS;
      list.replaceChildren(...made, ...(left > 0 ? [element("li", "note", say("card.more", { count: left }))] : []));
      list.scrollTop = 0;
    },
    light(line, event) {
      const lit = line ?? event;
      const items = [...list.querySelectorAll<HTMLElement>("li.ray")];
      markRow(list, items, items.find(({ dataset }) => dataset.ray === String(lit?.ray) && dataset.light === String(lit?.light)) ?? null, !line);
    },
  };
}
