/** The ray tree as a drawing: a node a ray, below it what it led to. */
import type { RayRow } from "../state/ray-rows";
import type { LitLine } from "../state/types";
import { say } from "../words";
import type { LineActs, RaysView } from "./card-types";
import { element } from "../element";
import { svg } from "./svg";
import { walkWithArrows } from "./tree-arrows";
import { layOut, type Placed } from "./tree-layout";
import { edgesOf, foldNode, rayNode, treeKey } from "./tree-nodes";
import { createTreeWindow } from "./tree-window";

export function createTree(acts: LineActs): RaysView {
  const drawing = svg("svg", { role: "group", "aria-label": say("tree.region") });
  const view = createTreeWindow(drawing, () => view.showNode(nodes.get(lit?.ray ?? rows[0].ray) ?? rootNode(), true));
  let rows: readonly RayRow[] = [];
  let isOpen = false;
  let nodes = new Map<number, SVGElement>(); // by ray
  let lit: LitLine | null = null;

  const rootNode = () => nodes.get(rows[0].ray)!;
  const showNode = (node: SVGElement) => view.showNode(node, node === rootNode());

  function nodeOf(at: Placed): SVGElement {
    const { row } = at;
    if (!row) return foldNode(at, open);
    const line = { ray: row.ray, light: -1 };
    const node = rayNode(at, row, () => acts.goToEvent(row.ray, -1), (on) => acts.light(on ? line : null));
    nodes.set(row.ray, node);
    return node;
  }

  function open() {
    isOpen = true;
    draw();
    rootNode().focus();
  }

  function draw() {
    nodes = new Map();
    const tree = layOut(rows, isOpen);
    const made = tree.nodes.map(nodeOf);
    drawing.replaceChildren(...tree.nodes.flatMap(edgesOf), ...made);
    walkWithArrows(tree.nodes, made, showNode);
    view.resize(tree.width, tree.height);
    mark();
  }

  function mark() {
    for (const [ray, node] of nodes) node.classList.toggle("lit", ray === lit?.ray);
  }

  return {
    element: element("div", "tree", view.element, element("div", "tree-foot", treeKey(), view.fit)),
    show({ rows: next }) {
      rows = next;
      isOpen = false;
      lit = null;
      draw();
      view.toTop();
      showNode(rootNode());
    },
    light(line, event) {
      lit = line ?? event;
      const ray = line ? undefined : event?.ray;
      if (ray !== undefined && !nodes.has(ray) && rows.some((row) => row.ray === ray)) {
        isOpen = true;
        draw();
      }
      mark();
      const node = ray === undefined ? null : nodes.get(ray);
      if (node) showNode(node);
    },
  };
}
