/** A lecture: a light page, on which what is not needed goes while the pointer rests; B turns the screen black until anything is pressed.
 *  What lines mean, which lesson this is and which keys lead on stay in sight. */
import { say } from "../words";
import { button, element } from "../element";
import { lightColours } from "../light-page";

const RESTS = 2500; // ms without the pointer moving
const WIDE = "(min-width: 761px)"; // there the legend's place is taken by the stage
const SEEN_FOR = 3000; // ms that the next lesson's title stands on the stage

/** A row over the sentence: what the lines mean, and the keys. Elsewhere the legend is the card's. */
function createRow(body: HTMLElement) {
  const key = (name: "PageDown" | "Escape") => element("kbd", "", say(`key.${name}`));
  const keys = element("span", "lecture-keys", key("PageDown"), ` ${say("lecture.on")}`, key("Escape"), ` ${say("lecture.leave")}`);
  const row = element("div", "lecture-row", keys);
  return (on: boolean) => {
    const legend = body.querySelector(".legend")!;
    const isRow = on && matchMedia(WIDE).matches && !body.classList.contains("embed");
    if (isRow) body.querySelector(".below")!.prepend(row);
    else row.remove();
    (isRow ? row : body.querySelector(".side")!)[isRow ? "prepend" : "append"](legend);
  };
}

/** Another scene's title, large, for those who saw only the sentence change. */
function createTitleSign(body: HTMLElement, isOn: () => boolean) {
  const sign = element("p", "title-sign");
  sign.setAttribute("aria-hidden", "true"); // the page's title says it
  const title = body.querySelector(".scene-title")!;
  let timer = 0;
  new MutationObserver(() => {
    if (!isOn() || sign.textContent === title.textContent) return;
    sign.textContent = title.textContent;
    body.querySelector(".stage")!.append(sign);
    clearTimeout(timer);
    timer = window.setTimeout(() => sign.remove(), SEEN_FOR);
  }).observe(title, { childList: true, characterData: true, subtree: true });
}

/** recolour: draws what was drawn in other colours. */
export function createLecture(body: HTMLElement, recolour: () => void) {
  let timer = 0;
  let isOn = false;
  const placeLegend = createRow(body);
  createTitleSign(body, () => isOn);
  const black = button("", say("lecture.black"), () => light(), { className: "blackout" });
  function moved() {
    clearTimeout(timer);
    body.classList.remove("resting");
    if (isOn) timer = window.setTimeout(() => body.classList.add("resting"), RESTS);
  }
  for (const what of ["pointermove", "pointerdown"]) window.addEventListener(what, moved);
  /** After what else Escape leaves: a sheet, an event. */
  window.addEventListener("keydown", ({ key }) => {
    const isElsewhere = body.querySelector("dialog[open], :popover-open, .lesson.captioned");
    if (isOn && key === "Escape" && !isElsewhere) body.querySelector<HTMLElement>("button.lecture")!.click();
  });
  function light() {
    black.remove();
    window.removeEventListener("keydown", anyKey, true);
  }
  function anyKey(event: KeyboardEvent) {
    event.preventDefault();
    event.stopPropagation();
    light();
  }
  return {
    show(on: boolean) {
      if (on === isOn) return;
      isOn = on;
      lightColours(on);
      placeLegend(on);
      recolour();
      moved();
      if (!on) light();
    },
    black() {
      body.append(black);
      black.focus();
      window.addEventListener("keydown", anyKey, true);
    },
  };
}
