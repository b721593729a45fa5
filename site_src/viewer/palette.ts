/** Colours that carry meaning. Page colours live in styles/. */
import type { LineKind } from "./state/lines";

/** How a kind of ray is drawn: never by hue alone, so each has its own dash.
 *  dash: [drawn, gap] in screen pixels; [1, 0] is a solid line. */
export const LINES: Readonly<Record<LineKind, { colour: string; dash: readonly [number, number] }>> = {
  camera: { colour: "#F0E442", dash: [1, 0] },
  reflected: { colour: "#56B4E9", dash: [12, 6] },
  refracted: { colour: "#CC79A7", dash: [20, 4] },
  total: { colour: "#56B4E9", dash: [4, 4] },
  reached: { colour: "#FFFFFF", dash: [2, 5] },
  blocked: { colour: "#D55E00", dash: [3, 7] },
};

export const STAGE = {
  lamp: "#FFE9A8",
  camera: "#E8ECF1",
  frustum: "#8B95A3",
  gridEmpty: "#AEB9C7",
  gridFilled: "#10141A",
} as const;

/** [r, g, b], each 0..1. */
export function rgb(hex: string): [number, number, number] {
  const value = Number.parseInt(hex.slice(1), 16);
  return [(value >> 16) / 255, ((value >> 8) & 255) / 255, (value & 255) / 255];
}

const DARK = 0.3; // perceived brightness below which only a light outline shows well
const BRIGHT = 0.75;

/** Outline of the selected tile: light on dark, black on white, yellow in between.
 *  tile: 8-bit red, green, blue, or null for a tile that is still empty. */
export function contrastWith(tile: readonly [number, number, number] | null): string {
  if (!tile) return "#FFFFFF";
  const brightness = (0.299 * tile[0] + 0.587 * tile[1] + 0.114 * tile[2]) / 255;
  return brightness < DARK ? "#FFFFFF" : brightness > BRIGHT ? "#000000" : "#FFF04A";
}
