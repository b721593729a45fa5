/** A sheet over the page: keeps the focus, closes with Esc, its cross or a click beside it, and gives the focus back. */
import { say } from "../words";
import { button, element } from "./element";

export function createDialog(title: string, ...content: Node[]) {
  const sheet = element("dialog", "sheet");
  const close = button("\u00d7", say("dialog.close"), () => sheet.close(), { className: "sign quiet" });
  const heading = element("h2", "", title);
  sheet.append(element("div", "sheet-head", heading, close), ...content);
  sheet.setAttribute("aria-label", title);
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
