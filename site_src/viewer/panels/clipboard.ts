/** A text into the clipboard or, where that is refused, to be copied by hand. */
import { say } from "../words";
import { createDialog } from "./dialog";
import { element } from "./element";

/** done: the clipboard has it. */
export async function copy(text: string, done: () => void) {
  try {
    await navigator.clipboard.writeText(text);
    done();
  } catch {
    const area = element("textarea", "by-hand", text);
    area.readOnly = true;
    area.setAttribute("aria-label", say("copy.byHand"));
    createDialog(say("copy.byHand"), area).open();
    area.select();
  }
}
