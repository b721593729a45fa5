/** Both pictures on one place: wiped, each alone, or how far they differ. */
import { button, element, named, pressed } from "../../viewer/element";
import { say } from "../../viewer/words";
import type { Picture } from "../formats/picture";

type View = "wipe" | "heat" | "yours" | "right";
const VIEWS: View[] = ["wipe", "heat", "yours", "right"];

export function picturesOf(student: Picture, right: Picture, heat: Uint8ClampedArray): HTMLElement {
  const n = right.width;
  const [below, above] = [canvasOf(n), canvasOf(n)];
  const layers = { yours: imageOf(student), right: imageOf(right), heat: new ImageData(new Uint8ClampedArray(heat), n, n) };
  const slider = element("input", "check-wipe");
  Object.assign(slider, { type: "range", min: "0", max: "100", value: "50" });
  named(slider, say("check.view.slider"));
  const under = element("p", "check-under");
  const frame = named(element("div", "check-picture", below, above), say("check.view.label"), "img");
  const buttons = VIEWS.map((view) => button(say(`check.view.${view}`), say(`check.view.${view}`), () => show(view)));
  let shown: View = "wipe";

  function wipe() {
    above.style.clipPath = `inset(0 ${100 - Number(slider.value)}% 0 0)`;
  }
  function show(view: View) {
    shown = view;
    VIEWS.forEach((each, k) => pressed(buttons[k], each === view));
    above.hidden = view !== "wipe";
    slider.hidden = view !== "wipe";
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
  return element("section", "", element("h2", "", say("check.view.head")), element("div", "check-views", ...buttons), frame, slider, under);
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

function canvasOf(n: number): HTMLCanvasElement {
  const made = element("canvas");
  [made.width, made.height] = [n, n];
  return made;
}

const put = (canvas: HTMLCanvasElement, image: ImageData) => canvas.getContext("2d")!.putImageData(image, 0, 0);

function imageOf({ width, height, values }: Picture): ImageData {
  const image = new ImageData(width, height);
  const { data } = image;
  for (let i = 0, j = 0; i < values.length; i += 3, j += 4) {
    data[j] = values[i];
    data[j + 1] = values[i + 1];
    data[j + 2] = values[i + 2];
    data[j + 3] = 255;
  }
  return image;
}
