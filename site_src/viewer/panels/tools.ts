/** The page's own buttons: link, picture, full screen, projector, help; and embedded, the way to the whole page. */
import { say } from "../words";
import { copy } from "./copy";
import { button, element, pressed, setWord } from "./element";

export interface ToolActs {
  /** Writes the view into the address now, and gives it. */
  link: () => string;
  save: () => void;
  slide: () => void;
  fullScreen: () => void;
  projector: () => void;
  help: () => void;
}

const COPIED_FOR = 1500; // ms in which the button says so

export function createTools(acts: ToolActs) {
  const link = button(say("tools.link.word"), say("tools.link.help"), () =>
    void copy(acts.link(), () => {
      setWord(link, say("copy.done"));
      setTimeout(() => setWord(link, say("tools.link.word")), COPIED_FOR);
    }),
  );
  const projector = button(say("tools.projector.word"), say("tools.projector.help"), acts.projector);
  const screen = button(say("tools.fullScreen.word"), say("tools.fullScreen.help"), acts.fullScreen);
  screen.hidden = !document.fullscreenEnabled;
  const root = element(
    "div",
    "tools",
    link,
    button(say("tools.save.word"), say("tools.save.help"), acts.save),
    button(say("tools.slide.word"), say("tools.slide.help"), acts.slide),
    projector,
    screen,
    button("?", say("tools.keys"), acts.help, { className: "sign" }),
  );
  root.setAttribute("role", "group");
  root.setAttribute("aria-label", say("tools.region"));

  const whole = element("a", "whole", say("tools.whole"));
  whole.target = "_blank";
  whole.rel = "noopener";
  const direct = () => void (whole.href = acts.link());
  for (const on of ["pointerenter", "focus", "pointerdown"]) whole.addEventListener(on, direct);

  return {
    element: root,
    /** For a page within another one. */
    whole: element("p", "embed-bar", whole),
    show(isProjector: boolean) {
      pressed(projector, isProjector);
      if (!whole.href) direct();
    },
  };
}
