/** Tiles as a picture of its own: a pixel a tile, shown as sharp squares. For the stage and for the picture beside it. */
import { element } from "./element";

export interface TilePicture {
  n: number;
  colours: Uint8Array; // (3 * n * n)
}

export function createTilePicture(className: string) {
  const canvas = element("canvas", className);
  canvas.hidden = true;
  let painted: Uint8Array | null = null;
  return {
    element: canvas,
    /** null: not shown. */
    show(tiles: TilePicture | null) {
      canvas.hidden = !tiles;
      if (!tiles || painted === tiles.colours) return;
      painted = tiles.colours;
      const { n, colours } = tiles;
      canvas.width = canvas.height = n;
      const image = new ImageData(n, n);
      for (let k = 0; k < n * n; k++) image.data.set([colours[3 * k], colours[3 * k + 1], colours[3 * k + 2], 255], 4 * k);
      canvas.getContext("2d")!.putImageData(image, 0, 0);
    },
  };
}
