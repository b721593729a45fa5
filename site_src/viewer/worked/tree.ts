/** How the selected camera ray goes through a mesh's tree of boxes: what it visits in which order, and what a tree that is cut
 *  off at some level would cost it, and every other ray. */
import { button, disable, element, named } from "../element";
import { svg } from "../panels/svg";
import type { Drawn } from "../stage/renderer";
import { pixelIndex } from "../state/view-state";
import type { Vec3 } from "../state/vectors";
import type { View, WorkedTree } from "../trace/types";
import { fixed, grouped, say } from "../words";
import { createChoice, drawSquare } from "./choice";
import type { Worked, WorkedPanel } from "./types";

type Cut = NonNullable<View["tree_depth"]>;
const CUTS: readonly Cut[] = ["none", "sphere", "1", "2", "4", "8", "all"];
const WHAT = ["missed", "entered", "cutOff"] as const;
const SIDE = 150; // CSS pixels, of the tiles
const ROUND = 40; // segments of a circle

interface Visit {
  box: readonly number[]; // low, high, level, triangles in it
  what: (typeof WHAT)[number];
  t: number;
  isLeaf: boolean; // its triangles are tested
}

const levelOf = ({ box }: Pick<Visit, "box">): number => box[6];
const last = (cut: Cut): number => (cut === "all" ? Infinity : Number(cut)); // the deepest level that is left; NaN without a tree

/** In order, with the boxes of the last level as leaves. */
function visitsOf({ visits, boxes }: WorkedTree, ray: number, cut: Cut): Visit[] {
  const flat = visits[ray];
  const all = Array.from({ length: flat.length / 3 }, (_, k) => ({ box: boxes[flat[3 * k]], what: WHAT[flat[3 * k + 1]], t: flat[3 * k + 2] }));
  const kept = all.filter((visit) => levelOf(visit) <= last(cut));
  return kept.map((visit, k) => ({ ...visit, isLeaf: visit.what === "entered" && (levelOf(visit) === last(cut) || k + 1 === kept.length || levelOf(kept[k + 1]) <= levelOf(visit)) }));
}

const testsOf = ({ box, isLeaf }: Visit): number => 1 + (isLeaf ? box[7] : 0);

function edges([x0, y0, z0, x1, y1, z1]: readonly number[]): [Vec3, Vec3][] {
  const corner = (k: number): Vec3 => [k & 1 ? x1 : x0, k & 2 ? y1 : y0, k & 4 ? z1 : z0];
  return [0, 1, 2, 3, 4, 5, 6, 7].flatMap((k) => [1, 2, 4].filter((bit) => !(k & bit)).map((bit): [Vec3, Vec3] => [corner(k), corner(k | bit)]));
}

function circles([x, y, z, radius]: readonly number[]): [Vec3, Vec3][] {
  const on = (axis: number, k: number): Vec3 => {
    const at: [number, number, number] = [x, y, z];
    at[(axis + 1) % 3] += radius * Math.cos((2 * Math.PI * k) / ROUND);
    at[(axis + 2) % 3] += radius * Math.sin((2 * Math.PI * k) / ROUND);
    return at;
  };
  return [0, 1, 2].flatMap((axis) => Array.from({ length: ROUND }, (_, k): [Vec3, Vec3] => [on(axis, k), on(axis, k + 1)]));
}

function path({ projection }: Drawn, ends: readonly (readonly [Vec3, Vec3])[], className: string): SVGElement {
  const seen = ends.map((pair) => pair.map(projection.project)).filter(([a, b]) => a.depth > 0 && b.depth > 0);
  return svg("path", { d: seen.map(([a, b]) => `M${a.x.toFixed(1)} ${a.y.toFixed(1)}L${b.x.toFixed(1)} ${b.y.toFixed(1)}`).join(""), class: `box ${className}` });
}

/** The level's boxes, of the whole tree the outermost and those that the ray enters, faint; of those visited so far each as what came of it; the current one strongest. */
function boxesOn(drawn: Drawn, tree: WorkedTree, cut: Cut, visits: readonly Visit[], all: readonly Visit[]): SVGElement[] {
  if (cut === "none") return [];
  if (cut === "sphere") return [path(drawn, circles(tree.sphere), "level")];
  const done = WHAT.map((what) => path(drawn, visits.slice(0, -1).filter((visit) => visit.what === what).flatMap(({ box }) => edges(box)), what));
  const now = visits.at(-1);
  const level = cut === "all" ? all.filter(({ what }, k) => !k || what === "entered").map(({ box }) => box) : tree.boxes.filter((box) => box[6] === last(cut));
  return [...(visits.length ? [] : [path(drawn, level.flatMap(edges), "level")]), ...done, ...(now ? [path(drawn, edges(now.box), `${now.what} now`)] : [])];
}

