/** What a drawn ray tree is made of: nodes, edges, marks of lights. Kinds differ in outline and dash, not in hue alone. */
import { LINES } from "../palette";
import { isGiving } from "../state/events";
import type { LightRow, RayRow } from "../state/ray-rows";
import { RAYS } from "../trace/kinds";
import { hexOf, percent, plain, say } from "../words";
import { lightsUp } from "./lights-up";
import { lightWords, rayWords } from "./ray-words";
import { element } from "../element";
import { svg } from "./svg";
import { left, NODE, top, type Placed } from "./tree-layout";

const LETTERS = 12; // of a name that fit
const MARKS = 6; // lights shown one by one

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

const short = (name: string) => (name.length > LETTERS ? `${name.slice(0, LETTERS - 1)}\u2026` : name);
const dashOf = (kind: RayRow["kind"]) => (LINES[kind].dash[0] === 1 ? "none" : LINES[kind].dash.map((each) => each / 2).join(" "));
const text = (className: string, y: number, words: string) => svg("text", { class: className, x: NODE.width / 2, y, "text-anchor": "middle" }, words);

/** A dot: the light arrives; a cross: it is blocked; a stroke: the surface faces away. */
function mark(seen: LightRow["seen"], x: number) {
  if (seen === "blocked") return svg("path", { class: "mark blocked", d: `M${x - 4} -4l8 8m0 -8l-8 8` });
  return seen === "away" || seen === "off" ? svg("path", { class: "mark away", d: `M${x - 4} 0h8` }) : svg("circle", { class: "mark reached", cx: x, cy: 0, r: 4 });
}

function marks(lights: readonly LightRow[]) {
  const group = svg("g", { transform: `translate(${NODE.width / 2} ${NODE.height + 11})` });
  const arrived = lights.filter(isGiving).length;
  if (lights.length > MARKS) group.append(svg("text", { class: "node-kind", y: 4, "text-anchor": "middle" }, say("tree.lights", { arrived, of: lights.length })));
  else group.append(...lights.map(({ seen }, k) => mark(seen, (k - (lights.length - 1) / 2) * 14)));
  return group;
}

/** What the marks mean. */
export const treeKey = () =>
  element("p", "tree-key", ...(["reached", "blocked", "away"] as const).map((seen) => {
    const sign = svg("svg", { width: 12, height: 12, viewBox: "-6 -6 12 12", "aria-hidden": "true" }, mark(seen, 0));
    return element("span", "", sign, ` ${say(`tree.${seen}`)}`);
  }));

/** A node as a button: says its words, does `press` by click and key. */
function node(at: Placed, className: string, words: readonly string[], press: () => void, ...parts: SVGElement[]) {
  const group = svg("g", { class: `node ${className}`, transform: `translate(${left(at)} ${top(at)})`, role: "button", tabindex: -1, "aria-label": words.join("; ") });
  group.append(svg("title", {}, words.join("\n")), ...parts);
  group.addEventListener("click", press);
  group.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    press();
  });
  return group;
}

/** light: lights its ray up on the stage, or no longer. */
export function rayNode(at: Placed, row: RayRow, press: () => void, light: (on: boolean) => void) {
  const words = [`${row.number}: ${plain(rayWords(row))}`, ...(row.of ? [say("card.share", { share: percent(row.weight), ray: row.of })] : []), ...row.lights.map((each) => plain(lightWords(each)))];
  const made = node(
    at,
    row.kind + (row.object ? "" : " open"),
    words,
    press,
    svg("path", { class: "outline", d: OUTLINES[RAYS[row.kind].outline], "stroke-dasharray": row.object ? "none" : "3 4" }),
    text("node-kind", 21, `${row.number} ${say(`tree.kind.${row.kind}`)}`),
    svg("circle", { class: "node-colour", cx: NODE.width / 2, cy: 0, r: 6, fill: hexOf(row.colour) }),
    text("node-name", 36, short(row.object || say("tree.leaves"))),
    ...(row.lights.length ? [marks(row.lights)] : []),
  );
  lightsUp(made, light);
  return made;
}

export function foldNode(at: Placed, open: () => void) {
  const { folded } = at;
  const share = folded.filter((each) => !folded.some(({ number }) => number === each.of)).reduce((sum, each) => sum + each.share, 0);
  const words = say("tree.folded", { count: folded.length, share: percent(share) });
  return node(at, "fold", [words], open, svg("path", { class: "outline", d: OUTLINES.pill }), text("node-name", 27, say("tree.more", { count: folded.length })));
}

/** From a node to what it led to, with the share of it that came back. */
export const edgesOf = (node: Placed): SVGElement[] =>
  node.below.flatMap((each) => {
    const [x, y] = [left(node) + NODE.width / 2, top(node) + NODE.height + (node.row?.lights.length ? 20 : 0)];
    const [toX, toY] = [left(each) + NODE.width / 2, top(each)];
    const kind = each.row?.kind;
    const line = svg("path", { class: `edge ${kind ?? "fold"}`, d: `M${x} ${y}C${x} ${y + 18} ${toX} ${toY - 24} ${toX} ${toY - 6}`, "stroke-dasharray": kind ? dashOf(kind) : "2 4" });
    const share = each.row && each.row.weight < 1 ? [svg("text", { class: "edge-share", x: toX + 10, y: toY - 6 }, percent(each.row.weight))] : [];
    return [line, ...share];
  });
