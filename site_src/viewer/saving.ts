/** The view as a file: a picture of what is drawn, or an SVG for slides whose rays and words can be edited. */
import type { PictureKind } from "./panels/picture-kind";
import type { Session } from "./session";
import { slideSvg } from "./stage/slide";
import { snapshot } from "./stage/snapshot";
import type { Stage } from "./stage/stage";
import { pixelIndex, tileColour } from "./state/view-state";
import { say } from "./words";

/** done: with the file's name. */
type Done = (file: string) => void;

/** What is drawn on a canvas, and words over it. */
export type SavedView = Pick<Stage, "element" | "redrawn">;

export interface Views {
  stage: Stage;
  /** What is seen instead of the stage. */
  slice: () => SavedView | null;
}

/** Drawn so many times as large as on the page, or as large as the graphics card can, `use` is given it; then it is as before. */
function enlarged(view: SavedView, scale: number, use: (canvas: HTMLCanvasElement) => void) {
  const canvas = view.redrawn(scale);
  const card = canvas.getContext("webgl2");
  if (card && card.drawingBufferWidth < canvas.width && scale > 1) return enlarged(view, scale / 2, use);
  use(canvas);
  view.redrawn();
}

export function createSaving(session: Session, { stage, slice }: Views, notify: (sentence: string) => void) {
  /** What a saved view shows, in words; null before there is anything. */
  function caption(): string | null {
    const { state, scene } = session;
    if (!state || !scene) return null;
    const trace = session.trace();
    const [column, row] = state.pixel;
    const colour = trace ? tileColour(trace, pixelIndex(state)).join(", ") : "";
    return say("tools.saved", { scene: scene.title, column, row, n: state.n, colour });
  }

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

  return {
    save: (done: Done, { scale, isClear }: PictureKind) =>
      trying(() => {
        const [says, view] = [caption(), slice() ?? stage];
        if (says === null) return;
        enlarged(view, scale, (canvas) => snapshot(canvas, view.element, isClear ? null : says).toBlob((blob) => trying(() => keep(blob, "png", done))));
      }),
    slide(done: Done) {
      const [says, drawn] = [caption(), slice() ? null : stage.drawn()];
      if (says === null || !drawn) return notify(say("tools.noSlide"));
      const { view, projection } = drawn;
      stage.show({ ...view, chosen: [], lit: null }); // those are drawn as lines
      const picture = stage.redrawn().toDataURL();
      stage.show(view);
      const figure = slideSvg(picture, view.chosen, stage.element.querySelector(".labels")!, says, projection, view.scene.bounds.radius / 300);
      trying(() => keep(new Blob([figure], { type: "image/svg+xml" }), "svg", done));
    },
  };
}
