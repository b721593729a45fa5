/** Small builders for the page's elements. No inline style attributes: the pages' policy forbids them. */
import { say, type Phrase } from "./words";

type Child = Node | string;

export function element<K extends keyof HTMLElementTagNameMap>(tag: K, className = "", ...children: Child[]): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  if (className) made.className = className;
  made.append(...children);
  return made;
}

/** Gives it the name that is read aloud, and its role. */
export function named<E extends Element>(of: E, label: string, role = ""): E {
  of.setAttribute("aria-label", label);
  if (role) of.setAttribute("role", role);
  return of;
}

export const group = (label: string, className: string, ...parts: HTMLElement[]) => named(element("div", `group ${className}`, element("span", "group-name", label), ...parts), label, "group");

/** What is read aloud: it holds the word on the button, so that it can be spoken to as well (WCAG 2.5.3). */
function explain(of: HTMLElement, word: string, help: string) {
  const isSign = !/[\p{L}\p{N}]/u.test(word);
  of.title = help;
  named(of, isSign || help.toLowerCase().startsWith(word.toLowerCase()) ? help : `${word}: ${help}`);
}

/** A button whose help is read aloud and shown on hover. `key`: the key that does the same, shown beside the word. */
export function button(text: string, help: string, press: () => void, { key = "", className = "" } = {}): HTMLButtonElement {
  const made = element("button", className, element("span", "word", text));
  made.type = "button";
  explain(made, text, help);
  if (key) {
    const sign = element("kbd"); // drawn, not text: the button's name has it in words
    sign.dataset.key = key === "Space" ? say("key.space") : key;
    made.append(sign);
  }
  made.addEventListener("click", press);
  return made;
}

/** Phrases as nodes: bold, or in a ray kind's colour. */
export const marked = (phrases: readonly Phrase[]): Child[] =>
  phrases.map((phrase) => (typeof phrase === "string" ? phrase : element("b", phrase[1] && `kind ${phrase[1]}`, phrase[0])));

/** Another word on a button, and another help where it has one. */
export function setWord(of: HTMLElement, text: string, help = of.title) {
  const word = of.querySelector(".word") ?? of;
  if (word.textContent === text && of.title === help) return;
  word.textContent = text;
  if (help) explain(of, text, help);
}

export const pressed = (of: HTMLElement, on: boolean) => of.setAttribute("aria-pressed", String(on));
/** Not `disabled`: the focus would fall off the button under a keyboard user's finger. */
export const disable = (of: HTMLElement, on: boolean) => of.setAttribute("aria-disabled", String(on));

/** A row that does what a click on it means, by key too. */
export function clickable(row: HTMLElement, act: () => void): HTMLElement {
  row.tabIndex = 0;
  row.addEventListener("click", act);
  row.addEventListener("keydown", (event) => event.key === "Enter" && act());
  return row;
}

export function swatch(colour: string): HTMLElement {
  const made = element("span", "swatch");
  made.style.backgroundColor = colour;
  made.setAttribute("aria-hidden", "true");
  return made;
}
