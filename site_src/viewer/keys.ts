/** What each key does. A key is left alone while something else wants it. */
import type { Actions } from "./actions";
import type { Modes } from "./modes";
import { singleKeys } from "./panels/remember";

const LAMP_WAITS = 2500; // ms for the number after L

const SLIDER = "input[type=range]";
const TYPING = "input:not([type=range]), textarea, select, [contenteditable]:not([contenteditable=false])";
const PRESSABLE = "button, a[href], summary";

export function listenToKeys(acts: Actions & Modes) {
  const table: Readonly<Record<string, () => void>> = {
    " ": acts.render,
    a: () => acts.rays("all"),
    h: () => acts.rays("row"),
    v: () => acts.rays("column"),
    ArrowLeft: () => acts.move(-1, 0),
    ArrowRight: () => acts.move(1, 0),
    ArrowUp: () => acts.move(0, -1),
    ArrowDown: () => acts.move(0, 1),
    "+": () => acts.level(1),
    "=": () => acts.level(1), // + without Shift on many keyboards
    "-": () => acts.level(-1),
    PageUp: () => acts.page(-1),
    PageDown: () => acts.page(1),
    r: acts.camera,
    t: acts.nextLook,
    x: acts.nextSlice,
    p: acts.play,
    ",": () => acts.event(-1),
    ".": () => acts.event(1),
    f: acts.fullScreen,
    j: acts.projector,
    b: acts.black,
    "?": acts.help,
    Escape: acts.endEvents,
    "[": () => acts.bounces(-1),
    "]": () => acts.bounces(1),
    s: acts.shadows,
    c: acts.nextColours,
    l: () => void (lampUntil = Date.now() + LAMP_WAITS),
  };
  let lampUntil = 0; // L was pressed: until then a number is a lamp's
  function pressNumber(key: string) {
    const isLamp = Date.now() < lampUntil;
    lampUntil = 0;
    if (isLamp) acts.turnLamp((Number(key) + 9) % 10); // 1 is the first, 0 the tenth
    else acts.sceneKey(key);
  }

  function press(event: KeyboardEvent) {
    if (event.ctrlKey || event.altKey || event.metaKey || event.isComposing || event.defaultPrevented) return;
    if (event.key !== "?" && document.querySelector("dialog[open]")) return; // the page below a sheet keeps still
    if (event.key === "Escape" && document.querySelector(":popover-open")) return; // it closes that
    const target = event.target instanceof Element ? event.target : null;
    if (target?.closest(TYPING) || target?.closest("[popover]")) return;
    if (event.key === " " && target?.closest(PRESSABLE)) return; // it presses that button
    if (target?.closest(SLIDER) && event.key.length > 1 && event.key !== "Escape") return;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    if (key.length === 1 && key !== " " && !singleKeys.on) return;
    const act = /^\d$/.test(key) ? () => pressNumber(key) : table[key];
    if (!act || (event.repeat && /^[ abhvpfjrsc?\d]$/.test(key))) return;
    event.preventDefault();
    act();
    acts.pressed(key);
  }

  window.addEventListener("keydown", press);
}
