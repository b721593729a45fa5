/** What lies over the page: the invitation to touch it, and the question whether somebody is still there. */
import { button, element } from "../element";
import { say } from "../words";

const FADES = 400; // ms: longer than a tap takes to become a click, which must not reach what lies below

const marks = () => document.querySelector(".kiosk-marks")!;
/** Keyboard and screen reader reach what lies over the page only. */
function shut(page: boolean) {
  for (const part of document.body.children) if (part !== marks() && part.tagName !== "SCRIPT") part.toggleAttribute("inert", page);
}

/** Touch anywhere, or any key. */
export function createBegin(begun: () => void) {
  const words = element("span", "kiosk-begin-words");
  const cover = element("button", "kiosk-begin", words);
  cover.type = "button";
  let isShown = false;

  /** In the page's language first, then in the others. */
  function write() {
    const others = [...document.querySelectorAll<HTMLLinkElement>("link[rel=alternate][data-begin]")].filter((link) => link.hreflang !== document.documentElement.lang);
    const line = (link: HTMLLinkElement) => {
      const made = element("span", "kiosk-begin-other", link.dataset.begin!);
      made.lang = link.hreflang;
      return made;
    };
    words.replaceChildren(element("span", "", say("kiosk.begin")), ...others.map(line));
  }

  function begin(event: Event) {
    if (!isShown || (event instanceof KeyboardEvent && /^(Shift|Control|Alt|Meta|Tab)$/.test(event.key))) return;
    event.preventDefault();
    event.stopPropagation();
    isShown = false;
    begun();
  }
  cover.addEventListener("pointerup", begin);
  cover.addEventListener("click", begin);
  window.addEventListener("keydown", begin, { capture: true });

  return {
    show() {
      if (isShown) return;
      isShown = true;
      write();
      marks().append(cover);
      shut(true);
      document.documentElement.classList.add("attract");
      cover.focus({ preventScroll: true });
    },
    hide() {
      document.documentElement.classList.remove("attract");
      shut(false);
      setTimeout(() => !isShown && cover.remove(), FADES);
    },
  };
}

/** Counts down; any input goes on. */
export function createWarning() {
  const left = element("output", "kiosk-left numbers");
  const heading = element("h2", "", say("kiosk.stillThere"));
  const sheet = element("dialog", "sheet kiosk-warning");
  const goOn = button(say("kiosk.goOn"), say("kiosk.goOnHelp"), () => sheet.close(), { className: "primary" });
  sheet.append(heading, left, goOn);
  sheet.setAttribute("role", "alertdialog");
  sheet.setAttribute("aria-label", say("kiosk.stillThere"));
  left.setAttribute("aria-live", "off"); // once is enough: the seconds would fall over one another
  marks().append(sheet);
  let hiding = 0;
  return {
    show(seconds: number) {
      clearTimeout(hiding);
      left.textContent = say("kiosk.left", { count: seconds });
      if (!sheet.open) sheet.showModal();
    },
    /** Not at once: see FADES. */
    hide() {
      clearTimeout(hiding);
      hiding = window.setTimeout(() => sheet.close(), FADES);
    },
  };
}
