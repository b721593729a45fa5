/** The slice view: a row's or a column's plane of camera rays as a flat drawing, in place of the stage. */
import { element } from "../element";
import { say } from "../words";
import { createLabels, NOTHING } from "./labels";
import type { SectionsData } from "../trace/types";
import { drawSlice } from "./slice-drawing";
import { namesOf } from "./slice-names";
import { sheetOf, type Sheet, type SliceView } from "./slice-sheet";

export { sectionOf } from "../state/section";

export function sectionsFrom(json: unknown): SectionsData {
  const sections = json as SectionsData;
  if (sections?.format !== 1 || !sections.rows || !sections.columns || !(sections.step > 0)) throw new Error("not sections");
  return sections;
}

export function createSlice(acts: { pick: (along: number) => void }) {
  const canvas = element("canvas");
  const labels = createLabels();
  const root = element("div", "slice", canvas, labels.element);
  root.hidden = true;
  canvas.setAttribute("role", "img");
  const brush = canvas.getContext("2d")!;
  let now: SliceView | null = null;
  let sheet: Sheet | null = null;

  /** ratio: device pixels in each of the page's. */
  function draw(ratio = Math.min(2, window.devicePixelRatio)) {
    if (!now || root.hidden) return;
    const { clientWidth: width, clientHeight: height } = root;
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    brush.setTransform(ratio, 0, 0, ratio, 0, 0);
    sheet = sheetOf(now, width, height);
    drawSlice(brush, now, sheet);
    const { on } = sheet;
    const strokes = now.chosen.flatMap((line) => [...on(line.from), ...on(line.to)]);
    labels.show(namesOf(now, sheet), width, height, { ...NOTHING, strokes }, now.large ? 1.43 : 1);
  }

  function pick(event: PointerEvent) {
    if (!now || !sheet || !event.buttons) return;
    const box = canvas.getBoundingClientRect();
    acts.pick(now.section.pixelAt(sheet.back(event.clientX - box.left, event.clientY - box.top)));
  }
  canvas.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    canvas.setPointerCapture(event.pointerId);
    pick(event);
  });
  canvas.addEventListener("pointermove", pick);
  new ResizeObserver(() => draw()).observe(root);

  return {
    element: root,
    /** The drawing with so many device pixels in each of the page's; without a number as many as the screen has. */
    redrawn(ratio?: number) {
      draw(ratio);
      return canvas;
    },
    /** null: the stage is seen instead. */
    show(view: SliceView | null) {
      now = view;
      root.hidden = !view;
      if (!view) return;
      canvas.setAttribute("aria-label", say(`slice.${view.section.direction}.label`, { pixel: view.tile }));
      draw();
    },
  };
}
