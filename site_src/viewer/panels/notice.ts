/** One sentence that says what is wrong and what still works. */
import { say } from "../words";
import { button, element } from "./element";

export function createNotice(root: HTMLElement) {
  const text = element("span", "notice-text");
  const close = button("\u00d7", say("trouble.close"), () => hide(), { className: "sign quiet" });
  root.replaceChildren(text, close);
  function hide() {
    root.hidden = true;
    text.textContent = "";
  }
  return {
    say(sentence: string) {
      text.textContent = sentence;
      root.hidden = false;
    },
    hide,
    text: () => (root.hidden ? "" : (text.textContent ?? "")),
  };
}
