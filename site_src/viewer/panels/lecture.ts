/** A lecture: a light page, on which what is not needed goes while the pointer rests; B turns the screen black until anything is pressed. */
import { say } from "../words";
import { button } from "../element";
import { lightColours } from "../light-page";

const RESTS = 2500; // ms without the pointer moving
const WIDE = "(min-width: 761px)"; // there the legend's place is taken by the stage

/** What the lines mean stays in sight: beside how far the lesson has come. */
function placeLegend(body: HTMLElement, on: boolean) {
  const place = on && matchMedia(WIDE).matches ? ".lesson-buttons" : ".side";
  body.querySelector(place)!.append(body.querySelector(".legend")!);
}

/** recolour: draws what was drawn in other colours. */
export function createLecture(body: HTMLElement, recolour: () => void) {
  let timer = 0;
  let isOn = false;
  const black = button("", say("lecture.black"), () => light(), { className: "blackout" });
  function moved() {
    clearTimeout(timer);
    body.classList.remove("resting");
    if (isOn) timer = window.setTimeout(() => body.classList.add("resting"), RESTS);
  }
  for (const what of ["pointermove", "pointerdown"]) window.addEventListener(what, moved);
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
      placeLegend(body, on);
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
