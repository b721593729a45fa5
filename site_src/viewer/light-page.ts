/** The stage's colours on a light page: as on paper, with a white casing so that dark lines show on dark things. */
import { LINES, STAGE } from "./palette";
import { LINE_KINDS } from "./trace/kinds";

const LIGHT = { lamp: "#E69F00", lampOff: "#5B6673", camera: "#5B6673", frustum: "#3F4A56", gridEmpty: "#5B6673", ring: "#0B4F94", boxEntered: "#8A4B00", boxMissed: "#7A8592", casing: "#FFFFFF", onPaper: true, wall: [1, 1, 1] };
const THICK = 1.6; // times as wide as on a desk: a light page is a lecture's, and seen from the last row
const DARK_PAGE = { ...STAGE };

/** Colours for a light or a dark page from now on. */
export function lightColours(isLight: boolean) {
  for (const kind of LINE_KINDS) {
    LINES[kind].colour = LINES[kind][isLight ? "light" : "dark"];
    LINES[kind].wide *= isLight ? THICK : 1 / THICK;
  }
  Object.assign(STAGE, isLight ? LIGHT : DARK_PAGE);
}
