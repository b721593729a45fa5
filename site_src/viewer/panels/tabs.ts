/** One of several panels, or none: the tab that is chosen closes its panel when it is pressed once more. */
import { button, element, named } from "../element";

export interface TabChoice<Id extends string> {
  id: Id;
  word: string;
  help: string;
  panel: HTMLElement;
}

export function createTabs<Id extends string>(name: string, label: string, tabs: readonly TabChoice<Id>[], choose: (id: Id) => void) {
  const buttons = tabs.map(({ id, word, help, panel }) => {
    const made = button(word, help, () => choose(id), { className: "tab" });
    made.setAttribute("role", "tab");
    made.id = `tab-${name}-${id}`;
    panel.id = `panel-${name}-${id}`;
    panel.setAttribute("role", "tabpanel");
    panel.setAttribute("aria-labelledby", made.id);
    made.setAttribute("aria-controls", panel.id);
    return made;
  });
  const bar = named(element("div", "joined tabs", ...buttons), label, "tablist");
  bar.addEventListener("keydown", (event) => {
    const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!by) return;
    event.preventDefault();
    const at = (buttons.indexOf(document.activeElement as HTMLButtonElement) + by + tabs.length) % tabs.length;
    choose(tabs[at].id);
    buttons[at].focus();
  });
  return {
    bar,
    panels: tabs.map(({ panel }) => panel),
    show(chosen: Id | "none") {
      tabs.forEach(({ id, panel }, k) => {
        panel.hidden = id !== chosen;
        buttons[k].setAttribute("aria-selected", String(id === chosen));
        buttons[k].tabIndex = id === chosen || (chosen === "none" && k === 0) ? 0 : -1;
      });
    },
  };
}