function told(visit: Visit): string {
  const { what, t, isLeaf, box } = visit;
  const said = say(`worked.tree.${what}`, { level: levelOf(visit), t: fixed(t, 2) });
  return isLeaf ? `${said} ${say("worked.tree.leaf", { count: box[7] })}` : said;
}

/** Dark where nothing had to be tested, bright where much had; by the logarithm. */
function scaleOf(tests: readonly number[]) {
  const most = Math.log(Math.max(...tests) + 1);
  return (k: number) => {
    const share = most > 0 ? Math.log(tests[k]) / most : 0;
    return `rgb(${Math.round(30 + 222 * share)}, ${Math.round(36 + 196 * share)}, ${Math.round(66 + 0 * share)})`;
  };
}

function createSteps(move: (by: 1 | -1) => void) {
  const [back, on] = ([-1, 1] as const).map((by) => button(by < 0 ? "\u2039" : "\u203a", say(by < 0 ? "worked.tree.back" : "worked.tree.on"), () => move(by), { className: "sign" }));
  const place = element("span", "numbers");
  const root = element("div", "worked-steps", back, place, on);
  root.addEventListener("keydown", (event) => {
    const by = ({ ArrowLeft: -1, ArrowRight: 1 } as const)[event.key as "ArrowLeft"];
    if (!by) return;
    event.preventDefault(); // here the arrows go from box to box, not from pixel to pixel
    event.stopPropagation();
    move(by);
  });
  return {
    element: root,
    show(at: number, of: number) {
      place.textContent = say("worked.tree.place", { at, of });
      disable(back, at === 0);
      disable(on, at === of);
    },
  };
}

export function createTree(changed: () => void): WorkedPanel {
  let cut: Cut = "all";
  let at = 0; // visits that are shown
  let visits: Visit[] = [];
  let before = "";
  const choice = createChoice(say("worked.tree.depth"), CUTS.map((each) => [each, say(`worked.tree.cut.${each}`), say(`worked.tree.cutHelp.${each}`)] as const), (to) => ((cut = to), (at = 0), changed()));
  const steps = createSteps((by) => ((at = Math.min(visits.length, Math.max(0, at + by))), changed()));
  const says = element("p", "worked-note");
  says.setAttribute("aria-live", "polite");
  const total = element("p", "worked-title numbers");
  const tiles = named(element("canvas", "worked-tiles"), say("worked.tree.tiles"), "img");
  const tilesSay = element("p", "worked-note", say("worked.tree.tilesSay"));
  return {
    element: element("div", "", choice.element, total, steps.element, says, tiles, tilesSay),
    show({ drawn, data, view, isAsking, isNew }: Worked, lines) {
      const { tree } = data;
      const { state } = drawn.view;
      if (!tree || state.n !== tree.n) return false;
      if (isNew) cut = view.tree_depth ?? "all";
      const ray = pixelIndex(state);
      if (isNew || before !== `${ray}`) at = 0;
      before = `${ray}`;
      visits = cut === "none" || cut === "sphere" ? [] : visitsOf(tree, ray, cut);
      const done = visits.slice(0, at);
      choice.show(cut);
      steps.element.hidden = !visits.length || isAsking;
      steps.show(at, visits.length);
      const sofar = done.reduce((sum, visit) => sum + testsOf(visit), 0);
      total.textContent = isAsking ? "" : at ? say("worked.tree.sofar", { done: grouped(sofar), all: grouped(tree.tests[cut][ray]) }) : say("worked.tree.tests", { count: tree.tests[cut][ray], all: grouped(tree.tests[cut][ray]) });
      says.textContent = at ? told(visits[at - 1]) : "";
      tiles.hidden = tilesSay.hidden = isAsking;
      if (!isAsking) drawSquare(tiles, tree.n, scaleOf(tree.tests[cut]), state.pixel, SIDE * 2);
      lines.append(...boxesOn(drawn, tree, cut, done, visits));
      return true;
    },
  };
}
