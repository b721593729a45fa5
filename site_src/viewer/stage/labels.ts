/** Words beside things on the stage. They keep clear of one another, of rays and of what those meet; a word that stands far from
 *  its thing has a line to it, and one that finds no place is not shown: the least important give way. */
import { element } from "../element";
import type { Box } from "../state/outlines";

export interface Label {
  key: string;
  text: string;
  x: number; // CSS pixels: what the label belongs to
  y: number;
  kind: "sign" | "hit" | "stop"; // hit: coordinates, in figures of equal width; stop: what is in a light's way
  below?: boolean; // rather than beside: the thing is wide
  side?: readonly number[]; // across and down, tried before all others
}

export interface Round {
  x: number;
  y: number;
  radius: number;
}

/** What no word may lie on. CSS pixels. */
export interface Clear {
  boxes: readonly Box[];
  rounds: readonly Round[];
  strokes: readonly number[]; // ends of lines: x y of the one, x y of the other ...
  faint: readonly number[]; // of lines that a word should not lie on either, if it may stand near its thing
}
export const NOTHING: Clear = { boxes: [], rounds: [], strokes: [], faint: [] };

const HEIGHT = 22;
const AWAY = [12, 26, 44, 66, 92, 122, 156, 196]; // from the thing to its word, the nearest first
const NEAR = 3; // of these, for which faint lines count
const BESIDE = 5; // from a line's middle to a word: half its width and its casing
const LED = 30; // from here on a word has a line to its thing

const overlap = (a: Box, b: Box) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
/** Of a place to a stretch. */
const distance = (at: number, low: number, high: number) => Math.max(low - at, 0, at - high);
const isOn = ({ x, y, radius }: Round, { left, right, top, bottom }: Box) => Math.hypot(distance(x, left, right), distance(y, top, bottom)) < radius;

/** Do lines pass the box, or its surroundings? (Y.-D. Liang, B. A. Barsky, A new concept and method for line clipping, 1984) */
export function isStruck({ left, top, right, bottom }: Box, ends: readonly number[]): boolean {
  for (let k = 0; k < ends.length; k += 4) {
    let [from, to] = [0, 1];
    for (const [axis, low, high] of [[0, left, right], [1, top, bottom]]) {
      const run = ends[k + 2 + axis] - ends[k + axis];
      const shares = [low - BESIDE, high + BESIDE].map((edge) => (edge - ends[k + axis]) / run);
      from = Math.max(from, Math.min(...shares));
      to = Math.min(to, Math.max(...shares));
    }
    if (from <= to) return true;
  }
  return false;
}

/** Right, left, below, above, then the corners: across and down. */
const SPOTS = [[1, 0], [-1, 0], [0, 1], [0, -1], [1, 1], [1, -1], [-1, 1], [-1, -1]];

/** The nearest place of a word of w x h that is inside and clear. */
function place({ x, y, below, side }: Label, [w, h]: readonly number[], width: number, height: number, { boxes, rounds, strokes, faint }: Clear, taken: readonly Box[]): Box | null {
  const spots = [...(side ? [side] : []), ...(below ? SPOTS.slice(2, 4) : []), ...SPOTS];
  const all = AWAY.map((away) =>
    spots.map(([across, down]) => {
      const gap = below && !across ? 1.6 * away : away;
      const [left, top] = [x + across * (gap + w / 2) - w / 2, y + down * (gap + h / 2) - h / 2];
      return { left, top, right: left + w, bottom: top + h };
    }),
  );
  const isClear = (box: Box) =>
    box.left >= 4 && box.top >= 4 && box.right <= width - 4 && box.bottom <= height - 4 && ![...boxes, ...taken].some((other) => overlap(box, other)) && !rounds.some((round) => isOn(round, box)) && !isStruck(box, strokes);
  const near = all.slice(0, NEAR).flat().find((box) => isClear(box) && !isStruck(box, faint));
  return near ?? all.flat().find(isClear) ?? null;
}

/** A line from the word to its thing, which the style sheet draws. */
function lead({ style }: HTMLElement, { x, y }: Label, { left, top, right, bottom }: Box) {
  const [fromX, fromY] = [Math.max(left, Math.min(right, x)), Math.max(top, Math.min(bottom, y))];
  const long = Math.hypot(x - fromX, y - fromY);
  style.setProperty("--lead", `translate(${fromX - left}px, ${fromY - top}px) rotate(${Math.atan2(y - fromY, x - fromX)}rad) scaleX(${long < LED ? 0 : long - 8})`);
}

export function createLabels() {
  const root = element("div", "labels");
  root.setAttribute("aria-hidden", "true"); // the card says the same in words
  const spans = new Map<string, HTMLSpanElement>();
  const widths = new Map<string, number>(); // of words that were measured, CSS pixels

  function spanOf(label: Label) {
    const known = spans.get(label.key);
    if (known) return known;
    const span = element("span");
    spans.set(label.key, span);
    root.append(span);
    return span;
  }

  function widthOf(span: HTMLSpanElement, { text, kind }: Label, large: number): number {
    const key = kind + large + text;
    if (!widths.has(key)) {
      span.hidden = false;
      widths.set(key, span.offsetWidth);
    }
    return widths.get(key)!;
  }

  return {
    element: root,
    /** Most important first; large: times as large as on a desk. */
    show(labels: readonly Label[], width: number, height: number, clear = NOTHING, large = 1) {
      const taken: Box[] = [];
      const alive = new Set(labels.map((label) => label.key));
      for (const [key, span] of spans) if (!alive.has(key)) span.remove(), spans.delete(key);
      for (const label of labels) {
        const span = spanOf(label);
        if (span.textContent !== label.text) span.textContent = label.text;
        span.className = label.kind;
        const box = place(label, [widthOf(span, label, large), HEIGHT * large], width, height, clear, taken);
        span.hidden = !box;
        if (!box) continue;
        taken.push(box);
        span.style.transform = `translate(${Math.round(box.left)}px, ${Math.round(box.top)}px)`;
        lead(span, label, box);
      }
    },
  };
}
