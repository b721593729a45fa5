/** The stage as a picture of its own: what is drawn, the labels over it, and a line that says what it shows. */
const CAPTION = 34; // CSS pixels high

export function snapshot(drawn: HTMLCanvasElement, labels: HTMLElement | null, caption: string): HTMLCanvasElement {
  const ratio = drawn.width / drawn.clientWidth;
  const made = document.createElement("canvas");
  made.width = drawn.width;
  made.height = drawn.height + Math.round(CAPTION * ratio);
  const brush = made.getContext("2d")!;
  const colour = (name: string) => getComputedStyle(document.body).getPropertyValue(name).trim();
  const ground = brush.createLinearGradient(0, 0, 0, made.height);
  ground.addColorStop(0, colour("--stage-top"));
  ground.addColorStop(0.78, colour("--ground"));
  brush.fillStyle = ground;
  brush.fillRect(0, 0, made.width, made.height);
  brush.drawImage(drawn, 0, 0);
  brush.scale(ratio, ratio);
  brush.fillStyle = colour("--words");
  brush.textBaseline = "middle";
  const from = drawn.getBoundingClientRect();
  for (const label of labels?.querySelectorAll<HTMLElement>("span:not([hidden])") ?? []) {
    const box = label.getBoundingClientRect();
    const { font, textAlign } = getComputedStyle(label);
    brush.font = font;
    brush.textAlign = "center";
    const middle = (box.left + box.right) / 2 - from.left;
    brush.textAlign = textAlign === "center" ? "center" : "left";
    brush.fillText(label.textContent ?? "", textAlign === "center" ? middle : box.left - from.left + 4, (box.top + box.bottom) / 2 - from.top);
  }
  brush.textAlign = "left";
  brush.font = `14px ${getComputedStyle(document.body).fontFamily}`;
  brush.fillText(caption, 16, drawn.clientHeight + CAPTION / 2);
  return made;
}
