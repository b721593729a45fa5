/** A row of buttons of which one is on. */
import { button, group, pressed } from "../element";

export function createChoice<T extends string>(label: string, choices: readonly (readonly [T, string, string])[], chosen: (value: T) => void) {
  const buttons = choices.map(([value, word, help]) => [value, button(word, help, () => chosen(value))] as const);
  return {
    element: group(label, "worked-choice joined", ...buttons.map(([, each]) => each)),
    show(now: T) {
      for (const [value, each] of buttons) pressed(each, value === now);
    },
  };
}

/** A square of n x n colours, as sharp as pixels are, with one of them framed. */
export function drawSquare(canvas: HTMLCanvasElement, n: number, colour: (tile: number) => string, framed: readonly [number, number] | null, side: number) {
  canvas.width = canvas.height = side;
  const brush = canvas.getContext("2d")!;
  const tile = side / n;
  for (let k = 0; k < n * n; k++) {
    brush.fillStyle = colour(k);
    brush.fillRect(Math.floor((k % n) * tile), Math.floor(Math.floor(k / n) * tile), Math.ceil(tile), Math.ceil(tile));
  }
  if (!framed) return;
  for (const [wide, stroke] of [[4, "#000"], [2, "#fff"]] as const) {
    brush.lineWidth = wide;
    brush.strokeStyle = stroke;
    brush.strokeRect(framed[0] * tile, framed[1] * tile, tile, tile);
  }
}
