/** A scene's right picture and the wrong ones that its mistakes make, each on one grid: what a student's picture is held against. */
import type { Picture } from "./formats/picture";

/** As a file holds it: pictures are bytes of an image format, told by what reads them; equal pictures stand once. */
export interface AtlasFile<Image> {
  scene: string;
  right: Image;
  mistakes: MistakeIn<Image>[];
}

export interface MistakeIn<Image> {
  name: string;
  family: string;
  /**
   * (wrong - right) modulo 256, colour by colour: mostly 0, so that it packs well. A second one stands where the picture hangs on
   * roundings (a shadow ray that meets its own surface): made in float32 by a program with an offset, as most students' are.
   */
  wrong: Image[];
}

export interface Atlas {
  scene: string;
  size: number; // the grid is size x size
  right: Uint8Array; // red, green, blue, row by row
  mistakes: { name: string; family: string; pictures: Uint8Array[] }[];
}

/** read: how an image's bytes become a picture, in a page by the browser, in node by formats/. */
export function atlasOf<Image>(file: AtlasFile<Image>, read: (image: Image) => Picture): Atlas {
  const whole = read(file.right);
  const right = Uint8Array.from(whole.values);
  const laidOver = (image: Image) => Uint8Array.from(read(image).values, (difference, i) => difference + right[i]); // modulo 256
  const mistakes = file.mistakes.map(({ name, family, wrong }) => ({ name, family, pictures: wrong.map(laidOver) }));
  return { scene: file.scene, size: whole.width, right, mistakes };
}
