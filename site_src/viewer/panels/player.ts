/** The step-by-step player's row: one event back, play, one on, a scrub bar coloured by ray kind, speed. */
import type { RayEvent } from "../state/event-types";
import { timeOf } from "../state/play";
import type { Timeline } from "../state/timeline";
import type { ViewState } from "../state/view-state";
import { fraction, say } from "../words";
import { button, element, setWord } from "./element";
import { icon } from "./icons";

export interface PlayerActs {
  play: () => void;
  event: (by: 1 | -1) => void;
  time: (seconds: number) => void;
  endEvents: () => void;
  speed: () => void;
}

const QUIET = "var(--ray-none)"; // events without a ray: sums
const GAPS_UP_TO = 60; // events: with more, gaps would eat the colours

const colourOf = (event: RayEvent) => (event.line ? `var(--ray-${event.line})` : QUIET);

function paint({ events, starts }: Timeline): string {
  const end = starts[starts.length - 1];
  const gap = events.length > GAPS_UP_TO ? "0px" : "2px";
  const stops = events.map((event, k) => {
    const [from, to] = [starts[k], starts[k + 1]].map((s) => `${((100 * s) / end).toFixed(3)}%`);
    return `${colourOf(event)} ${from} calc(${to} - ${gap}), transparent calc(${to} - ${gap}) ${to}`;
  });
  return `linear-gradient(90deg, ${stops.join(", ")})`;
}

export function createPlayer(acts: PlayerActs) {
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
  const range = element("input", "scrub");
  range.type = "range";
  range.min = "0";
  range.step = "any";
  range.setAttribute("aria-label", say("player.scrub"));
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
  const root = element("section", "player", back, play, on, bar, count, speed, end);
  root.setAttribute("aria-label", say("player.region"));
  let shown: { timeline?: Timeline | null; playing?: boolean } = {};

  return {
    element: root,
    /** said: the event it is at, in a sentence, once words have come. */
    show(state: ViewState, timeline: Timeline | null, said: string) {
      const { event, playing } = state;
      if (shown.timeline !== timeline) {
        colours.style.backgroundImage = timeline ? paint(timeline) : "none";
        range.max = String(timeline ? timeline.starts[timeline.starts.length - 1] : 1);
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
      const text = event === null || !timeline ? say("player.none") : say("player.at", { event: event + 1, of, says: said });
      if (range.getAttribute("aria-valuetext") !== text) range.setAttribute("aria-valuetext", text);
      count.textContent = !timeline ? "" : event === null ? say("player.count", { of }) : say("player.countAt", { event: event + 1, of });
      end.classList.toggle("away", event === null);
      back.setAttribute("aria-disabled", String(event === null));
      on.setAttribute("aria-disabled", String(!timeline || event === of - 1));
      setWord(speed, say("controls.speed", { speed: fraction(state.speed) }));
    },
  };
}
