/** Signs of the player, drawn: some systems show characters as coloured pictures. */
import { svg } from "./svg";

const SHAPES = {
  play: "M3 1.5 L14 8 L3 14.5 Z",
  pause: "M3 2 H6.6 V14 H3 Z M9.4 2 H13 V14 H9.4 Z",
  back: "M13 2 L5 8 L13 14 Z M2.4 2 H4.6 V14 H2.4 Z",
  on: "M3 2 L11 8 L3 14 Z M11.4 2 H13.6 V14 H11.4 Z",
} as const;

export const icon = (name: keyof typeof SHAPES): SVGElement =>
  svg("svg", { width: 16, height: 16, viewBox: "0 0 16 16", "aria-hidden": "true" }, svg("path", { d: SHAPES[name], fill: "currentColor" }));
