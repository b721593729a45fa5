/** Time passes: tiles fill, the player goes on. */
import type { Session } from "./session";
import { advancePlay } from "./state/play";
import { advance } from "./state/view-state";

export function passTime(session: Session, seconds: number) {
  const { state } = session;
  if (!state) return;
  const timeline = session.timeline();
  const filled = advance(state, seconds);
  const next = timeline ? advancePlay(filled, timeline, seconds) : filled;
  session.state = next;
  if (next.tiles !== state.tiles || next.event !== state.event || next.playing !== state.playing) session.changed();
}
