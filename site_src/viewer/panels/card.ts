/** The selected pixel's ray tree in words and numbers. */
import { KIND_NAMES, treeOf, type LineKind } from "../state/lines";
import { triple } from "../state/vectors";
import { pixelIndex, tileColour, type ViewState } from "../state/view-state";
import { VISIBILITY, type SceneData, type Trace } from "../trace/types";
import { CARD_WORDS as WORDS, CONTROL_WORDS, hexOf, KIND_WORDS, vector, number } from "../words";
import { button, element, swatch } from "./element";

export interface CardLine {
  ray: number;
  light: number; // -1: the ray itself
}

const MOST_ROWS = 160; // of a tree: more is no longer read
const DEEPEST = 6; // indents; deeper rays stay there, or no room is left for words

const isHit = (trace: Trace, ray: number) => trace.object[ray] >= 0;

const bold = (text: string) => element("b", "", text);

export function createCard(acts: { move: (right: number, down: number) => void; light: (line: CardLine | null) => void }) {
  const chip = swatch("#000");
  const pixel = element("span", "pixel-name");
  const rgb = element("span", "pixel-colour numbers");
  const moves = CONTROL_WORDS.moves;
  const arrows = element(
    "div",
    "joined arrows",
    button("\u2190", moves.left, () => acts.move(-1, 0), { className: "sign" }),
    button("\u2191", moves.up, () => acts.move(0, -1), { className: "sign" }),
    button("\u2193", moves.down, () => acts.move(0, 1), { className: "sign" }),
    button("\u2192", moves.right, () => acts.move(1, 0), { className: "sign" }),
  );
  const title = element("h2", "pixel", pixel, rgb);
  const head = element("div", "card-head", chip, title, arrows);
  const list = element("ul", "rays");
  const root = element("section", "card", head, list);
  root.setAttribute("aria-label", WORDS.region);
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
    const line = element("span", "meets numbers", `${WORDS.meets} `);
    for (let k = from; k < to; k++) {
      const text = `${scene.objects[trace.hitsObject[k]]?.name ?? "?"} ${number(trace.hitsT[k])}`;
      line.append(k > from ? ", " : "", k === from ? bold(`${text} (${WORDS.nearest})`) : text);
    }
    return [line];
  }

  function rayRow(trace: Trace, scene: SceneData, ray: number): HTMLElement {
    const kind = KIND_NAMES[trace.kind[ray]];
    const object = scene.objects[trace.object[ray]];
    const material = scene.materials[trace.material[ray]];
    const words = object ? WORDS.hits(KIND_WORDS[kind], object.name) : WORDS.leaves(KIND_WORDS[kind]);
    const first = element("span", "says", bold(words[0]), words[1], bold(words[2]));
    if (material && material.name !== object?.name) first.append(element("span", "material", ` \u00b7 ${material.name}`));
    const colour = triple(trace.colour, ray);
    const brings = element("span", "brings numbers", swatch(hexOf(colour)), colour.map(number).join(", "));
    brings.title = WORDS.brings;
    if (trace.parent[ray] >= 0) brings.append(` \u00b7 ${WORDS.share(trace.weight[ray])}`);
    const where = isHit(trace, ray)
      ? [element("span", "where numbers", WORDS.t(trace.t[ray]), "\u2003", vector(triple(trace.point, ray))), element("span", "where numbers", WORDS.normal(triple(trace.normal, ray)))]
      : [];
    return row(kind, trace.depth[ray], { ray, light: -1 }, first, ...where, brings, ...meets(trace, scene, ray));
  }

  function shadowRow(trace: Trace, scene: SceneData, ray: number, light: number): HTMLElement | null {
    const at = ray * trace.lights + light;
    const seen = trace.visibility[at];
    const name = scene.lights[light].name;
    const depth = trace.depth[ray] + 1;
    if (!isHit(trace, ray) || trace.localWeight[ray] === 0) return null; // a mirror has no colour of its own: no light is asked
    const gives = element("span", "where numbers", WORDS.light(trace.diffuse[at], trace.specular[at]));
    if (seen === VISIBILITY.behind || seen === VISIBILITY.untested) {
      const isBehind = seen === VISIBILITY.behind;
      const [a, b] = WORDS.awayLine(name);
      const says = isBehind ? element("span", "says", a, b, bold(WORDS.away)) : element("span", "says", bold(name), ` ${WORDS.unasked}`);
      const item = element("li", "ray away", says, ...(isBehind ? [] : [gives]));
      Object.assign(item.dataset, { depth: String(Math.min(depth, DEEPEST)), ray: String(ray), light: String(light) });
      return item;
    }
    const [a, b] = WORDS.shadow(name);
    const arrives = seen === VISIBILITY.reached;
    const end = arrives ? WORDS.arrives : WORDS.blockedBy(scene.objects[trace.blocker[at]]?.name ?? "?");
    return row(arrives ? "reached" : "blocked", depth, { ray, light }, element("span", "says", bold(a), b, bold(end)), ...(arrives ? [gives] : []));
  }

  function rows(trace: Trace, scene: SceneData, index: number): HTMLElement[] {
    const tree = treeOf(trace, index);
    const made = tree.slice(0, MOST_ROWS).flatMap((ray) => [
      rayRow(trace, scene, ray),
      ...Array.from({ length: trace.lights }, (_, light) => shadowRow(trace, scene, ray, light)).filter((each) => each !== null),
    ]);
    return tree.length > MOST_ROWS ? [...made, element("li", "note", WORDS.more(tree.length - MOST_ROWS))] : made;
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
      pixel.textContent = WORDS.pixel(...state.pixel);
      if (shown.trace === trace && shown.pixel === index && shown.missing === missing && trace) return;
      shown = { trace, pixel: index, missing };
      if (!trace) {
        rgb.textContent = "";
        chip.style.backgroundColor = "transparent";
        list.replaceChildren(element("li", "note", missing ? WORDS.none : WORDS.waiting));
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
