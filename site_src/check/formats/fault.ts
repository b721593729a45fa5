/** What is wrong with a file, as a word and figures: sentences.ts says it to a person. */
import { MOST_PIXELS_ALONG } from "./picture";
import type { FaultWord } from "./sentences";

export class PictureFault extends Error {
  constructor(readonly word: FaultWord, readonly figures: Record<string, string | number> = {}) {
    super(word);
  }
}

/** Refuses what a header claims before anything of that size is made. */
export function checkSize(format: string, width: number, height: number): void {
  if (width === 0 || height === 0) throw new PictureFault("empty", { format, width, height });
  if (Math.max(width, height) > MOST_PIXELS_ALONG) throw new PictureFault("tooLarge", { format, width, height, most: MOST_PIXELS_ALONG });
}

/** Refuses a file that ends before what its header claims. */
export function checkLength(format: string, has: number, needed: number): void {
  if (has < needed) throw new PictureFault("truncated", { format, has, needed });
}
