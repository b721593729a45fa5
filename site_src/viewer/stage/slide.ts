/** The present view as a figure for slides: an SVG whose rays and words can be edited. What is shaded, the tiles
 *  and the thin rays are one picture inside of it; the selected pixel's rays, their ends and the labels are drawn. */
import { LINES } from "../palette";
import { worthOf, type Line } from "../state/lines";
import { seenPart, type Projection } from "../state/projection";

const CAPTION = 34; // CSS pixels high, as under a saved picture
const HEAD = 11; // length of an arrow's head, CSS pixels

const n = (value: number) => String(Math.round(value * 100) / 100);
const escaped = (text: string) => text.replace(/[&<>"]/g, (sign) => `&#${sign.charCodeAt(0)};`);

function ray(line: Line, projection: Projection, near: number): string {
  const seen = seenPart(projection, line.from, line.to, near);
  if (!seen) return "";
  const [a, b] = seen;
  const { colour, dash, wide } = LINES[line.kind];
  const dashes = dash[0] === 1 ? "" : ` stroke-dasharray="${dash.join(" ")}"`;
  const long = Math.hypot(b.x - a.x, b.y - a.y) || 1;
  const [ux, uy] = [((b.x - a.x) / long) * HEAD, ((b.y - a.y) / long) * HEAD];
  const head = [[b.x, b.y], [b.x - ux - 0.4 * uy, b.y - uy + 0.4 * ux], [b.x - ux + 0.4 * uy, b.y - uy - 0.4 * ux]];
  return (
    `<line x1="${n(a.x)}" y1="${n(a.y)}" x2="${n(b.x)}" y2="${n(b.y)}" stroke="${colour}" stroke-width="${n(3 * wide * worthOf(line))}"${dashes}/>` +
    (long > 2 * HEAD ? `<polygon points="${head.map((p) => p.map(n).join()).join(" ")}" fill="${colour}"/>` : "") +
    (line.light < 0 && !line.leaves && !line.growing ? `<circle cx="${n(b.x)}" cy="${n(b.y)}" r="4.5" fill="${colour}"/>` : "") +
    (line.kind === "blocked" && !line.growing ? `<path d="M${n(b.x - 6)} ${n(b.y - 6)}l12 12m0 -12l-12 12" stroke="${colour}" stroke-width="3"/>` : "")
  );
}

/** picture: of the stage without the chosen lines, as a data URL; labels: as they stand over the stage. */
export function slideSvg(picture: string, chosen: readonly Line[], labels: HTMLElement, caption: string, projection: Projection, near: number): string {
  const { width, height } = projection;
  const page = getComputedStyle(document.body);
  const words = page.getPropertyValue("--words").trim();
  const from = labels.getBoundingClientRect();
  const spans = [...labels.querySelectorAll<HTMLElement>("span:not([hidden])")].map((label) => {
    const box = label.getBoundingClientRect();
    const style = getComputedStyle(label);
    const x = (box.left + box.right) / 2 - from.left;
    const y = (box.top + box.bottom) / 2 - from.top;
    return `<text x="${n(x)}" y="${n(y)}" font-size="${Number.parseFloat(style.fontSize)}" fill="${words}" text-anchor="middle" dominant-baseline="central">${escaped(label.textContent ?? "")}</text>`;
  });
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height + CAPTION}" viewBox="0 0 ${width} ${height + CAPTION}" font-family="Arial, Helvetica, sans-serif">` +
    `<title>${escaped(caption)}</title><rect width="100%" height="100%" fill="${page.getPropertyValue("--ground").trim()}"/>` +
    `<svg width="${width}" height="${height}"><image width="${width}" height="${height}" href="${picture}"/>` +
    `<g>${chosen.map((line) => ray(line, projection, near)).join("")}</g><g>${spans.join("")}</g></svg>` +
    `<text x="16" y="${height + CAPTION / 2}" font-size="14" fill="${words}" dominant-baseline="central">${escaped(caption)}</text></svg>\n`
  );
}
