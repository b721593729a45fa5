/** The finished picture laid over the stage, exactly where the tiles stand as the ray-tracing camera sees them. */
import { planeCorners, type PicturePlane } from "../state/frustum";
import type { Projection } from "../state/projection";
import { createTilePicture, type TilePicture } from "../tile-picture";
import type { SceneData } from "../trace/types";

/** root: relative path to the site's root. */
export function createTracedPicture(root: string) {
  const image = document.createElement("img");
  image.alt = ""; // the picture beside the stage says it in words
  const recombined = createTilePicture("recombined");
  const element = document.createElement("div");
  element.className = "traced-picture";
  element.hidden = true;
  element.append(image, recombined.element);
  return {
    element,
    /** scene: null where it is not shown. instead: what stands before the picture while switches are set. */
    show(scene: SceneData | null, plane: PicturePlane, projection: Projection, instead: TilePicture | null) {
      element.hidden = !scene;
      if (!scene) return;
      recombined.show(instead);
      const source = `${root}scenes/${scene.id}/${scene.picture}`;
      if (image.getAttribute("src") !== source) image.src = source;
      const [topLeft, , bottomRight] = planeCorners(plane).map(projection.project);
      element.style.left = `${topLeft.x}px`;
      element.style.top = `${topLeft.y}px`;
      element.style.width = `${bottomRight.x - topLeft.x}px`;
      element.style.height = `${bottomRight.y - topLeft.y}px`;
    },
  };
}
