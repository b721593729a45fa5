/** How the page is used: within another one, full screen, on a projector; and what is taken from it, a link or a picture. */
import type { Actions } from "./actions";
import { lightColours } from "./palette";
import { createHelp, createKeySign } from "./panels/help";
import { createTools } from "./panels/tools";
import type { Session } from "./session";
import { say } from "./words";

export interface Taken {
  link: () => string;
  snapshot: () => HTMLCanvasElement | null;
  slide: () => string | null;
  recolour: () => void;
  notify: (sentence: string) => void;
}

export function createModes(session: Session, acts: Actions, { link, snapshot, slide, recolour, notify }: Taken) {
  const { body } = document;
  const isEmbedded = new URLSearchParams(location.search).has("embed");
  const sign = createKeySign();

  type Done = (file: string) => void;
  function keep(blob: Blob | null, ending: string, done: Done) {
    const { state } = session;
    if (!blob || !state) return notify(say("tools.notSaved"));
    const file = document.createElement("a");
    file.href = URL.createObjectURL(blob);
    file.download = `${state.scene}-${state.pixel.join("-")}.${ending}`;
    file.click();
    setTimeout(() => URL.revokeObjectURL(file.href), 1000);
    done(file.download);
  }
  /** Browsers refuse for reasons of their own: no memory, a page in a frame without leave to. */
  function trying(act: () => void) {
    try {
      act();
    } catch {
      notify(say("tools.notSaved"));
    }
  }
  const save = (done: Done) => trying(() => snapshot()?.toBlob((blob) => trying(() => keep(blob, "png", done))));

  function saveSlide(done: Done) {
    const drawn = slide();
    if (drawn === null) notify(say("tools.noSlide"));
    else trying(() => keep(new Blob([drawn], { type: "image/svg+xml" }), "svg", done));
  }

  function fullScreen() {
    const done = document.fullscreenElement ? document.exitFullscreen() : document.documentElement.requestFullscreen?.();
    (done ?? Promise.reject()).catch(() => notify(say("tools.noScreen")));
  }

  const help = createHelp();
  const tools = createTools({ link, save, slide: saveSlide, fullScreen, projector: acts.projector, help });
  body.classList.toggle("embed", isEmbedded);
  if (isEmbedded) body.append(tools.whole);
  else body.insertBefore(tools.element, document.querySelector("nav.scenes"));
  body.append(sign.element);

  return {
    fullScreen,
    help,
    pressed(key: string) {
      if (session.state?.projector) sign.show(key);
    },
    show() {
      const isProjector = session.state?.projector ?? false;
      body.classList.toggle("projector", isProjector);
      if (lightColours(isProjector)) recolour();
      tools.show(isProjector);
    },
  };
}
