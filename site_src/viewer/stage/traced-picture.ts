/** The finished picture laid over the stage, exactly where the tiles stand as the ray-tracing camera sees them. */
import { element } from "../element";
import { planeCorners, type PicturePlane } from "../state/frustum";
import type { Projection } from "../state/projection";
import { createTilePicture, type TilePicture } from "../tile-picture";
import type { SceneData } from "../trace/types";

/** siteRoot: relative path to it. */
export function createTracedPicture(siteRoot: string) {
  const image = element("img");
  image.alt = ""; // the picture beside the stage says it in words
  const recombined = createTilePicture("recombined");
  const root = element("div", "traced-picture", image, recombined.element);
  root.hidden = true;
  return {
    element: root,
    /** scene: null where it is not shown. instead: what stands before the picture while switches are set. */
    show(scene: SceneData | null, plane: PicturePlane, projection: Projection, instead: TilePicture | null) {
      root.hidden = !scene;
      if (!scene) return;
      recombined.show(instead);
      const source = `${siteRoot}scenes/${scene.id}/${scene.picture}`;
      if (image.getAttribute("src") !== source) image.src = source;
      const [topLeft, , bottomRight] = planeCorners(plane).map(projection.project);
      Object.assign(root.style, { left: `${topLeft.x}px`, top: `${topLeft.y}px`, width: `${bottomRight.x - topLeft.x}px`, height: `${bottomRight.y - topLeft.y}px` });
    },
  };
}
