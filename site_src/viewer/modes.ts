/** How the page is used: within another one, full screen, on a projector; and what is taken from it, a link or a picture. */
import type { Actions } from "./actions";
import { lightColours } from "./palette";
import type { OnDemand } from "./on-demand";
import { createTools } from "./panels/tools";
import type { Views } from "./saving";
import type { Session } from "./session";
import { say } from "./words";

export interface Taken {
  link: () => string;
  views: Views;
  recolour: () => void;
  notify: (sentence: string) => void;
  onDemand: OnDemand;
}

export function createModes(session: Session, acts: Actions, { link, views, recolour, notify, onDemand }: Taken) {
  const { body } = document;
  const isEmbedded = [location.search, location.hash.slice(1)].some((asked) => new URLSearchParams(asked).has("embed"));
  const sign = onDemand.one("help", ({ createKeySign }) => createKeySign(body));
  const saving = onDemand.one("saving", ({ createSaving }) => createSaving(session, views, notify));
  const sheet = onDemand.one("help", ({ createHelp }) => createHelp());
  const help = () => sheet.use((turn) => turn());
  const lecture = onDemand.one("lecture", ({ createLecture }) => createLecture(body));

  function fullScreen() {
    const done = document.fullscreenElement ? document.exitFullscreen() : document.documentElement.requestFullscreen?.();
    (done ?? Promise.reject()).catch(() => notify(say("tools.noScreen")));
  }

  const tools = createTools({ link, save: (done) => saving.use(({ save }) => save(done)), slide: (done) => saving.use(({ slide }) => slide(done)), fullScreen, projector: acts.projector, help });
  body.classList.toggle("embed", isEmbedded);
  if (isEmbedded) document.querySelector(".below-row")?.append(tools.whole);
  document.querySelector("#menu")?.prepend(tools.element);
  document.querySelector(".menu-open")?.before(tools.lecture);

  return {
    fullScreen,
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
      if (lightColours(isProjector)) recolour();
      if (isProjector || lecture.now()) lecture.use(({ show }) => show(isProjector));
      tools.show(isProjector);
    },
  };
}

export type Modes = ReturnType<typeof createModes>;
