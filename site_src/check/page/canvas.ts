/** Square pictures on canvases. */
import { element } from "../../viewer/element";

/** colours: red, green, blue of n x n pixels, row by row. */
export function imageOf(colours: ArrayLike<number>, n: number): ImageData {
  const image = new ImageData(n, n);
  const { data } = image;
  for (let i = 0, j = 0; i < colours.length; i += 3, j += 4) {
    data[j] = colours[i];
    data[j + 1] = colours[i + 1];
    data[j + 2] = colours[i + 2];
    data[j + 3] = 255;
  }
  return image;
}

export function canvasOf(n: number): HTMLCanvasElement {
  const made = element("canvas");
  [made.width, made.height] = [n, n];
  return made;
}

export const put = (canvas: HTMLCanvasElement, image: ImageData) => canvas.getContext("2d")!.putImageData(image, 0, 0);

export function canvasWith(image: ImageData): HTMLCanvasElement {
  const made = canvasOf(image.width);
  put(made, image);
  return made;
}
