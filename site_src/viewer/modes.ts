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
  const isEmbedded = new URLSearchParams(location.search).has("embed");
  const sign = onDemand.one("help", ({ createKeySign }) => createKeySign(body));
  const saving = onDemand.one("saving", ({ createSaving }) => createSaving(session, views, notify));
  const sheet = onDemand.one("help", ({ createHelp }) => createHelp());
  const help = () => sheet.use((turn) => turn());

  function fullScreen() {
    const done = document.fullscreenElement ? document.exitFullscreen() : document.documentElement.requestFullscreen?.();
    (done ?? Promise.reject()).catch(() => notify(say("tools.noScreen")));
  }

  const tools = createTools({ link, save: (done) => saving.use(({ save }) => save(done)), slide: (done) => saving.use(({ slide }) => slide(done)), fullScreen, projector: acts.projector, help });
  body.classList.toggle("embed", isEmbedded);
  if (isEmbedded) body.append(tools.whole);
  else body.insertBefore(tools.element, document.querySelector("nav.scenes"));

  return {
    fullScreen,
    help,
    /** A key has done something. */
    pressed(key: string) {
      if (session.state?.projector) sign.use(({ show }) => show(key));
    },
    show() {
      const isProjector = session.state?.projector ?? false;
      body.classList.toggle("projector", isProjector);
      if (lightColours(isProjector)) recolour();
      tools.show(isProjector);
    },
  };
}

export type Modes = ReturnType<typeof createModes>;
