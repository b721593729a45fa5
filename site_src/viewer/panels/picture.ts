/** The finished picture with the tile grid and the selected pixel on it. */
import type { Actions } from "../actions";
import { contrastWith } from "../palette";
import { isAsking, pixelIndex, tileColour, type ViewState } from "../state/view-state";
import type { SceneData, Trace } from "../trace/types";
import { say } from "../words";
import { createTilePicture, type TilePicture } from "../tile-picture";
import { element, named } from "../element";

const GRID_FROM = 6; // CSS pixels a tile: below, the grid would cover the picture
const COVER = "#39434F";
const LEAST_MARK = 7; // CSS pixels: a smaller frame would not be found

interface Marked {
  state: ViewState;
  trace: Trace | null;
  covered: boolean;
}

/** size: CSS pixels. */
function drawMarks(brush: CanvasRenderingContext2D, size: number, { state, trace, covered }: Marked) {
  brush.clearRect(0, 0, size, size);
  const tile = size / state.n;
  if (covered) {
    brush.fillStyle = COVER;
    brush.fillRect(0, 0, size, size);
  }
  if (tile >= GRID_FROM) drawGrid(brush, size, state.n);
  const wide = Math.max(tile, LEAST_MARK);
  const [x, y] = state.pixel.map((k) => (k + 0.5) * tile - wide / 2);
  const inner = contrastWith(covered ? null : trace && tileColour(trace, pixelIndex(state)));
  for (const [width, colour] of [[4, inner === "#000000" ? "#FFFFFF" : "#000000"], [2, inner]] as const) {
    brush.lineWidth = width;
    brush.strokeStyle = colour;
    brush.strokeRect(x, y, wide, wide);
  }
}

function drawGrid(brush: CanvasRenderingContext2D, size: number, n: number) {
  brush.lineWidth = 1;
  brush.strokeStyle = "rgba(255,255,255,.11)";
  brush.beginPath();
  for (let k = 1; k < n; k++) {
    const at = Math.round((k * size) / n) + 0.5;
    brush.moveTo(at, 0);
    brush.lineTo(at, size);
    brush.moveTo(0, at);
    brush.lineTo(size, at);
  }
  brush.stroke();
}

export function createPicture(root: string, acts: Pick<Actions, "pick" | "point"> & { failed: (again: () => void) => void }) {
  const image = element("img");
  image.alt = ""; // until there is a scene
  const marks = element("canvas", "marks");
  const recombined = createTilePicture("recombined");
  const badge = element("span", "recombined-size");
  const frame = element("div", "picture-frame", image, recombined.element, marks, badge);
  const whole = named(element("section", "picture", frame), say("picture.region"));
  const brush = marks.getContext("2d")!;
  let now: Marked | null = null;
  let shown = "";

  function draw() {
    if (!now) return;
    const size = frame.clientWidth;
    const ratio = Math.min(2, window.devicePixelRatio);
    if (marks.width !== Math.round(size * ratio)) marks.width = marks.height = Math.round(size * ratio);
    brush.setTransform(ratio, 0, 0, ratio, 0, 0);
    drawMarks(brush, size, now);
  }

  function pick(event: PointerEvent) {
    if (!now) return;
    const box = marks.getBoundingClientRect();
    const at = (share: number) => Math.max(0, Math.min(now!.state.n - 1, Math.floor(share * now!.state.n)));
    const tile = [at((event.clientX - box.left) / box.width), at((event.clientY - box.top) / box.height)] as const;
    acts.point(tile);
    if (event.buttons) acts.pick(...tile);
  }
  marks.addEventListener("pointerleave", () => acts.point(null));
  marks.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    marks.setPointerCapture(event.pointerId);
    pick(event);
  });
  marks.addEventListener("pointermove", pick);
  let times = 0; // that a picture was asked for in vain
  image.addEventListener("error", () => {
    const missing = image.src.replace(/\?.*/, "");
    acts.failed(() => void (image.src = `${missing}?again=${++times}`));
  });
  new ResizeObserver(draw).observe(frame);

  return {
    element: whole,
    /** trace: of the tiles that are seen; instead: what stands in place of the finished picture while switches are set. */
    show(state: ViewState, scene: SceneData, trace: Trace | null, instead: TilePicture | null) {
      // A question about colours: the picture would give the answer away.
      now = { state, trace, covered: isAsking(state, scene) && state.tiles === "empty" };
      recombined.show(now.covered ? null : instead);
      badge.hidden = recombined.element.hidden;
      if (instead) badge.textContent = say("whatIf.recombined", { n: instead.n });
      const source = `${root}scenes/${scene.of}/${scene.picture}`;
      if (shown !== scene.id + source) {
        shown = scene.id + source;
        image.src = source;
        image.alt = say("picture.alt", { title: scene.title }); // with switches the badge beside it says that tiles stand before it
      }
      draw();
    },
  };
}
