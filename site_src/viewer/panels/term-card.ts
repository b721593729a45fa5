/**
 * A card on each term in a lesson: where the pointer rests on it, the focus is on it, or a finger has touched it. Escape
 * puts it away (WCAG 1.4.13). Without what it says, which a script of the glossary's page holds, the link just leads there.
 */
import { element } from "../element";
import { say } from "../words";

const RESTS = 180; // ms that the pointer is on a term before its card comes, and off both before it goes
const EDGE = 8; // CSS pixels between card and window, and between card and term

declare global {
  var raywalkGlossary: Readonly<Record<string, readonly [string, string]>> | undefined; // term and meaning, by id
}

/** What a term means: the script that holds it is asked for when the first one is looked at. */
async function entryOf(link: HTMLAnchorElement) {
  if (!globalThis.raywalkGlossary)
    await new Promise<void>((done) => {
      const script = Object.assign(element("script"), { src: new URL("terms.js", link.href).href, onload: done, onerror: done });
      document.head.append(script);
    });
  return globalThis.raywalkGlossary?.[link.hash.slice(1)];
}

function placeBy(card: HTMLElement, link: HTMLElement) {
  const [at] = link.getClientRects(); // of a term over two lines the first
  const { width, height } = card.getBoundingClientRect();
  const left = Math.max(EDGE, Math.min(innerWidth - width - EDGE, at.left + at.width / 2 - width / 2));
  const above = at.top - height - EDGE;
  card.style.left = `${left}px`;
  card.style.top = `${above >= EDGE ? above : Math.min(at.bottom + EDGE, innerHeight - height - EDGE)}px`;
}

export function listenToTerms(body: HTMLElement) {
  const card = element("div", "term-card");
  card.id = "term-card";
  card.hidden = true;
  let shown: HTMLAnchorElement | null = null;
  let wanted: HTMLAnchorElement | null = null;
  let timer = 0;
  const termAt = (target: EventTarget | null) => (target instanceof Element ? target.closest<HTMLAnchorElement>("a.term") : null);

  function hide() {
    clearTimeout(timer);
    shown?.removeAttribute("aria-describedby");
    shown = wanted = null;
    card.hidden = true;
  }
  /** false: its meaning cannot be had. */
  async function show(link: HTMLAnchorElement): Promise<boolean> {
    clearTimeout(timer);
    if (link === shown) return true;
    wanted = link;
    const entry = await entryOf(link);
    if (!entry || wanted !== link || !link.isConnected) return !!entry;
    hide();
    const more = element("a", "", say("term.more"));
    more.href = link.href;
    card.replaceChildren(element("b", "", entry[0]), element("p", "", entry[1]), more);
    (body.querySelector("main") ?? body).append(card);
    card.hidden = false;
    placeBy(card, link);
    link.setAttribute("aria-describedby", card.id);
    shown = wanted = link;
    return true;
  }
  const soon = (act: () => void) => {
    clearTimeout(timer);
    timer = window.setTimeout(act, RESTS);
  };

  body.addEventListener("pointerover", ({ target, pointerType }) => {
    const link = termAt(target);
    if (pointerType === "touch") return;
    if (link) soon(() => void show(link));
    else if (card.contains(target as Node)) clearTimeout(timer);
    else if (shown) soon(() => document.activeElement !== shown && hide());
    else clearTimeout(timer);
  });
  body.addEventListener("focusin", ({ target }) => {
    const link = termAt(target);
    if (link?.matches(":focus-visible")) void show(link);
    else if (!link && !card.contains(target as Node)) hide();
  });
  body.addEventListener("click", (event) => {
    const link = termAt(event.target);
    if (!link) return void (shown && !card.contains(event.target as Node) && hide());
    if (event.ctrlKey || event.metaKey || event.shiftKey) return; // in another tab
    const isSecond = link === shown && !event.detail; // Enter on what is shown leads to the glossary
    if (isSecond) return;
    event.preventDefault();
    void show(link).then((isThere) => isThere || location.assign(link.href));
  });
  window.addEventListener(
    "keydown",
    (event) => {
      if (event.key !== "Escape" || !shown) return;
      event.stopPropagation();
      hide();
    },
    true,
  );
  window.addEventListener("resize", hide);
  body.addEventListener("scroll", () => shown && !shown.matches(":focus") && hide(), true);
  return {
    /** Another step is shown: its terms are gone. */
    step: () => void (shown && !shown.isConnected && hide()),
  };
}
