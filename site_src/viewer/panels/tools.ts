/** The page's own buttons: link, picture, full screen, projector, help; and embedded, the way to the whole page. */
import type { Actions } from "../actions";
import { say } from "../words";
import { copy } from "./clipboard";
import { sayDone } from "./done";
import { button, element, named, pressed } from "../element";

export type ToolActs = Pick<Actions, "projector"> & {
  /** Writes the view into the address now, and gives it. */
  link: () => string;
  /** done: with the file's name. */
  save: (done: (file: string) => void) => void;
  slide: (done: (file: string) => void) => void;
  fullScreen: () => void;
  help: () => void;
};

export function createTools(acts: ToolActs) {
  const link = button(say("tools.link.word"), say("tools.link.help"), () => void copy(acts.link(), () => sayDone(link, say("tools.link.done"))));
  const saving = (what: "save" | "slide") => {
    const made = button(say(`tools.${what}.word`), say(`tools.${what}.help`), () => acts[what]((file) => sayDone(made, say(`tools.${what}.done`, { file }))));
    return made;
  };
  const lecture = button(say("tools.projector.word"), say("tools.projector.help"), acts.projector, { key: "J", className: "lecture" });
  const screen = button(say("tools.fullScreen.word"), say("tools.fullScreen.help"), acts.fullScreen);
  screen.hidden = !document.fullscreenEnabled;
  const root = element(
    "div",
    "tools",
    link,
    saving("save"),
    saving("slide"),
    screen,
    button(say("tools.keys.word"), say("tools.keys.help"), acts.help, { key: "?" }),
  );
  const whole = element("a", "whole", say("tools.whole"));
  whole.target = "_blank";
  whole.rel = "noopener";
  const direct = () => void (whole.href = acts.link());
  for (const on of ["pointerenter", "focus", "pointerdown"]) whole.addEventListener(on, direct);

  return {
    element: named(root, say("tools.region"), "group"),
    lecture,
    /** For a page within another one. */
    whole: element("p", "embed-bar", whole),
    show(isProjector: boolean) {
      pressed(lecture, isProjector);
      if (!whole.href) direct();
    },
  };
}
