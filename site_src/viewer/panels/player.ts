/** The step-by-step player's row: one event back, play, one on, a scrub bar coloured by ray kind, speed. */
import type { Actions } from "../actions";
import type { RayEvent } from "../state/event-types";
import { timeOf } from "../state/play";
import type { Timeline } from "../state/timeline";
import type { ViewState } from "../state/view-state";
import { fraction, say } from "../words";
import { button, disable, element, named, setWord } from "../element";
import { icon } from "./icons";

const QUIET = "var(--ray-none)"; // events without a ray: sums
const GAPS_UP_TO = 60; // events: with more, gaps would eat the colours

const colourOf = (event: RayEvent) => (event.line ? `var(--ray-${event.line})` : QUIET);

function paint({ events, starts }: Timeline): string {
  const end = starts.at(-1)!;
  const gap = events.length > GAPS_UP_TO ? "0px" : "2px";
  const stops = events.map((event, k) => {
    const [from, to] = [starts[k], starts[k + 1]].map((s) => `${((100 * s) / end).toFixed(3)}%`);
    return `${colourOf(event)} ${from} calc(${to} - ${gap}), transparent calc(${to} - ${gap}) ${to}`;
  });
  return `linear-gradient(90deg, ${stops.join(", ")})`;
}

export function createPlayer(acts: Pick<Actions, "play" | "event" | "time" | "endEvents" | "speed">) {
  const back = button("", say("player.back"), () => acts.event(-1), { className: "sign" });
  const play = button(say("player.play.word"), say("player.play.help"), acts.play, { key: "P", className: "play" });
  const on = button("", say("player.on"), () => acts.event(1), { className: "sign" });
  const end = button("\u00d7", say("player.end"), acts.endEvents, { className: "sign quiet" });
  const speed = button("", say("player.speed"), acts.speed, { className: "speed" });
  back.replaceChildren(icon("back"));
  on.replaceChildren(icon("on"));
  const sign = element("span", "play-sign");
  play.prepend(sign);
  const colours = element("span", "segments");
  const ahead = element("span", "ahead");
  const range = named(element("input", "scrub"), say("player.scrub"));
  Object.assign(range, { type: "range", min: "0", step: "any" });
  range.addEventListener("input", () => acts.time(Number(range.value)));
  range.addEventListener("keydown", (event) => {
    const by = ({ ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 } as const)[event.key as "ArrowUp"];
    if (!by && event.key !== "Home" && event.key !== "End") return;
    event.preventDefault();
    if (by) acts.event(by);
    else if (event.key === "Home") acts.endEvents();
    else acts.time(Number(range.max));
  });
  const bar = element("div", "timeline", colours, ahead, range);
  const count = element("span", "event-count numbers");
  const root = named(element("section", "player", back, play, on, bar, count, speed, end), say("player.region"));
  let shown: { timeline?: Timeline | null; playing?: boolean } = {};

  return {
    element: root,
    /** sentence: of the current event, once words have come. */
    show(state: ViewState, timeline: Timeline | null, sentence: string) {
      const { event, playing } = state;
      if (shown.timeline !== timeline) {
        colours.style.backgroundImage = timeline ? paint(timeline) : "none";
        range.max = String(timeline ? timeline.starts.at(-1)! : 1);
      }
      if (shown.playing !== playing) {
        const what = playing ? "pause" : "play";
        setWord(play, say(`player.${what}.word`), say(`player.${what}.help`));
        sign.replaceChildren(icon(what));
      }
      shown = { timeline, playing };
      const of = timeline?.events.length ?? 0;
      const now = timeline ? timeOf(state, timeline) : 0;
      range.value = String(now);
      range.disabled = !timeline;
      ahead.style.left = `${event === null ? 100 : (100 * now) / Number(range.max)}%`;
      const text = event === null || !timeline ? say("player.none") : say("player.at", { event: event + 1, of, says: sentence });
      if (range.getAttribute("aria-valuetext") !== text) range.setAttribute("aria-valuetext", text);
      count.textContent = !timeline ? "" : event === null ? say("player.count", { of }) : say("player.countAt", { event: event + 1, of });
      for (const each of [back, on, end, count, speed]) each.hidden = event === null; // before the first event there is only Play
      disable(back, event === null);
      disable(on, !timeline || event === of - 1);
      setWord(speed, say("controls.speed", { speed: fraction(state.speed) }));
    },
  };
}
