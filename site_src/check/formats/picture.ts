/** What any file that holds a picture is read into. */

/** More is not read: a quarter more than twice the largest picture of a scene, which is 1155 by 1155. */
export const MOST_PIXELS_ALONG = 2400;

export interface Picture {
  width: number;
  height: number;
  /** Row by row from the top left, red, green, blue; linear on a scale where 255 is white. Bytes of 8-bit files as they stand. */
  values: Uint8Array | Float32Array;
  /** JPEG changes colours by several steps: its verdicts are to be told with a warning. */
  isLossy: boolean;
  /** It had alpha that was not opaque everywhere. Alpha is left out: the colours are those that stand beside it. */
  hadAlpha: boolean;
}

/** Pixels with red, green and blue, still without values. */
export const pictureOf = (width: number, height: number, values: Picture["values"]): Picture => ({ width, height, values, isLossy: false, hadAlpha: false });
