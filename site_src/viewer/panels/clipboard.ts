/** A text into the clipboard or, where that is refused, to be copied by hand. */
import { say } from "../words";
import { createDialog } from "./dialog";
import { element, named } from "../element";

/** done: the clipboard has it. */
export async function copy(text: string, done: () => void) {
  try {
    await navigator.clipboard.writeText(text);
    done();
  } catch {
    const area = named(element("textarea", "by-hand", text), say("copy.byHand"));
    area.readOnly = true;
    createDialog(say("copy.byHand"), area).open();
    area.select();
  }
}
