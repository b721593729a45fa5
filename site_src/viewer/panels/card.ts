/** The selected pixel's ray tree in words and numbers. */
import { KIND_NAMES, treeOf, type LineKind } from "../state/lines";
import { triple } from "../state/vectors";
import { pixelIndex, tileColour, type ViewState } from "../state/view-state";
import { VISIBILITY, type SceneData, type Trace } from "../trace/types";
import { hexOf, list as listed, number, percent, phrases, say, vector } from "../words";
import { button, element, marked, swatch } from "./element";

export interface CardLine {
  ray: number;
  light: number; // -1: the ray itself
}

const MOST_ROWS = 160; // of a tree: more is no longer read
const DEEPEST = 6; // indents; deeper rays stay there, or no room is left for words

const isHit = (trace: Trace, ray: number) => trace.object[ray] >= 0;

export function createCard(acts: { move: (right: number, down: number) => void; light: (line: CardLine | null) => void }) {
  const chip = swatch("#000");
  const pixel = element("span", "pixel-name");
  const rgb = element("span", "pixel-colour numbers");
  const arrows = element(
    "div",
    "joined arrows",
    button("\u2190", say("controls.moves.left"), () => acts.move(-1, 0), { className: "sign" }),
    button("\u2191", say("controls.moves.up"), () => acts.move(0, -1), { className: "sign" }),
    button("\u2193", say("controls.moves.down"), () => acts.move(0, 1), { className: "sign" }),
    button("\u2192", say("controls.moves.right"), () => acts.move(1, 0), { className: "sign" }),
  );
  const title = element("h2", "pixel", pixel, rgb);
  const head = element("div", "card-head", chip, title, arrows);
  const list = element("ul", "rays");
  const root = element("section", "card", head, list);
  root.setAttribute("aria-label", say("card.region"));
  let bright: { line: CardLine | null; list: Element | null } = { line: null, list: null };
  let shown: { trace: Trace | null; pixel: number; missing: boolean } = { trace: null, pixel: -1, missing: false };

  function row(kind: LineKind, depth: number, line: CardLine, ...content: (Node | string)[]) {
    const item = element("li", `ray ${kind}`, ...content);
    item.dataset.depth = String(Math.min(depth, DEEPEST));
    item.dataset.ray = String(line.ray);
    item.dataset.light = String(line.light);
    item.tabIndex = 0;
    const on = () => acts.light(line);
    const off = () => acts.light(null);
    item.addEventListener("pointerenter", on);
    item.addEventListener("pointerleave", off);
    item.addEventListener("focus", on);
    item.addEventListener("blur", off);
    return item;
  }

  function meets(trace: Trace, scene: SceneData, ray: number): HTMLElement[] {
    if (trace.parent[ray] >= 0 || trace.hitsStart.length <= ray + 1) return [];
    const [from, to] = [trace.hitsStart[ray], trace.hitsStart[ray + 1]];
    if (to - from < 2) return []; // a single hit is the one named above
    const [nearest, ...others] = Array.from({ length: to - from }, (_, k) => `${scene.objects[trace.hitsObject[from + k]]?.name ?? "?"} ${number(trace.hitsT[from + k])}`);
    return [element("span", "meets numbers", ...marked(phrases("card.meets", { nearest, others: listed(others) })))];
  }

  function rayRow(trace: Trace, scene: SceneData, ray: number): HTMLElement {
    const kind = KIND_NAMES[trace.kind[ray]];
    const object = scene.objects[trace.object[ray]];
    const material = scene.materials[trace.material[ray]];
    const first = element("span", "says", ...marked(object ? phrases(`card.hits.${kind}`, { object: object.name }) : phrases(`card.leaves.${kind}`)));
    if (material && material.name !== object?.name) first.append(element("span", "material", ` \u00b7 ${material.name}`));
    const colour = triple(trace.colour, ray);
    const brings = element("span", "brings numbers", swatch(hexOf(colour)), listed(colour.map(number)));
    brings.title = say("card.brings");
    if (trace.parent[ray] >= 0) brings.append(` \u00b7 ${say("card.share", { share: percent(trace.weight[ray]) })}`);
    const where = isHit(trace, ray)
      ? [element("span", "where numbers", say("card.t", { t: number(trace.t[ray]) }), "\u2003", vector(triple(trace.point, ray))), element("span", "where numbers", say("card.normal", { normal: vector(triple(trace.normal, ray)) }))]
      : [];
    return row(kind, trace.depth[ray], { ray, light: -1 }, first, ...where, brings, ...meets(trace, scene, ray));
  }

  function shadowRow(trace: Trace, scene: SceneData, ray: number, light: number): HTMLElement | null {
    const at = ray * trace.lights + light;
    const seen = trace.visibility[at];
    const name = scene.lights[light].name;
    const depth = trace.depth[ray] + 1;
    if (!isHit(trace, ray) || trace.localWeight[ray] === 0) return null; // a mirror has no colour of its own: no light is asked
    const gives = element("span", "where numbers", say("card.light", { diffuse: number(trace.diffuse[at]), specular: number(trace.specular[at]) }));
    if (seen === VISIBILITY.behind || seen === VISIBILITY.untested) {
      const isBehind = seen === VISIBILITY.behind;
      const says = element("span", "says", ...marked(phrases(isBehind ? "card.away" : "card.unasked", { light: name })));
      const item = element("li", "ray away", says, ...(isBehind ? [] : [gives]));
      Object.assign(item.dataset, { depth: String(Math.min(depth, DEEPEST)), ray: String(ray), light: String(light) });
      return item;
    }
    const arrives = seen === VISIBILITY.reached;
    const says = arrives ? phrases("card.arrives", { light: name }) : phrases("card.blocked", { light: name, name: scene.objects[trace.blocker[at]]?.name ?? "?" });
    return row(arrives ? "reached" : "blocked", depth, { ray, light }, element("span", "says", ...marked(says)), ...(arrives ? [gives] : []));
  }

  function rows(trace: Trace, scene: SceneData, index: number): HTMLElement[] {
    const tree = treeOf(trace, index);
    const made = tree.slice(0, MOST_ROWS).flatMap((ray) => [
      rayRow(trace, scene, ray),
      ...Array.from({ length: trace.lights }, (_, light) => shadowRow(trace, scene, ray, light)).filter((each) => each !== null),
    ]);
    return tree.length > MOST_ROWS ? [...made, element("li", "note", say("card.more", { count: tree.length - MOST_ROWS }))] : made;
  }

  /** Scrolls the list alone: the page stays where it is. */
  function showRow(row: HTMLElement) {
    const [of, at] = [list.getBoundingClientRect(), row.getBoundingClientRect()];
    if (at.top < of.top) list.scrollTop += at.top - of.top;
    else if (at.bottom > of.bottom) list.scrollTop += Math.min(at.bottom - of.bottom, at.top - of.top);
  }

  return {
    element: root,
    /** missing: this grid's rays could not be loaded. */
    show(state: ViewState, scene: SceneData, trace: Trace | null, missing: boolean) {
      const index = pixelIndex(state);
      pixel.textContent = say("card.pixel", { column: state.pixel[0], row: state.pixel[1] });
      if (shown.trace === trace && shown.pixel === index && shown.missing === missing && trace) return;
      shown = { trace, pixel: index, missing };
      if (!trace) {
        rgb.textContent = "";
        chip.style.backgroundColor = "transparent";
        list.replaceChildren(element("li", "note", say(missing ? "card.none" : "card.waiting")));
        return;
      }
      const colour = tileColour(trace, index);
      rgb.textContent = colour.join(", ");
      chip.style.backgroundColor = `rgb(${colour.join()})`;
      list.replaceChildren(...rows(trace, scene, index));
      list.scrollTop = 0;
    },
    /** Marks the line of the ray that is lit up on the stage; follow: and brings it into sight. */
    light(line: CardLine | null, follow: boolean) {
      if (bright.line === line && bright.list === list.firstElementChild) return;
      bright = { line, list: list.firstElementChild };
      for (const each of list.querySelectorAll<HTMLElement>("li.ray")) {
        const isLit = !!line && each.dataset.ray === String(line.ray) && each.dataset.light === String(line.light);
        each.classList.toggle("lit", isLit);
        if (isLit && follow) showRow(each);
      }
    },
    dispose: () => root.remove(),
  };
}
