/** The finished picture laid over the stage, exactly where the tiles stand as the ray-tracing camera sees them. */
import { planeCorners, type PicturePlane } from "../state/frustum";
import type { Projection } from "../state/projection";
import type { SceneData } from "../trace/types";

/** root: relative path to the site's root. */
export function createTracedPicture(root: string) {
  const element = document.createElement("img");
  element.className = "traced-picture";
  element.alt = ""; // the picture beside the stage says it in words
  element.hidden = true;
  return {
    element,
    /** null: not shown. */
    show(scene: SceneData | null, plane?: PicturePlane, projection?: Projection) {
      element.hidden = !scene;
      if (!scene || !plane || !projection) return;
      const source = `${root}scenes/${scene.id}/${scene.picture}`;
      if (element.getAttribute("src") !== source) element.src = source;
      const [topLeft, , bottomRight] = planeCorners(plane).map(projection.project);
      element.style.left = `${topLeft.x}px`;
      element.style.top = `${topLeft.y}px`;
      element.style.width = `${bottomRight.x - topLeft.x}px`;
      element.style.height = `${bottomRight.y - topLeft.y}px`;
    },
  };
}
