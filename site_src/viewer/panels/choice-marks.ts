/** Letters on the picture, where a question's choices are pixels of it. */
import { element } from "../element";
import type { ChoiceData } from "../trace/types";

/** A, B, C ... */
export const letter = (k: number): string => String.fromCharCode(65 + k);

/** home: holds the picture, once a scene is shown. */
export function createMarks(home: HTMLElement) {
  const marks = element("div", "choice-marks");
  marks.setAttribute("aria-hidden", "true"); // the choices say their pixels
  let shown: readonly ChoiceData[] = [];
  return {
    /** n: pixels across. */
    show(n: number, choices: readonly ChoiceData[]) {
      if (choices === shown) return;
      shown = choices;
      home.querySelector(".picture-frame")?.append(marks);
      marks.replaceChildren(
        ...choices.flatMap(({ pixel }, k) => {
          if (!pixel) return [];
          const made = element("span", "letter", letter(k));
          [made.style.left, made.style.top] = pixel.map((at) => `${(100 * (at + 0.5)) / n}%`);
          return [made];
        }),
      );
    },
  };
}
