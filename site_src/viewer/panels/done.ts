/** Says that something was done: by a tick on its button, and in a sentence over the page that disappears by itself. Nothing moves. */
import { element } from "../element";

const SHOWN_FOR = 3500; // ms
const TICKED_FOR = 1500;

const sentence = element("p", "done-sentence");
sentence.setAttribute("role", "status");
document.body.append(sentence);
let timer = 0;

export function sayDone(by: HTMLElement, says: string) {
  clearTimeout(timer);
  sentence.textContent = says;
  timer = window.setTimeout(() => (sentence.textContent = ""), SHOWN_FOR);
  by.classList.add("done");
  setTimeout(() => by.classList.remove("done"), TICKED_FOR);
}
