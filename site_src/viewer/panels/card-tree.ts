/** The ray tree as a drawing: a node a ray, below it what it led to. Kinds differ in outline and dash, not in hue alone. */
import { LINES } from "../palette";
import { isGiving } from "../state/events";
import type { LightRow, RayRow } from "../state/ray-rows";
import type { LitLine } from "../state/types";
import { RAYS } from "../trace/kinds";
import { hexOf, percent, plain, say } from "../words";
import { lightWords, rayWords, type LineActs } from "./card-rays";
import { button, element, setWord } from "./element";
import { svg } from "./svg";

const SLOT = 126; // pixels across, for a leaf
const NODE = { width: 114, height: 46 };
const LEVEL = 98; // pixels down
const LETTERS = 12; // of a name that fit
const LEGIBLE = 0.92; // smaller than this a tree is drawn on request only
const MANY = 20; // rays: in a larger tree
const SMALL = 0.01; // those with a smaller share of the pixel are folded
const MARKS = 6; // lights shown one by one

interface Placed {
  row: RayRow | null; // null: folded rays
  folded: readonly RayRow[];
  x: number; // leaf slots
  depth: number;
  below: Placed[];
}

/** Leaves side by side, each parent over the middle of what it led to. */
function place(rows: readonly RayRow[], isOpen: boolean): { root: Placed; across: number; down: number } {
  let [across, down] = [0, 0];
  const childrenOf = (row: RayRow) => rows.filter(({ of }) => of === row.number);
  const under = (row: RayRow): RayRow[] => [row, ...childrenOf(row).flatMap(under)];
  const leaf = (row: RayRow | null, folded: readonly RayRow[], depth: number): Placed => ({ row, folded, x: across++, depth, below: [] });
  function put(row: RayRow, depth: number): Placed {
    down = Math.max(down, depth + 1);
    const all = childrenOf(row);
    const small = isOpen || rows.length <= MANY ? [] : all.filter(({ share }) => share < SMALL);
    const below = all.filter((each) => !small.includes(each)).map((each) => put(each, depth + 1));
    if (small.length) {
      down = Math.max(down, depth + 2);
      below.push(leaf(null, small.flatMap(under), depth + 1));
    }
    if (!below.length) return leaf(row, [], depth);
    return { row, folded: [], x: (below[0].x + below[below.length - 1].x) / 2, depth, below };
  }
  return { root: put(rows[0], 0), across, down };
}

const pill = (w: number, h: number, gap = 0) => {
  const [from, to, r] = [h / 2, w - h / 2, h / 2 - gap];
  return `M${from} ${gap}H${to}A${r} ${r} 0 0 1 ${to} ${h - gap}H${from}A${r} ${r} 0 0 1 ${from} ${gap}Z`;
};
const OUTLINES: Readonly<Record<string, string>> = (({ width: w, height: h }) => ({
  box: `M0 0H${w}V${h}H0Z`,
  pill: pill(w, h),
  hexagon: `M9 0H${w - 9}L${w} ${h / 2}L${w - 9} ${h}H9L0 ${h / 2}Z`,
  doublePill: pill(w, h) + pill(w, h, 4),
}))(NODE);

const left = (node: Placed) => node.x * SLOT + (SLOT - NODE.width) / 2;
const top = (node: Placed) => node.depth * LEVEL + 8;
const short = (name: string) => (name.length > LETTERS ? `${name.slice(0, LETTERS - 1)}\u2026` : name);
const dashOf = (kind: RayRow["kind"]) => (LINES[kind].dash[0] === 1 ? "none" : LINES[kind].dash.map((each) => each / 2).join(" "));

/** A dot: the light arrives; a cross: it is blocked; a stroke: the surface faces away. */
function mark({ seen }: LightRow, x: number) {
  if (seen === "blocked") return svg("path", { class: "mark blocked", d: `M${x - 4} -4l8 8m0 -8l-8 8` });
  return seen === "away" || seen === "off" ? svg("path", { class: "mark away", d: `M${x - 4} 0h8` }) : svg("circle", { class: "mark reached", cx: x, cy: 0, r: 4 });
}

function marks(lights: readonly LightRow[]) {
  const group = svg("g", { transform: `translate(${NODE.width / 2} ${NODE.height + 11})` });
  const arrived = lights.filter(isGiving).length;
  if (lights.length > MARKS) group.append(svg("text", { class: "node-kind", y: 4, "text-anchor": "middle" }, say("tree.lights", { arrived, of: lights.length })));
  else group.append(...lights.map((light, k) => mark(light, (k - (lights.length - 1) / 2) * 14)));
  return group;
}

