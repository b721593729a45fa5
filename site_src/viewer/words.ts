/** Every sentence a person reads that the viewer makes. The lesson's own words come with the scene. */
import type { LineKind } from "./state/lines";
import type { Vec3 } from "./trace/types";

/** Three decimals; minus signs as wide as plus. */
export const number = (value: number): string => (Object.is(Math.round(value * 1000), -0) ? 0 : value).toFixed(3).replace("-", "\u2212");
export const vector = (v: Vec3): string => `(${v.map(number).join(", ")})`;
const eightBit = (v: number) => Math.round(255 * Math.min(1, Math.max(0, v)));
export const bytes = (colour: Vec3): string => colour.map(eightBit).join(", ");
export const hexOf = (colour: Vec3): string => "#" + colour.map((v) => eightBit(v).toString(16).padStart(2, "0")).join("");

export const LINE_WORDS: Readonly<Record<LineKind, string>> = {
  camera: "camera ray",
  reflected: "reflected",
  refracted: "refracted",
  total: "totally reflected",
  reached: "reaches the light",
  blocked: "blocked",
};

/** Whole numbers as people write them: 11 025. */
export const grouped = (value: number): string => String(value).replace(/\B(?=(\d{3})+$)/g, "\u202f");

export const LEFT_OUT = (left: number, most: number): string => `${grouped(left)} shadow rays are left out: above ${grouped(most)} lines they are not drawn.`;

/** The first word of a card's line. */
export const KIND_WORDS: Readonly<Record<string, string>> = {
  camera: "camera",
  reflected: "reflected",
  refracted: "refracted",
  total: "totally reflected",
};

export const STAGE_WORDS = {
  label: "The scene in space. Arrow keys move the selected pixel; the buttons in the corner turn, move and zoom the view.",
  camera: "camera",
  point: vector,
  wait: "Loading the scene",
};

export const CONTROL_WORDS = {
  render: { empty: "Render", filling: "Finish", filled: "Empty" },
  renderHelp: "Fill the tiles in scan order while rays shoot; again: skip to the end; again: empty (Space)",
  speed: (speed: number) => `${({ 0.25: "\u00bc", 0.5: "\u00bd" } as Record<number, string>)[speed] ?? speed}\u00d7`,
  rays: "Rays",
  choices: {
    pixel: ["Pixel", "", "Rays of the selected pixel"],
    row: ["Row", "H", "Rays of the selected row (H)"],
    column: ["Column", "V", "Rays of the selected column (V)"],
    all: ["All", "A", "All rays of the frame (A)"],
  },
  grid: "Grid",
  gridSize: (n: number) => `${n} \u00d7 ${n}`,
  coarser: "Coarser grid (\u2212)",
  finer: "Finer grid (+)",
  moves: { left: "Pixel to the left (Left arrow)", up: "Pixel above (Up arrow)", down: "Pixel below (Down arrow)", right: "Pixel to the right (Right arrow)" },
  view: {
    pad: "The observer's view",
    turn: ["Turn", "The arrows turn the view. Press to let them move it"],
    shift: ["Move", "The arrows move the view. Press to let them turn it"],
    up: "up",
    down: "down",
    left: "left",
    right: "right",
    nearer: "Zoom in (wheel)",
    farther: "Zoom out (wheel)",
    start: ["Start", "Observer back to the start view"],
    camera: ["Camera", "Observer to the ray-tracing camera (R)"],
  },
  previousScene: "Previous scene (Page up)",
  nextScene: "Next scene (Page down)",
};

export const LESSON_WORDS = {
  region: "Lesson",
  start: "Start the lesson",
  end: "End the lesson",
  previous: "Previous step",
  next: "Next step",
  reveal: ["Reveal", "Reveal the answer"],
  covered: "Predict first: the numbers come with the answer.",
  place: (step: number, of: number) => `Step ${step + 1} of ${of}`,
};

export const PICTURE_WORDS = {
  region: "Picture",
  alt: (title: string) => `The ray-traced picture: ${title}`,
};

export const CARD_WORDS = {
  region: "The selected pixel's rays",
  pixel: (column: number, row: number) => `Pixel ${column}, ${row}`,
  hits: (kind: string, object: string) => [kind, " ray hits ", object],
  leaves: (kind: string) => [kind, " ray ", "leaves the scene"],
  shadow: (light: string) => ["shadow", ` ray to ${light} `],
  arrives: "arrives",
  blockedBy: (name: string) => `blocked by ${name}`,
  away: "faces away",
  awayLine: (light: string) => ["no shadow ray", ` to ${light}: the surface `],
  t: (t: number) => `t ${number(t)}`,
  brings: "brings back",
  normal: (v: Vec3) => `normal ${vector(v)}`,
  light: (diffuse: number, specular: number) => `diffuse ${number(diffuse)} \u00b7 specular ${number(specular)}`,
  unasked: "counts as seen",
  share: (weight: number) => `${Math.round(weight * 1000) / 10} % of the ray above`,
  meets: "meets",
  nearest: "nearest",
  more: (count: number) => `and ${count} more ${count === 1 ? "ray" : "rays"}`,
  waiting: "The rays of this grid are on their way.",
  none: "The rays of this grid are not here; the picture and the lesson are.",
};

export const FIGURE_WORDS = {
  title: "Figures",
  answer: "Answer",
  size: ["Picture", (size: number) => `${size} \u00d7 ${size} pixels`],
  levels: ["Grids", (levels: readonly number[]) => levels.join(", ")],
  depth: ["Most bounces", (depth: number) => String(depth)],
  shadows: ["Shadow rays", (on: boolean) => (on ? "yes" : "no")],
  rays: (n: number) => `Rays at ${n} \u00d7 ${n}`,
} as const;

export const TROUBLE = {
  sceneMissing: "The scene's data could not be loaded, so nothing can be moved here; the picture, the lesson and the figures below are complete.",
  sceneDamaged: "The scene's data is damaged, so nothing can be moved here; the picture, the lesson and the figures below are complete.",
  traceMissing: (n: number) => `The rays of the ${n} \u00d7 ${n} grid could not be loaded; the picture, the lesson and the scene in space still work, and so may another grid.`,
  traceDamaged: (n: number) => `The rays of the ${n} \u00d7 ${n} grid are damaged; the picture, the lesson and the scene in space still work, and so may another grid.`,
  pictureMissing: "The picture could not be loaded; the tiles and the rays still work.",
  noUnpacking: "This browser is too old to unpack the rays; the picture, the lesson and the figures below are complete.",
  refused: "This browser gives no WebGL: the scene is drawn in a simpler way; everything else works.",
  lost: "The graphics card dropped the drawing: the scene goes on in a simpler way; everything else works.",
  address: (keys: readonly string[]) => `The address asks for something this scene does not have (${keys.join(", ")}); that part is at its start.`,
  unknownScene: (id: string) => `There is no scene called \u201c${id}\u201d; this is the one the page is for.`,
  close: "Close this message",
};
