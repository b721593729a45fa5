/** Arrow keys in a drawn tree: up to the parent, down to the first child, sideways along the row. */
import type { Placed } from "./tree-layout";

/** Where a key leads to from the node at `at`: an index, -1 for nowhere; null for a key of no meaning here. */
function next(key: string, places: readonly Placed[], at: number): number | null {
  const beside = (by: 1 | -1) => {
    const level = places.filter(({ depth }) => depth === places[at].depth).sort((a, b) => a.x - b.x);
    return places.indexOf(level[level.indexOf(places[at]) + by]);
  };
  switch (key) {
    case "ArrowUp":
      return places.findIndex(({ below }) => below.includes(places[at]));
    case "ArrowDown":
      return places.indexOf(places[at].below[0]);
    case "ArrowLeft":
      return beside(-1);
    case "ArrowRight":
      return beside(1);
    default:
      return null;
  }
}

/** nodes: of these places, in their order. One of them takes the focus, the root at first. */
export function walkWithArrows(places: readonly Placed[], nodes: readonly SVGElement[], show: (node: SVGElement) => void) {
  nodes[0].setAttribute("tabindex", "0");
  nodes.forEach((node, at) =>
    node.addEventListener("keydown", (event) => {
      const to = next(event.key, places, at);
      if (to === null) return;
      event.preventDefault();
      if (to < 0) return;
      node.setAttribute("tabindex", "-1");
      nodes[to].setAttribute("tabindex", "0");
      nodes[to].focus();
      show(nodes[to]);
    }),
  );
}
