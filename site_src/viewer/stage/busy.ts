/** A machine that draws slowly while time runs: the stage is drawn with fewer pixels and says so, and is drawn in full again when
 *  frames are quick or time has stopped. */
import { element } from "../element";
import { say } from "../words";
import type { Stage } from "./stage";

const COARSE = 0.5; // device pixels in each of the stage's, each way
const SLOW = 125; // ms a frame: eight a second
const QUICK = 50;
const TIMES = 3; // slow frames in a row until the stage is drawn coarser
const AGAIN = 30; // quick ones until it is drawn in full; twice as many each time that this was too much

export function createBusy(stage: Pick<Stage, "element" | "redrawn">) {
  const note = element("p", "busy-note", say("stage.busy"));
  note.setAttribute("role", "status");
  let [slow, quick, patience, isBusy] = [0, 0, AGAIN, false];
  function turn(busy: boolean) {
    [slow, quick, isBusy] = [0, 0, busy];
    if (busy) stage.element.after(note);
    else note.remove();
    stage.redrawn(busy ? COARSE : undefined);
  }
  return {
    /** ms: since the last frame; 0: time has stopped. */
    frame(ms: number) {
      slow = ms > SLOW ? slow + 1 : 0;
      quick = ms < QUICK ? quick + 1 : 0;
      if (!isBusy && slow >= TIMES) turn(true);
      else if (isBusy && (!ms || quick >= patience)) {
        if (ms) patience *= 2;
        turn(false);
      }
    },
  };
}
