/** A sweep of two values: a square with a dot for each stop. A finger drags over it, arrows go from dot to dot. */
import { element, named } from "../element";
import { svg } from "../panels/svg";
import { countOf, placeOf, rowsOf, stopOf, type Place, type Sweep } from "../state/swept";
import { say } from "../words";
import type { MoverActs } from "./types";

const SIDE = 100; // of the drawing; its edge keeps off the outermost dots
const EDGE = 12;
const WAYS: Readonly<Record<string, Place>> = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/** name: what is read aloud before the values. */
export function createPad({ now, to, hold }: MoverActs, sweep: Sweep, name: string) {
  const [columns, rows] = [sweep.values.length, rowsOf(sweep)];
  const dots = (SIDE - 2 * EDGE) / Math.max(1, columns - 1);
  const lines = (SIDE - 2 * EDGE) / Math.max(1, rows - 1);
  /** The first row is below: up is on. */
  const drawnAt = ([column, row]: Place) => ({ cx: EDGE + column * dots, cy: SIDE - EDGE - row * lines });
  const thumb = svg("circle", { class: "thumb", r: 8 });
  const cross = [svg("line", { class: "to-here" }), svg("line", { class: "to-here" })];
  const drawing = svg(
    "svg",
    { viewBox: `0 0 ${SIDE} ${SIDE}`, "aria-hidden": "true" },
    ...cross,
    ...Array.from({ length: countOf(sweep) }, (_, k) => svg("circle", { class: k + 1 === sweep.own ? "own" : "", r: k + 1 === sweep.own ? 3.6 : 2, ...drawnAt(placeOf(sweep, k + 1)) })),
    thumb,
  );
  const root = named(element("div", "pad", drawing), name, "slider");
  root.tabIndex = 0;
  root.title = say("sweep.padHelp");
  root.setAttribute("aria-roledescription", say("sweep.pad"));
  root.setAttribute("aria-valuemin", "1");
  root.setAttribute("aria-valuemax", String(countOf(sweep)));

  function placeUnder({ clientX, clientY }: PointerEvent): Place {
    const { left, top, width } = root.getBoundingClientRect();
    const within = (at: number, last: number) => Math.max(0, Math.min(last, at));
    const [x, y] = [clientX - left, clientY - top].map((each) => (each * SIDE) / width);
    return [within((x - EDGE) / dots, columns - 1), within((SIDE - EDGE - y) / lines, rows - 1)];
  }
  function follow(event: PointerEvent) {
    const place = placeUnder(event);
    hold(place);
    to(stopOf(sweep, place));
  }
  root.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    root.setPointerCapture(event.pointerId);
    follow(event);
  });
  root.addEventListener("pointermove", (event) => root.hasPointerCapture(event.pointerId) && follow(event));
  root.addEventListener("lostpointercapture", () => hold(null));
  root.addEventListener("keydown", (event) => {
    const [column, row] = placeOf(sweep, now());
    const way = WAYS[event.key];
    const next = way ? stopOf(sweep, [column + way[0], row + way[1]]) : ({ Home: 1, End: countOf(sweep) } as Record<string, number>)[event.key];
    if (!next || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault(); // the page's arrows select a pixel
    to(next);
  });
  const put = (of: SVGElement, at: Record<string, number>) => Object.entries(at).forEach(([key, value]) => of.setAttribute(key, String(value)));
  return {
    element: root,
    show(stop: number, text: string) {
      const { cx, cy } = drawnAt(placeOf(sweep, stop));
      put(thumb, { cx, cy });
      put(cross[0], { x1: cx, y1: SIDE, x2: cx, y2: cy });
      put(cross[1], { x1: 0, y1: cy, x2: cx, y2: cy });
      root.setAttribute("aria-valuenow", String(stop));
      root.setAttribute("aria-valuetext", text);
    },
  };
}
