/** Small builders for the page's elements. No inline style attributes: the pages' policy forbids them. */
import type { Phrase } from "../words";

type Child = Node | string;

export function element<K extends keyof HTMLElementTagNameMap>(tag: K, className = "", ...children: Child[]): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  if (className) made.className = className;
  made.append(...children);
  return made;
}

/** A button whose help is read aloud and shown on hover. `key`: the key that does the same, shown beside the word. */
export function button(text: string, help: string, press: () => void, { key = "", className = "" } = {}): HTMLButtonElement {
  const made = element("button", className, element("span", "word", text));
  made.type = "button";
  made.title = help;
  made.setAttribute("aria-label", help);
  if (key) made.append(element("kbd", "", key));
  made.addEventListener("click", press);
  return made;
}

/** Phrases as nodes: bold, or in a ray kind's colour. */
export const marked = (phrases: readonly Phrase[]): Child[] =>
  phrases.map((phrase) => (typeof phrase === "string" ? phrase : element("b", phrase[1] && `kind ${phrase[1]}`, phrase[0])));

export function setWord(of: HTMLElement, text: string) {
  const word = of.querySelector(".word") ?? of;
  if (word.textContent !== text) word.textContent = text;
}

export const pressed = (of: HTMLElement, on: boolean) => of.setAttribute("aria-pressed", String(on));

export function swatch(colour: string): HTMLElement {
  const made = element("span", "swatch");
  made.style.backgroundColor = colour;
  made.setAttribute("aria-hidden", "true");
  return made;
}
