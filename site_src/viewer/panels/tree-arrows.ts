/** Arrow keys in a drawn tree: up to the parent, down to the first child, sideways along the row. */
import type { Placed } from "./tree-layout";

/** Where a key leads to from a node: to another one, to none, or null for a key of no meaning here. */
function next(key: string, places: readonly Placed[], from: Placed): Placed | undefined | null {
  const beside = (by: 1 | -1) => {
    const level = places.filter(({ depth }) => depth === from.depth).sort((a, b) => a.x - b.x);
    return level[level.indexOf(from) + by];
  };
  const steps: Readonly<Record<string, () => Placed | undefined>> = {
    ArrowUp: () => places.find(({ below }) => below.includes(from)),
    ArrowDown: () => from.below[0],
    ArrowLeft: () => beside(-1),
    ArrowRight: () => beside(1),
  };
  return key in steps ? steps[key]() : null;
}

/** nodes: of these places, in their order. One of them takes the focus, the root at first. */
export function walkWithArrows(places: readonly Placed[], nodes: readonly SVGElement[], show: (node: SVGElement) => void) {
  nodes[0].setAttribute("tabindex", "0");
  nodes.forEach((node, at) =>
    node.addEventListener("keydown", (event) => {
      const place = next(event.key, places, places[at]);
      if (place !== null) event.preventDefault();
      if (!place) return;
      const to = nodes[places.indexOf(place)];
      node.setAttribute("tabindex", "-1");
      to.setAttribute("tabindex", "0");
      to.focus();
      show(to);
    }),
  );
}
