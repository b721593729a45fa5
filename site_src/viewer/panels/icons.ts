/** Signs of the player, drawn: as characters some systems make coloured pictures of them. */
const SVG = "http://www.w3.org/2000/svg";

const SHAPES = {
  play: "M3 1.5 L14 8 L3 14.5 Z",
  pause: "M3 2 H6.6 V14 H3 Z M9.4 2 H13 V14 H9.4 Z",
  back: "M13 2 L5 8 L13 14 Z M2.4 2 H4.6 V14 H2.4 Z",
  on: "M3 2 L11 8 L3 14 Z M11.4 2 H13.6 V14 H11.4 Z",
} as const;

export function icon(name: keyof typeof SHAPES): SVGElement {
  const svg = document.createElementNS(SVG, "svg");
  for (const [key, value] of Object.entries({ width: 16, height: 16, viewBox: "0 0 16 16", "aria-hidden": "true" })) svg.setAttribute(key, String(value));
  const path = document.createElementNS(SVG, "path");
  path.setAttribute("d", SHAPES[name]);
  path.setAttribute("fill", "currentColor");
  svg.append(path);
  return svg;
}
