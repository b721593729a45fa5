/** Words beside things on the stage. They step aside for one another; the least important give way. */
import { element } from "../element";

export interface Label {
  key: string;
  text: string;
  x: number; // CSS pixels: what the label belongs to
  y: number;
  kind: "sign" | "hit" | "stop"; // hit: coordinates, in figures of equal width; stop: what is in a light's way
  below?: boolean; // rather than beside: the thing is wide
}


export interface Box {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

const GAP = 12; // from the thing to its label
const CHAR = { sign: 7.4, hit: 7.8, stop: 7.8 }; // width of a character at most
const HEIGHT = 22;

const overlap = (a: Box, b: Box) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

/** Right, left, below, above, then the corners: before, at or after the thing across and down. */
const SPOTS = [[2, 1], [0, 1], [1, 2], [1, 0], [2, 2], [2, 0], [0, 2], [0, 0]];

/** Of these spots the first that is free, inside and not struck through by a line; failing
 *  that, the first that is free. strokes: places along the lines, x y x y ... */
function place(label: Label, width: number, height: number, taken: readonly Box[], strokes: readonly number[], large: number): Box | null {
  const w = label.text.length * CHAR[label.kind] * large + 8;
  const high = HEIGHT * large;
  const [xs, ys] = [[label.x - GAP - w, label.x - w / 2, label.x + GAP], [label.y - GAP - high, label.y - high / 2, label.y + GAP]];
  const spots = SPOTS.map(([x, y]) => [xs[x], ys[y]]);
  if (label.below) spots.unshift([label.x - w / 2, label.y + 1.6 * GAP], [label.x - w / 2, label.y - 1.6 * GAP - high]);
  const boxes = spots.map(([left, top]) => ({ left, top, right: left + w, bottom: top + high }));
  const inside = (b: Box) => b.left >= 4 && b.top >= 4 && b.right <= width - 4 && b.bottom <= height - 4;
  const free = boxes.filter((box) => inside(box) && !taken.some((other) => overlap(box, other)));
  const struck = ({ left, top, right, bottom }: Box) => {
    for (let k = 0; k < strokes.length; k += 2)
      if (strokes[k] > left && strokes[k] < right && strokes[k + 1] > top && strokes[k + 1] < bottom) return true;
    return false;
  };
  return free.find((box) => !struck(box)) ?? free[0] ?? null;
}

/** Places every few pixels along a line, x y x y ..., for labels to keep clear of. */
export function strokesAlong(from: readonly [number, number], to: readonly [number, number]): number[] {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const steps = Math.max(1, Math.min(300, Math.ceil(Math.hypot(dx, dy) / 6)));
  return Array.from({ length: steps + 1 }, (_, k) => [from[0] + (k / steps) * dx, from[1] + (k / steps) * dy]).flat();
}

export function createLabels() {
  const root = element("div", "labels");
  root.setAttribute("aria-hidden", "true"); // the card says the same in words
  const spans = new Map<string, HTMLSpanElement>();

  function spanOf(label: Label) {
    const known = spans.get(label.key);
    if (known) return known;
    const span = element("span");
    spans.set(label.key, span);
    root.append(span);
    return span;
  }

  return {
    element: root,
    /** Most important first; taken: places that are not free; large: times as large as on a desk. */
    show(labels: readonly Label[], width: number, height: number, taken: readonly Box[] = [], strokes: readonly number[] = [], large = 1) {
      const used = [...taken];
      const alive = new Set(labels.map((label) => label.key));
      for (const [key, span] of spans) if (!alive.has(key)) span.remove(), spans.delete(key);
      for (const label of labels) {
        const span = spanOf(label);
        if (span.textContent !== label.text) span.textContent = label.text;
        span.className = label.kind;
        const box = place(label, width, height, used, strokes, large);
        span.hidden = !box;
        if (!box) continue;
        used.push(box);
        span.style.transform = `translate(${Math.round(box.left)}px, ${Math.round(box.top)}px)`;
        span.style.width = `${Math.round(box.right - box.left)}px`;
        span.style.textAlign = box.right < label.x ? "right" : box.left > label.x ? "left" : "center";
      }
    },
  };
}
