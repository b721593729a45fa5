/** Both pictures on one place: wiped, each alone, or how far they differ. */
import { button, element, named, pressed } from "../../viewer/element";
import { say } from "../../viewer/words";
import type { Picture } from "../formats/picture";
import { canvasOf, imageOf, put } from "./canvas";

type View = "wipe" | "heat" | "yours" | "right";
const VIEWS: View[] = ["wipe", "heat", "yours", "right"];

/** Of what is wrong, seen before anybody wipes. */
const MOST_WRONG = 0.8;

export function picturesOf(student: Picture, right: Picture, heat: Uint8ClampedArray): HTMLElement {
  const n = right.width;
  const [below, above] = [canvasOf(n), canvasOf(n)];
  const layers = { yours: imageOf(student.values, n), right: imageOf(right.values, n), heat: new ImageData(new Uint8ClampedArray(heat), n, n) };
  const slider = element("input", "check-wipe");
  Object.assign(slider, { type: "range", min: "0", max: "100", value: String(wipeFrom(heat, n)) });
  named(slider, say("check.view.slider"));
  const under = element("p", "check-under");
  const sides = (["yours", "right"] as const).map((side) => element("span", `check-side is-${side}`, say(`check.view.${side}`)));
  const frame = named(element("div", "check-picture", below, above, ...sides), say("check.view.label"), "img");
  const buttons = VIEWS.map((view) => button(say(`check.view.${view}`), say(`check.view.${view}`), () => show(view)));
  let shown: View = "wipe";

  function wipe() {
    above.style.clipPath = `inset(0 ${100 - Number(slider.value)}% 0 0)`;
    frame.style.setProperty("--wiped", `${slider.value}%`);
  }
  function show(view: View) {
    shown = view;
    VIEWS.forEach((each, k) => pressed(buttons[k], each === view));
    above.hidden = view !== "wipe";
    slider.hidden = view !== "wipe";
    frame.classList.toggle("is-wiped", view === "wipe");
    put(below, layers[view === "wipe" ? "right" : view]);
    if (view === "wipe") put(above, layers.yours);
    under.textContent = say(view === "heat" ? "check.view.heatSays" : "check.view.point");
    wipe();
  }
  slider.addEventListener("input", wipe);
  listenToPointer(frame, n, (x, y) => {
    const bytes = ({ values }: Picture) => [0, 1, 2].map((c) => Math.round(values[3 * (y * n + x) + c])).join(", ");
    under.textContent = say("check.view.pixel", { x, y, yours: bytes(student), right: bytes(right) });
  }, (share) => {
    if (shown !== "wipe") return;
    slider.value = String(100 * share);
    wipe();
  });
  show("wipe");
  return element("section", "check-both", element("h2", "", say("check.view.head")), element("div", "check-views", ...buttons), under, frame, slider);
}

/** Percent of the width from the left, a half or more, that has most of what is wrong: what one looks for is in sight. */
function wipeFrom(heat: Uint8ClampedArray, n: number): number {
  const columns = new Float64Array(n);
  for (let i = 0; i < heat.length; i += 4) columns[(i / 4) % n] += heat[i] + heat[i + 1] + heat[i + 2];
  const all = columns.reduce((sum, each) => sum + each, 0);
  let [x, seen] = [0, 0];
  while (x < n && seen < MOST_WRONG * all) seen += columns[x++];
  return Math.min(Math.max(Math.ceil((100 * x) / n) + 2, 50), 96);
}

/** at: the pixel pointed at. dragged: along the picture, 0 to 1. */
function listenToPointer(frame: HTMLElement, n: number, at: (x: number, y: number) => void, dragged: (share: number) => void) {
  const told = (event: PointerEvent) => {
    const { left, top, width, height } = frame.getBoundingClientRect();
    const [u, v] = [(event.clientX - left) / width, (event.clientY - top) / height];
    const pixel = (share: number) => Math.min(Math.max(Math.floor(share * n), 0), n - 1);
    at(pixel(u), pixel(v));
    if (event.buttons) dragged(Math.min(Math.max(u, 0), 1));
  };
  frame.addEventListener("pointermove", told);
  frame.addEventListener("pointerdown", (event) => {
    frame.setPointerCapture(event.pointerId);
    told(event);
  });
}
