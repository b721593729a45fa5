/** The page's own buttons: link, code for other pages, picture, full screen, help; and embedded, the way to the whole page. They come when the
 *  page's menu is first opened. */
import { say } from "../words";
import { copy } from "./clipboard";
import { sayDone } from "./done";
import { button, element, named } from "../element";
import { createPictureKind, type PictureKind } from "./picture-kind";

export interface ToolActs {
  /** Writes the view into the address now, and gives it. */
  address: () => string;
  /** done: with the file's name. */
  save: (what: "save" | "slide", done: (file: string) => void, kind: PictureKind) => void;
  notify: (sentence: string) => void;
  help: () => void;
}

/** The view's whole address; embedded, that of the page it belongs to. */
function linkOf(address: string): string {
  const whole = new URL(address);
  whole.searchParams.delete("embed");
  whole.hash = whole.hash.replace(/embed=1&?/, "");
  return whole.href;
}

/** From a page within another one to the whole page, with the same view. */
export function createWayOut(address: () => string) {
  const whole = element("a", "whole", say("tools.whole"));
  whole.target = "_blank";
  whole.rel = "noopener";
  const direct = () => void (whole.href = linkOf(address()));
  for (const on of ["pointerenter", "focus", "pointerdown"]) whole.addEventListener(on, direct);
  direct();
  return element("p", "embed-bar", whole);
}

const FRAME = 'width="900" height="640" allow="fullscreen; clipboard-write" loading="lazy" style="border:0"';

/** A frame in another page that shows this very view. link: the view's address. */
function frameOf(link: string): string {
  const inFrame = new URL(link);
  inFrame.search = "?embed";
  const quoted = (text: string) => text.replace(/&/g, "&amp;").replace(/"/g, "&quot;");
  return `<iframe src="${quoted(inFrame.href)}" title="${quoted(document.title)}" ${FRAME}></iframe>`;
}

/** Opened from the menu, the panel of slides takes the focus, and closed it gives it back: browsers do so for the menu, but not
 *  for what is over it. Written in the page, the word would ask for the focus at once, which frames may not. */
function letSlidesFocus() {
  const panel = document.querySelector("#take");
  panel?.setAttribute("autofocus", "");
  panel?.addEventListener("toggle", (event) => (event as ToggleEvent).newState === "closed" && document.querySelector<HTMLElement>(".take-open")!.focus());
}

export function createTools(acts: ToolActs) {
  letSlidesFocus();
  const picture = createPictureKind();
  const copying = (what: "link" | "embed", text: (link: string) => string) => {
    const made = button(say(`tools.${what}.word`), say(`tools.${what}.help`), () => void copy(text(linkOf(acts.address())), () => sayDone(made, say(`tools.${what}.done`))));
    return made;
  };
  const saving = (what: "save" | "slide") => {
    const made = button(say(`tools.${what}.word`), say(`tools.${what}.help`), () => acts.save(what, (file) => sayDone(made, say(`tools.${what}.done`, { file })), picture.kind));
    return made;
  };
  function fullScreen() {
    const done = document.fullscreenElement ? document.exitFullscreen() : document.documentElement.requestFullscreen?.();
    (done ?? Promise.reject()).catch(() => acts.notify(say("tools.noScreen")));
  }
  const screen = button(say("tools.fullScreen.word"), say("tools.fullScreen.help"), fullScreen);
  screen.hidden = !document.fullscreenEnabled;
  const root = element(
    "div",
    "tools",
    copying("link", (link) => link),
    copying("embed", frameOf),
    saving("save"),
    picture.element,
    saving("slide"),
    screen,
    button(say("tools.keys.word"), say("tools.keys.help"), acts.help, { key: "?" }),
  );
  return { element: named(root, say("tools.region"), "group"), fullScreen };
}
