/** What went wrong, as the sentence a person reads and the way on. */
import { LoadError, type Loss } from "./load";
import type { More, Notice } from "./panels/notice";
import { say } from "./words";

const whyOf = (error: unknown): Loss => (error instanceof LoadError ? error.why : "damaged");

const reload = () => ({ word: say("trouble.reload"), go: () => location.reload() });

export interface Trouble {
  sentence: string;
  more: More;
}

export function troubleOfTrace(error: unknown, n: number, again: () => void): Trouble {
  const about = "trace";
  switch (whyOf(error)) {
    case "old browser":
      return { sentence: say("trouble.noUnpacking"), more: { about } };
    case "other version":
      return { sentence: say("trouble.otherVersion"), more: { about, ways: [reload()] } };
    case "missing":
      return { sentence: say("trouble.traceMissing", { n }), more: { about, again } };
    case "damaged":
      return { sentence: say("trouble.traceDamaged", { n }), more: { about, again } };
  }
}

/** Of the scene that the page is for: nothing else is shown. */
export function troubleOfScene(error: unknown, again: () => void): Trouble {
  const about = "scene";
  switch (whyOf(error)) {
    case "old browser":
      return { sentence: say("trouble.noUnpacking"), more: { about } };
    case "other version":
      return { sentence: say("trouble.otherVersion"), more: { about, ways: [reload()] } };
    case "missing":
      return { sentence: say("trouble.sceneMissing"), more: { about, again } };
    case "damaged":
      return { sentence: say("trouble.sceneDamaged"), more: { about, again } };
  }
}

/** Of the scene that was to come: the one that is shown goes on. page: its own, which says what it can without its data. */
export const troubleOfNextScene = (title: string, page: string, again: () => void): Trouble => ({
  sentence: say("trouble.nextScene", { title }),
  more: { about: "scene", again, ways: [{ word: say("trouble.itsPage"), go: () => location.assign(page) }] },
});

/** What nobody foresaw: it is said, and the page goes on as far as it can. own: the address of the viewer's script;
 *  other scripts (a damaged trace is one) are told where they were asked for. */
export function listenToErrors(own: string, notice: Notice) {
  const tell = () => notice.say(say("trouble.unexpected"), { about: "error", ways: [reload()] });
  window.addEventListener("error", (event) => {
    if (event instanceof ErrorEvent && event.filename === own) tell();
  });
  window.addEventListener("unhandledrejection", tell);
}
