/** The step-by-step player: which event is the current one, how far it has gone, and whether time runs. */
import type { Timeline } from "./timeline";
import type { ViewState } from "./types";

/** What holds while there is no current event: everything of the selected pixel shows. */
export const NO_EVENT = { event: null, share: 1, playing: false } as const;

const quiet = (state: ViewState): ViewState => (state.tiles === "filling" ? { ...state, tiles: "filled", drawn: 0 } : state);

/** An event, gone through to its end; null for none. */
export function goToEvent(state: ViewState, timeline: Timeline, event: number | null): ViewState {
  if (event === null || event < 0) return { ...state, ...NO_EVENT };
  return { ...quiet(state), event: Math.min(event, timeline.events.length - 1), share: 1, playing: false };
}

export function stepEvent(state: ViewState, timeline: Timeline, by: 1 | -1): ViewState {
  if (state.event === null) return by < 0 ? state : goToEvent(state, timeline, 0);
  return goToEvent(state, timeline, state.event + by);
}

/** Play: from the beginning if there is no event yet or it was the last; pause where it is. */
export function pressPlay(state: ViewState, timeline: Timeline): ViewState {
  if (state.playing) return { ...state, playing: false };
  if (state.still) return goToEvent(state, timeline, timeline.events.length - 1);
  const atEnd = state.event === timeline.events.length - 1 && state.share === 1;
  const from = state.event === null || atEnd ? { event: 0, share: 0 } : {};
  return { ...quiet(state), ...from, playing: true };
}

/** Seconds from the first event's beginning; 0 while there is none. */
export const timeOf = ({ event, share }: ViewState, { starts }: Timeline): number =>
  event === null ? 0 : starts[event] + share * (starts[event + 1] - starts[event]);

/** The moment that many seconds after the first event's beginning. */
export function goToTime(state: ViewState, { starts }: Timeline, seconds: number): ViewState {
  const last = starts.length - 2;
  let event = 0;
  while (event < last && seconds >= starts[event + 1]) event++;
  const share = Math.min(1, Math.max(0, (seconds - starts[event]) / (starts[event + 1] - starts[event])));
  return { ...quiet(state), event, share };
}

/** seconds: time that has passed. */
export function advancePlay(state: ViewState, timeline: Timeline, seconds: number): ViewState {
  if (!state.playing) return state;
  const end = timeline.starts.at(-1)!;
  const now = timeOf(state, timeline) + seconds * state.speed;
  return now >= end ? goToEvent(state, timeline, timeline.events.length - 1) : goToTime(state, timeline, now);
}
