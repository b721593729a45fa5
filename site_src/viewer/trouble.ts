/** What went wrong or takes long, as the sentence a person reads and a remedy. */
import { LoadError } from "./load";
import type { More, Notice } from "./panels/notice";
import { say } from "./words";

const SLOW = 8000; // ms after which it is said that something is still on its way

/** Says so if it takes long. */
export async function awaited<T>(what: Promise<T>, about: "scene" | "trace", notice: Notice): Promise<T> {
  const wait = window.setTimeout(() => notice.say(say("trouble.slow"), { about }), SLOW);
  try {
    return await what;
  } finally {
    clearTimeout(wait);
  }
}

const reload = () => ({ word: say("trouble.reload"), go: () => location.reload() });

/** What Notice.say says. */
type Trouble = readonly [sentence: string, more: More];

/** lost: the sentence when it is missing, and when it is damaged. */
function troubleOf(error: unknown, about: "scene" | "trace", lost: Readonly<Record<"missing" | "damaged", string>>, again: () => void): Trouble {
  const why = error instanceof LoadError ? error.why : "damaged";
  if (why === "old browser") return [say("trouble.noUnpacking"), { about }];
  if (why === "other version") return [say("trouble.otherVersion"), { about, remedies: [reload()] }];
  return [lost[why], { about, again }];
}

export const troubleOfTrace = (error: unknown, n: number, again: () => void): Trouble =>
  troubleOf(error, "trace", { missing: say("trouble.traceMissing", { n }), damaged: say("trouble.traceDamaged", { n }) }, again);

/** Of the scene that the page is for: nothing else is shown. */
export const troubleOfScene = (error: unknown, again: () => void): Trouble =>
  troubleOf(error, "scene", { missing: say("trouble.sceneMissing"), damaged: say("trouble.sceneDamaged") }, again);

/** Of the scene that was to come: the one that is shown goes on. page: its own, which says what it can without its data. */
export const troubleOfNextScene = ({ title, href }: HTMLAnchorElement, again: () => void): Trouble => [
  say("trouble.nextScene", { title }),
  { about: "scene", again, remedies: [{ word: say("trouble.itsPage"), go: () => location.assign(href) }] },
];

/** Of a part that comes when asked for: the rest goes on. Of an older build it may be gone for good. */
export const troubleOfPart = (name: string, again: () => void): Trouble => [say("trouble.partMissing"), { about: `part ${name}`, again, remedies: [reload()] }];

/** What nobody foresaw: it is said, and the page goes on as far as it can. own: the address of the viewer's script;
 *  errors of other scripts (a damaged trace is one) are reported where they were asked for. */
export function listenToErrors(own: string, notice: Notice) {
  const report = () => notice.say(say("trouble.unexpected"), { about: "error", remedies: [reload()] });
  window.addEventListener("error", (event) => {
    if (event instanceof ErrorEvent && event.filename === own) report();
  });
  window.addEventListener("unhandledrejection", report);
}
