/** All keys on one sheet, what a pressed key means for those who watch, and what fingers do on the stage. */
import { say } from "../words";
import { createDialog } from "./dialog";
import { button, element, pressed } from "../element";
import { sayDone } from "./done";
import { KEYS_KEPT, singleKeys } from "./remember";

/** keys: as events name them. signs: as people read them, if that is something else. */
const GROUPS = [
  [
    { name: "render", keys: [" "] },
    { name: "all", keys: ["a"] },
    { name: "row", keys: ["h"] },
    { name: "column", keys: ["v"] },
    { name: "move", keys: ["ArrowLeft", "ArrowUp", "ArrowDown", "ArrowRight"] },
    { name: "level", keys: ["+", "-"] },
    { name: "colours", keys: ["c"] },
    { name: "slice", keys: ["x"] },
    { name: "stage", keys: ["t"] },
  ],
  [
    { name: "play", keys: ["p"] },
    { name: "event", keys: [",", "."] },
    { name: "bounces", keys: ["[", "]"] },
    { name: "lamp", keys: ["l"] },
    { name: "shadows", keys: ["s"] },
    { name: "sweep", keys: ["<", ">"] },
  ],
  [
    { name: "drag", keys: [] },
    { name: "shiftDrag", keys: [] },
    { name: "wheel", keys: [] },
    { name: "camera", keys: ["r"] },
  ],
  [
    { name: "scene", keys: ["1", "2", "3", "4", "5", "6", "7", "8", "9", "0"] },
    { name: "page", keys: ["PageUp", "PageDown"] },
    { name: "fullScreen", keys: ["f"] },
    { name: "projector", keys: ["j"] },
    { name: "black", keys: ["b"] },
    { name: "help", keys: ["?"] },
    { name: "back", keys: ["Escape"] },
  ],
] as const;
const ROWS = GROUPS.flat();
type Row = (typeof ROWS)[number];

const SIGNS: Readonly<Record<string, string>> = { ArrowLeft: "\u2190", ArrowUp: "\u2191", ArrowDown: "\u2193", ArrowRight: "\u2192", "-": "\u2212" };
const signOf = (key: string) => {
  if (key === " ") return say("key.space");
  if (key === "PageUp" || key === "PageDown" || key === "Escape") return say(`key.${key}`);
  return SIGNS[key] ?? key.toUpperCase();
};

/** Turns keys of one character off and on again (WCAG 2.1.4). notify: says that the browser keeps nothing, so that this holds
 *  until the page is closed. */
function keySwitch(notify: (sentence: string) => void) {
  const made = button(say("help.single.word"), say("help.single.help"), () => {
    singleKeys.on = !singleKeys.on;
    pressed(made, singleKeys.on);
    try {
      localStorage.setItem(KEYS_KEPT, singleKeys.on ? "on" : "off");
    } catch {
      notify(say("trouble.storage"));
    }
  });
  pressed(made, singleKeys.on);
  return element("p", "note", made);
}

function rowOf({ name, keys }: Row) {
  const signs = name === "scene" ? ["1", "\u2026", "9", "0"] : keys.length ? keys.map(signOf) : [say(`key.${name as "drag"}.sign`)];
  const term = element("dt", "", ...signs.map((sign) => (sign === "\u2026" ? sign : element("kbd", "", sign))), ...(name === "lamp" ? [` ${say("key.number")}`] : []));
  return element("div", "", term, element("dd", "", say(`key.${name}.does`)));
}

/** A sheet that opens and closes by the same key. */
export function createHelp(notify: (sentence: string) => void) {
  let sheet: ReturnType<typeof createDialog> | null = null;
  return () => {
    if (sheet?.isOpen()) return sheet.close();
    const lists = GROUPS.map((rows: readonly Row[]) => element("dl", "keys", ...rows.map(rowOf)));
    sheet = createDialog(say("help.title"), element("div", "key-lists", ...lists), element("p", "note", say("help.note")), keySwitch(notify));
    sheet.sheet.addEventListener("keydown", (event) => event.key === "?" && sheet?.close());
    sheet.open();
  };
}

const SEEN_FOR = 1600; // ms

/** The last key and what it did, large, for those who watch a screen from afar. */
export function createKeySign(body: HTMLElement) {
  const root = element("div", "key-sign");
  root.setAttribute("aria-hidden", "true");
  root.hidden = true;
  body.append(root);
  let timer = 0;
  return {
    show(key: string) {
      const row = ROWS.find(({ keys }) => (keys as readonly string[]).includes(key));
      if (!row) return;
      root.replaceChildren(element("kbd", "", signOf(key)), ` ${say(`key.${row.name}.does`)}`);
      root.hidden = false;
      clearTimeout(timer);
      timer = window.setTimeout(() => (root.hidden = true), SEEN_FOR);
    },
  };
}

/** Said once, when a finger on the stage has scrolled the page. */
export function createSwipeHint() {
  let isSaid = false;
  return () => {
    if (!isSaid) sayDone(document.body, say("stage.swipe"));
    isSaid = true;
  };
}
