/** Colours that carry meaning, on a dark page; on a light one: light-page.ts. Page colours live in styles/. */
import { LINE_KINDS, LINES as TABLE, type LineKind } from "./trace/kinds";

/** How a kind of ray is drawn: never by hue alone, so each has its own dash.
 *  dash: [drawn, gap] in screen pixels; [1, 0] is a solid line. wide: times as thick as the others. */
export const LINES = Object.fromEntries(LINE_KINDS.map((kind) => [kind, { ...TABLE[kind], colour: TABLE[kind].dark }])) as Record<LineKind, (typeof TABLE)[LineKind] & { colour: string }>;

export const STAGE = {
  lamp: "#FFE9A8",
  lampOff: "#A9B4C1",
  camera: "#E8ECF1",
  frustum: "#8B95A3",
  gridEmpty: "#AEB9C7",
  gridFilled: "#10141A",
  ring: "#FFFFFF", // round an empty tile
  boxEntered: "#FFD9A0",
  boxMissed: "#8FA3B8",
  casing: "#0B0F14", // round the selected rays: they stand out from bright walls too
  onPaper: false,
  wall: [0.4, 0.43, 0.48], // shares of its colour: walls step back behind the objects they carry
  wallGlow: 0.6, // share of what it shows without any light
};

/** Of a lamp's sign: its light's hue, as bright as a sign must be; a white lamp has the sign's own colour. */
export function lampColour(light: readonly number[]): string {
  const most = Math.max(...light);
  if (most - Math.min(...light) <= 0.12 * most) return STAGE.lamp;
  const shade = (v: number) => Math.round(255 * (STAGE.onPaper ? (0.78 * v) / most : 0.25 + (0.75 * v) / most));
  return `#${light.map((v) => shade(v).toString(16).padStart(2, "0")).join("")}`;
}

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
  if (!tile) return STAGE.ring;
  const brightness = (0.299 * tile[0] + 0.587 * tile[1] + 0.114 * tile[2]) / 255;
  return brightness < DARK ? "#FFFFFF" : brightness > BRIGHT ? "#000000" : "#FFF04A";
}
