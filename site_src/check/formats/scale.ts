/** Numbers without a stated scale, of PFM and text: is white 1 or 255? */

/** On a scale to 255 a picture without anything brighter than this is all but black: then white is 1. */
const DARKEST_OF_BYTES = 16;

/**
 * The factor that brings values to a scale to 255. Fractions that stay small are of a scale to 1, brighter than white here and
 * there; so is a picture of floats, which PFM's convention says. Whole numbers are bytes, however dark.
 */
export function scaleOf(values: Float32Array, areFloats: boolean): number {
  let most = 0;
  let areWhole = true;
  for (const value of values) {
    if (value > most) most = value;
    if (value !== Math.floor(value)) areWhole = false;
  }
  return most <= DARKEST_OF_BYTES && (areFloats || !areWhole) ? 255 : 1;
}

/** In place: on a scale to 255, and cut to what can be shown. */
export function toShown(values: Float32Array, factor: number): Float32Array {
  for (let i = 0; i < values.length; i++) values[i] = Math.min(Math.max(factor * values[i], 0), 255);
  return values;
}
