/** The finished picture laid over the stage, exactly where the tiles stand as the ray-tracing camera sees them, and a bar that
 *  wipes it away from its left: what is drawn under it comes to light. */
import { element, named } from "../element";
import { planeCorners, type PicturePlane } from "../state/frustum";
import type { Projection } from "../state/projection";
import { createTilePicture, type TilePicture } from "../tile-picture";
import type { SceneData } from "../trace/types";
import { percent, say } from "../words";

const STEPS = 100; // of the bar's way; a page up or down is ten
const BAR = 44; // CSS pixels wide, to be taken hold of

function createBar(wipe: (share: number) => void) {
  const bar = named(element("input", "wipe"), say("look.wipe.help"));
  Object.assign(bar, { type: "range", min: "0", max: String(STEPS), title: say("look.wipe.help") });
  bar.addEventListener("input", () => wipe(Number(bar.value) / STEPS));
  bar.addEventListener("pointerdown", (event) => event.stopPropagation()); // the stage would turn
  const names = element("div", "wipe-names", element("span", "", say("look.approximate.word")), element("span", "", say("look.traced.word")));
  names.setAttribute("aria-hidden", "true");
  return {
    parts: [names, bar],
    /** left, top, width, height: of the picture, in CSS pixels. null: not shown. */
    show(box: { left: number; top: number; width: number; height: number } | null, share: number) {
      bar.hidden = !box;
      names.hidden = !box || !share;
      if (!box) return;
      const { left, top, width, height } = box;
      Object.assign(bar.style, { left: `${left - BAR / 2}px`, top: `${top}px`, width: `${width + BAR}px`, height: `${height}px` });
      Object.assign(names.style, { left: `${left + share * width}px`, top: `${top + 8}px` });
      bar.style.setProperty("--high", `${height}px`);
      bar.value = String(share * STEPS);
      bar.setAttribute("aria-valuetext", say("look.wipe.at", { share: percent(share) }));
    },
  };
}

/** siteRoot: relative path to it. wipe: called with the share that the bar has swept. */
export function createTracedPicture(siteRoot: string, wipe: (share: number) => void) {
  const image = element("img");
  image.alt = ""; // the picture beside the stage says it in words
  const recombined = createTilePicture("recombined");
  const whole = element("div", "traced-whole", image, recombined.element);
  const root = element("div", "traced-picture", whole);
  const bar = createBar(wipe);
  root.hidden = true;
  return {
    parts: [root, ...bar.parts],
    /** scene: null where it is not shown. instead: what stands before the picture while switches are set. share: of it that is wiped away. */
    show(scene: SceneData | null, plane: PicturePlane, projection: Projection, instead: TilePicture | null, share: number) {
      root.hidden = !scene;
      if (!scene) return bar.show(null, 0);
      recombined.show(instead);
      const source = `${siteRoot}scenes/${scene.of.replace(/ at [^/]*$/, "")}/${scene.picture}`; // of: with where it is between stops
      if (image.getAttribute("src") !== source) image.src = source;
      const [topLeft, , bottomRight] = planeCorners(plane).map(projection.project);
      const [left, top, width, height] = [topLeft.x, topLeft.y, bottomRight.x - topLeft.x, bottomRight.y - topLeft.y];
      Object.assign(root.style, { left: `${left + share * width}px`, top: `${top}px`, width: `${(1 - share) * width}px`, height: `${height}px` });
      Object.assign(whole.style, { left: `${-share * width}px`, width: `${width}px`, height: `${height}px` });
      bar.show({ left, top, width, height }, share);
    },
  };
}

export type TracedPicture = ReturnType<typeof createTracedPicture>;
