/** What the colours and dashes of the lines on the stage mean: only the kinds that are there. */
import { LINES } from "../palette";
import { CROWD } from "../state/shown";
import { LINE_KINDS, type LineKind } from "../trace/kinds";
import { grouped, say } from "../words";
import { element } from "../element";
import { svg } from "./svg";

const LONG = 26; // pixels of sample line

function sample(kind: LineKind): SVGElement {
  const { dash } = LINES[kind];
  return svg("svg", { width: LONG + 8, height: 12, "aria-hidden": "true" },
    svg("line", { x1: 0, y1: 6, x2: LONG, y2: 6, class: `stroke ${kind}`, "stroke-width": 3, "stroke-dasharray": dash[0] === 1 ? "none" : dash.join(" ") }),
    svg("path", { d: `M${LONG - 4} 1.5 L${LONG + 6} 6 L${LONG - 4} 10.5 Z`, class: `fill ${kind}` }),
  );
}

export function createLegend() {
  const root = element("ul", "legend");
  const items = LINE_KINDS.map((kind) => {
    const item = element("li", "", say(`line.${kind}`));
    item.prepend(sample(kind));
    item.dataset.kind = kind;
    root.append(item);
    return { kind, item };
  });
  const note = element("li", "left-out numbers");
  root.append(note);
  return {
    element: root,
    /** left: shadow rays that are not drawn. */
    show(kinds: ReadonlySet<LineKind>, left: number) {
      note.hidden = left === 0;
      if (left) note.textContent = say("legend.leftOut", { left: grouped(left), most: grouped(CROWD) });
      for (const { kind, item } of items) item.hidden = !kinds.has(kind);
    },
  };
}
