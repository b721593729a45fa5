/** The stage as a picture of its own: what is drawn, the traced picture and the labels over it, as they are on the page, and
 *  a line that says what it shows. */
const CAPTION = 34; // CSS pixels high
const HALO = 3; // CSS pixels round words, as their shadow has on the page

type Brush = CanvasRenderingContext2D;
const colourOf = (name: string) => getComputedStyle(document.body).getPropertyValue(name).trim();

function paintGround(brush: Brush, { width, height }: HTMLCanvasElement) {
  const ground = brush.createLinearGradient(0, 0, 0, height);
  ground.addColorStop(0, colourOf("--stage-top"));
  ground.addColorStop(0.78, colourOf("--ground"));
  brush.fillStyle = ground;
  brush.fillRect(0, 0, width, height);
}

/** from: the drawing's box on the page. */
function paintTraced(brush: Brush, view: HTMLElement, from: DOMRect) {
  const clip = view.querySelector(".traced-picture:not([hidden])");
  const within = clip?.getBoundingClientRect();
  if (!clip || !within) return;
  brush.save();
  brush.beginPath();
  brush.rect(within.left - from.left, within.top - from.top, within.width, within.height);
  brush.clip();
  for (const each of clip.querySelectorAll<HTMLImageElement | HTMLCanvasElement>("img, canvas:not([hidden])")) {
    const { left, top, width, height } = each.getBoundingClientRect();
    brush.imageSmoothingEnabled = each instanceof HTMLImageElement; // tiles keep their edges
    brush.drawImage(each, left - from.left, top - from.top, width, height);
  }
  brush.restore();
}

function paintWords(brush: Brush, view: HTMLElement, from: DOMRect) {
  brush.lineWidth = 2 * HALO;
  brush.lineJoin = "round";
  brush.strokeStyle = colourOf("--stage-shade");
  brush.textBaseline = "middle";
  for (const label of view.querySelectorAll<HTMLElement>(".labels > span:not([hidden])")) {
    const box = label.getBoundingClientRect();
    const { fontWeight, fontSize, fontFamily, color, textAlign } = getComputedStyle(label);
    const font = `${fontWeight} ${fontSize} ${fontFamily}`; // as one word it is empty where figures are of equal width
    const isCentred = textAlign === "center";
    const at = [label.textContent ?? "", (isCentred ? (box.left + box.right) / 2 : box.left + 4) - from.left, (box.top + box.bottom) / 2 - from.top] as const;
    Object.assign(brush, { font, fillStyle: color, textAlign: isCentred ? "center" : "left" });
    brush.globalAlpha = 0.7; // a halo, no edge
    brush.strokeText(...at);
    brush.globalAlpha = 1;
    brush.fillText(...at);
  }
}

/** drawn: the view's canvas. caption: null for a picture without ground and caption. */
export function snapshot(drawn: HTMLCanvasElement, view: HTMLElement, caption: string | null): HTMLCanvasElement {
  const ratio = drawn.width / drawn.clientWidth;
  const made = document.createElement("canvas");
  made.width = drawn.width;
  made.height = drawn.height + (caption === null ? 0 : Math.round(CAPTION * ratio));
  const brush = made.getContext("2d")!;
  if (caption !== null) paintGround(brush, made);
  brush.drawImage(drawn, 0, 0);
  brush.scale(ratio, ratio);
  const from = drawn.getBoundingClientRect();
  paintTraced(brush, view, from);
  paintWords(brush, view, from);
  if (caption !== null) {
    brush.textAlign = "left";
    brush.fillStyle = colourOf("--words");
    brush.font = `14px ${getComputedStyle(document.body).fontFamily}`;
    brush.fillText(caption, 16, drawn.clientHeight + CAPTION / 2);
  }
  return made;
}
