/** Time passes: tiles fill, events are told. */
import type { Session } from "./session";
import { advancePlay } from "./state/play";
import { advance } from "./state/view-state";

export function passTime(session: Session, seconds: number) {
  const { state } = session;
  if (!state) return;
  const told = session.timeline();
  const filled = advance(state, seconds);
  const next = told ? advancePlay(filled, told, seconds) : filled;
  session.state = next;
  if (next.tiles !== state.tiles || next.event !== state.event || next.playing !== state.playing) session.changed();
}