export function createTree(acts: LineActs) {
  const drawing = svg("svg", { role: "group", "aria-label": say("tree.region") });
  const key = element("p", "tree-key", ...(["reached", "blocked", "away"] as const).flatMap((seen) => {
    const sign = svg("svg", { width: 12, height: 12, viewBox: "-6 -6 12 12", "aria-hidden": "true" });
    sign.append(mark({ seen } as LightRow, 0));
    return [element("span", "", sign, ` ${say(`tree.${seen}`)}`)];
  }));
  const window = element("div", "tree-window", drawing as unknown as HTMLElement);
  const fit = button(say("tree.fit.word"), say("tree.fit.help"), () => {
    fits = !fits;
    scale();
    showNode(nodes.get(lit?.ray ?? rows[0].ray) ?? nodes.get(rows[0].ray)!, true);
  }, { className: "tree-fit" });
  const root = element("div", "tree", window, element("div", "tree-foot", key, fit));
  let size = { width: 1, height: 1 }; // of the drawing, unscaled
  let fits = false; // the whole tree, however small
  let rows: readonly RayRow[] = [];
  let isOpen = false;
  let nodes = new Map<number, SVGElement>(); // by ray
  let lit: LitLine | null = null;

  function nodeOf(node: Placed): SVGElement {
    const { row } = node;
    const group = svg("g", { class: `node ${row?.kind ?? "fold"}${row?.object === "" ? " open" : ""}`, transform: `translate(${left(node)} ${top(node)})`, role: "button", tabindex: -1 });
    if (!row) return foldNode(group, node);
    const words = [`${row.number}: ${plain(rayWords(row))}`, ...(row.of ? [say("card.share", { share: percent(row.weight), ray: row.of })] : []), ...row.lights.map((light) => plain(lightWords(light)))];
    group.setAttribute("aria-label", words.join("; "));
    group.append(
      svg("title", {}, words.join("\n")),
      svg("path", { class: "outline", d: OUTLINES[RAYS[row.kind].outline], "stroke-dasharray": row.object ? "none" : "3 4" }),
      svg("text", { class: "node-kind", x: NODE.width / 2, y: 21, "text-anchor": "middle" }, `${row.number} ${say(`tree.kind.${row.kind}`)}`),
      svg("circle", { class: "node-colour", cx: NODE.width / 2, cy: 0, r: 6, fill: hexOf(row.colour) }),
      svg("text", { class: "node-name", x: NODE.width / 2, y: 36, "text-anchor": "middle" }, short(row.object || say("tree.leaves"))),
      ...(row.lights.length ? [marks(row.lights)] : []),
    );
    listen(group, () => acts.tell(row.ray, -1));
    group.addEventListener("pointerenter", () => acts.light({ ray: row.ray, light: -1 }));
    group.addEventListener("pointerleave", () => acts.light(null));
    group.addEventListener("focus", () => acts.light({ ray: row.ray, light: -1 }));
    group.addEventListener("blur", () => acts.light(null));
    nodes.set(row.ray, group);
    return group;
  }

  function foldNode(group: SVGElement, { folded }: Placed) {
    const share = folded.filter((each) => !folded.some(({ number }) => number === each.of)).reduce((sum, each) => sum + each.share, 0);
    const words = say("tree.folded", { count: folded.length, share: percent(share) });
    group.setAttribute("aria-label", words);
    group.append(svg("title", {}, words), svg("path", { class: "outline", d: OUTLINES.pill }), svg("text", { class: "node-name", x: NODE.width / 2, y: 27, "text-anchor": "middle" }, say("tree.more", { count: folded.length })));
    listen(group, open);
    return group;
  }

  function listen(group: SVGElement, press: () => void) {
    group.addEventListener("click", press);
    group.addEventListener("keydown", (event) => {
      if (event.key !== "Enter" && event.key !== " ") return;
      event.preventDefault();
      press();
    });
  }

  function open() {
    isOpen = true;
    draw();
    (drawing.querySelector('[tabindex="0"]') as SVGElement | null)?.focus();
  }

  function edges(node: Placed): SVGElement[] {
    return node.below.flatMap((each) => {
      const [x, y] = [left(node) + NODE.width / 2, top(node) + NODE.height + (node.row?.lights.length ? 20 : 0)];
      const [toX, toY] = [left(each) + NODE.width / 2, top(each)];
      const kind = each.row?.kind;
      const line = svg("path", { class: `edge ${kind ?? "fold"}`, d: `M${x} ${y}C${x} ${y + 18} ${toX} ${toY - 24} ${toX} ${toY - 6}`, "stroke-dasharray": kind ? dashOf(kind) : "2 4" });
      const share = each.row && each.row.weight < 1 ? [svg("text", { class: "edge-share", x: toX + 10, y: toY - 6 }, percent(each.row.weight))] : [];
      return [line, ...share, ...edges(each)];
    });
  }

  function draw() {
    nodes = new Map();
    const placed = place(rows, isOpen);
    const all = (node: Placed): Placed[] => [node, ...node.below.flatMap(all)];
    const [width, height] = [placed.across * SLOT, (placed.down - 1) * LEVEL + NODE.height + 30];
    size = { width, height };
    drawing.setAttribute("viewBox", `0 0 ${width} ${height}`);
    const places = all(placed.root);
    const made = places.map(nodeOf);
    drawing.replaceChildren(...edges(placed.root), ...made);
    made[0].setAttribute("tabindex", "0");
    walkWithArrows(places, made);
    scale();
    show(lit, false);
  }

  /** Up to the parent, down to the first child, sideways along the row. */
  function walkWithArrows(places: readonly Placed[], made: readonly SVGElement[]) {
    const go = (from: number, to: number) => {
      if (to < 0) return;
      made[from].setAttribute("tabindex", "-1");
      made[to].setAttribute("tabindex", "0");
      made[to].focus();
      showNode(made[to]);
    };
    const beside = (at: number, by: 1 | -1) => {
      const level = places.filter(({ depth }) => depth === places[at].depth).sort((a, b) => a.x - b.x);
      return places.indexOf(level[level.indexOf(places[at]) + by]);
    };
    made.forEach((node, at) =>
      node.addEventListener("keydown", (event) => {
        const to = {
          ArrowUp: () => places.findIndex(({ below }) => below.includes(places[at])),
          ArrowDown: () => places.indexOf(places[at].below[0]),
          ArrowLeft: () => beside(at, -1),
          ArrowRight: () => beside(at, 1),
        }[event.key];
        if (!to) return;
        event.preventDefault();
        go(at, to());
      }),
    );
  }

  /** As large as the panel lets it be, and legible; or whole. */
  function scale() {
    const room = Math.min(window.clientWidth / size.width, window.clientHeight / size.height);
    const share = room > 0 ? Math.min(1, fits ? room : Math.max(LEGIBLE, room)) : 1;
    for (const side of ["width", "height"] as const) drawing.setAttribute(side, String(Math.floor(size[side] * share)));
    fit.hidden = !fits && (room <= 0 || room >= LEGIBLE);
    const does = fits ? "large" : "fit";
    setWord(fit, say(`tree.${does}.word`), say(`tree.${does}.help`));
    cue();
  }

  /** Where the drawing goes on, it fades. */
  function cue() {
    const { scrollLeft: x, scrollTop: y, scrollWidth, scrollHeight, clientWidth, clientHeight } = window;
    const more = { left: x > 1, right: x + clientWidth < scrollWidth - 1, top: y > 1, bottom: y + clientHeight < scrollHeight - 1 };
    for (const [side, on] of Object.entries(more)) window.classList.toggle(`more-${side}`, on);
  }
  window.addEventListener("scroll", cue);
  new ResizeObserver(() => rows.length && scale()).observe(window);
  window.addEventListener("pointermove", (event) => {
    if (event.pointerType === "mouse" && event.buttons === 1) window.scrollBy(-event.movementX, -event.movementY);
  });

  /** Scrolls the drawing alone. */
  function showNode(node: SVGElement, middle = false) {
    const [of, at] = [window.getBoundingClientRect(), node.getBoundingClientRect()];
    if (middle || at.left < of.left || at.right > of.right || node === nodes.get(rows[0].ray)) window.scrollLeft += (at.left + at.right - of.left - of.right) / 2;
    if (at.top < of.top || at.bottom > of.bottom) window.scrollTop += (at.top + at.bottom - of.top - of.bottom) / 2;
  }

  function show(line: LitLine | null, follow: boolean) {
    lit = line;
    if (line && follow && !nodes.has(line.ray) && rows.some(({ ray }) => ray === line.ray)) {
      isOpen = true;
      draw();
    }
    for (const [ray, node] of nodes) node.classList.toggle("lit", ray === line?.ray);
    const node = line && nodes.get(line.ray);
    if (node && follow) showNode(node);
  }

  return {
    element: root,
    show(next: readonly RayRow[]) {
      rows = next;
      isOpen = false;
      lit = null;
      draw();
      window.scrollTop = 0;
      showNode(nodes.get(rows[0].ray)!);
    },
    light: show,
  };
}
