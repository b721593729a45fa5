/** How the page is used: within another one, full screen, on a projector; and what is taken from it, a link or a picture. */
import type { Actions } from "./actions";
import type { OnDemand } from "./on-demand";
import { button, pressed } from "./element";
import type { Views } from "./saving";
import type { Session } from "./session";
import { say } from "./words";

export interface Taken {
  address: () => string;
  views: Views;
  recolour: () => void;
  notify: (sentence: string) => void;
  onDemand: OnDemand;
}

export function createModes(session: Session, acts: Actions, { address, views, recolour, notify, onDemand }: Taken) {
  const { body } = document;
  const isEmbedded = [location.search, location.hash.slice(1)].some((asked) => new URLSearchParams(asked).has("embed"));
  const sign = onDemand.one("at-hand", ({ createKeySign }) => createKeySign(body));
  const saving = onDemand.one("saving", ({ createSaving }) => createSaving(session, views, notify));
  const sheet = onDemand.one("at-hand", ({ createHelp }) => createHelp(notify));
  const help = () => sheet.use((turn) => turn());
  const lecture = onDemand.one("lecture", ({ createLecture }) => createLecture(body, () => (recolour(), session.changed())));

  const menu = document.querySelector("#menu");
  const tools = onDemand.one("at-hand", ({ createTools, createWayOut }) => {
    const made = createTools({ address, save: (what, done, kind) => saving.use((saves) => saves[what](done, kind)), notify, help });
    menu?.prepend(made.element);
    if (isEmbedded) document.querySelector(".below-row")?.append(createWayOut(address));
    return made;
  });
  const bring = () => tools.use(() => {});
  menu?.addEventListener("beforetoggle", bring);
  if (isEmbedded) bring();
  const lecturing = button(say("tools.projector.word"), say("tools.projector.help"), acts.projector, { key: "J", className: "lecture" });
  body.classList.toggle("embed", isEmbedded);
  document.querySelector(".menu-open")?.before(lecturing);

  return {
    fullScreen: () => tools.use(({ fullScreen }) => fullScreen()),
    help,
    black() {
      if (session.state?.projector) lecture.use(({ black }) => black());
    },
    /** A key has done something. */
    pressed(key: string) {
      if (session.state?.projector) sign.use(({ show }) => show(key));
    },
    show() {
      const isProjector = session.state?.projector ?? false;
      body.classList.toggle("projector", isProjector);
      if (isProjector || lecture.now()) lecture.use(({ show }) => show(isProjector));
      pressed(lecturing, isProjector);
    },
  };
}

export type Modes = ReturnType<typeof createModes>;
