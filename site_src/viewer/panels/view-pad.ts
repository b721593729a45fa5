/** Nine buttons in the stage's corner that do what dragging and the wheel do. */
import type { Actions } from "../actions";
import type { Moves } from "../state/observer";
import { say } from "../words";
import { button, element, named, pressed, setWord } from "../element";

const DEGREES = 10;
const SHARE = 0.08;
const CLOSER = 0.85;

const ARROWS = [["\u2191", "up", 0, 1], ["\u2190", "left", -1, 0], ["\u2192", "right", 1, 0], ["\u2193", "down", 0, -1]] as const;

export function createViewPad(acts: Moves & Pick<Actions, "camera"> & { start: () => void }) {
  let shifting = false;
  const arrows = ARROWS.map(([sign, side, right, up]) => {
    const press = () => (shifting ? acts.shift(-right * SHARE, -up * SHARE) : acts.turn(right * DEGREES, up * DEGREES));
    return { side, made: button(sign, "", press, { className: "sign" }) };
  });
  const [up, left, right, down] = arrows.map((each) => each.made);
  const mode = button(say("pad.turn.word"), say("pad.turn.help"), () => choose(!shifting));
  const root = element(
    "div",
    "view-pad",
    button("+", say("pad.nearer"), () => acts.come(CLOSER), { className: "sign" }),
    up,
    button("\u2212", say("pad.farther"), () => acts.come(1 / CLOSER), { className: "sign" }),
    left,
    mode,
    right,
    button(say("pad.start.word"), say("pad.start.help"), acts.start),
    down,
    button(say("pad.camera.word"), say("pad.camera.help"), acts.camera, { key: "R" }),
  );

  function choose(shifts: boolean) {
    shifting = shifts;
    const does = shifting ? "shift" : "turn";
    setWord(mode, say(`pad.${does}.word`), say(`pad.${does}.help`));
    pressed(mode, shifting);
    for (const { made, side } of arrows) named(made, (made.title = say(`pad.${does}.${side}`)));
  }
  choose(false);
  return { element: named(root, say("pad.name"), "group") };
}
