/** A sheet over the page: keeps the focus, closes with Esc, its cross or a click beside it, and gives the focus back. */
import { say } from "../words";
import { button, element, named } from "../element";

export function createDialog(title: string, ...content: Node[]) {
  const sheet = named(element("dialog", "sheet"), title);
  const close = button("\u00d7", say("dialog.close"), () => sheet.close(), { className: "sign quiet" });
  sheet.append(element("div", "sheet-head", element("h2", "", title), close), ...content);
  sheet.addEventListener("click", (event) => event.target === sheet && sheet.close());
  sheet.addEventListener("close", () => sheet.remove());
  // What is pressed in a sheet is meant for it: the page below keeps still.
  sheet.addEventListener("keydown", (event) => event.stopPropagation());
  return {
    sheet,
    open() {
      document.body.append(sheet);
      sheet.showModal();
    },
    isOpen: () => sheet.open,
    close: () => sheet.close(),
  };
}
