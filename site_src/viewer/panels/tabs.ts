/** One of several panels at a time, chosen by tabs. The choice is remembered. */
import { button, element, named } from "../element";
import { recall, remember } from "./remember";

export interface Tab<Id extends string> {
  id: Id;
  word: string;
  help: string;
  panel: HTMLElement;
}

export function createTabs<Id extends string>(name: string, label: string, tabs: readonly Tab<Id>[], changed: (to: Id) => void) {
  const kept = recall(name);
  let chosen = tabs.find(({ id }) => id === kept)?.id ?? tabs[0].id;
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
    const at = (tabs.findIndex(({ id }) => id === chosen) + by + tabs.length) % tabs.length;
    choose(tabs[at].id);
    buttons[at].focus();
  });

  function show() {
    tabs.forEach(({ id, panel }, k) => {
      panel.hidden = id !== chosen;
      buttons[k].setAttribute("aria-selected", String(id === chosen));
      buttons[k].tabIndex = id === chosen ? 0 : -1;
    });
  }
  function choose(id: Id) {
    chosen = id;
    remember(name, id);
    show();
    changed(id);
  }
  show();
  return { bar, panels: tabs.map(({ panel }) => panel), chosen: () => chosen };
}
