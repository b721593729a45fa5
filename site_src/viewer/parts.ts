/** The page's parts, where they stand, and what each of them shows of the present. */
import type { Actions } from "./actions";
import { contrastWith } from "./palette";
import { createCode } from "./panels/code";
import { createCard } from "./panels/card";
import { createControls } from "./panels/controls";
import { element } from "./panels/element";
import { createLegend } from "./panels/legend";
import { createLesson } from "./panels/lesson";
import { createPage, type PageParts } from "./panels/page";
import { createPicture } from "./panels/picture";
import { createPlayer } from "./panels/player";
import { createSpoken } from "./panels/spoken";
import { createSavings } from "./panels/savings";
import { createTileColours } from "./panels/tile-colours";
import { createViewPad } from "./panels/view-pad";
import { createWhatIf } from "./panels/what-if";
import type { Session } from "./session";
import { createSlice } from "./stage/slice";
import { createStage } from "./stage/stage";
import { sectionOf } from "./state/section";
import { snapshot } from "./stage/snapshot";
import { isAsking, pixelIndex, tileColour } from "./state/view-state";
import { createViewSwitch } from "./panels/view-switch";
import { say } from "./words";

export interface Surroundings {
  home: HTMLElement; // what the parts go into
  page: PageParts;
  withGl: boolean;
  pictureFailed: (again: () => void) => void;
  /** Why the stage is drawn in a simpler way from now on; "": it no longer is. */
  simpler: (why: string) => void;
}

export function createParts(session: Session, acts: Actions, { home, page: pageParts, withGl, pictureFailed, simpler }: Surroundings) {
  const flat = (why: "refused" | "lost" | null) => {
    if (why) document.body.dataset.renderer = "flat";
    else delete document.body.dataset.renderer;
    simpler(why ? say(`trouble.${why}`) : "");
  };
  const stage = createStage({ ...acts, move: acts.observer, flat }, pageParts.root, withGl, () => [...document.querySelectorAll(".view-pad, .view-switch, .view-note, .stage-tools > *")]);
  const pad = createViewPad({ turn: stage.turn, shift: stage.shift, come: stage.come, start: () => acts.observer("start"), camera: acts.camera });
  const slice = createSlice({ pick: acts.pickAlong });
  const viewSwitch = createViewSwitch({ look: acts.look, slice: acts.slice });
  const picture = createPicture(pageParts.root, { ...acts, failed: pictureFailed });
  const code = createCode();
  const card = createCard(acts, code.element);
  const controls = createControls(acts);
  const legend = createLegend();
  const lesson = createLesson(acts);
  const player = createPlayer(acts);
  const whatIf = createWhatIf(acts);
  const tileColours = createTileColours(acts);
  const page = createPage(pageParts);
  const savings = createSavings();
  const spoken = createSpoken();

  home.append(
    element(
      "div",
      "work",
      element(
        "div",
        "stage-row",
        element(
          "section",
          "stage",
          stage.element,
          slice.element,
          viewSwitch.element,
          viewSwitch.note,
          element("div", "stage-tools", whatIf.undo, whatIf.toggle, tileColours.element),
          legend.element,
          pad.element,
        ),
      ),
      tileColours.legend,
      whatIf.element,
      lesson.element,
      player.element,
      controls.element,
    ),
    element("div", "side", picture.element, card.head, card.element, savings.element),
    spoken.element,
  );

  /** What a saved view shows, in words; null before there is anything. */
  function caption(): string | null {
    const { state, scene } = session;
    const trace = session.trace();
    if (!state || !scene) return null;
    const [column, row] = state.pixel;
    const colour = trace ? tileColour(trace, pixelIndex(state)).join(", ") : "";
    return say("tools.saved", { scene: scene.title, column, row, n: state.n, colour });
  }

  let renders = 0;
  let drawn = { scene: "", n: 0, tiles: 0, lines: 0 }; // by the last render
  return {
    /** Shows the present. dark: the selected tile's ring blinks off. */
    render(dark: boolean) {
      const { state, lit, missing } = session;
      const now = session.switched();
      const view = session.shown();
      if (!state || !session.scene || !now || !view) return;
      renders++;
      const { scene, trace } = now; // as the switches make them
      const traced = { scene: session.scene, trace: session.traced() };
      const event = session.told();
      const recombined = session.recombined();
      const ring = dark ? null : contrastWith(view.ringOn);
      const section = trace && session.sections?.scene === scene.id ? sectionOf(session.sections, state, scene, trace, view.plane) : null;
      if (section) {
        slice.show({ section, scene, trace: trace!, large: state.projector, tile: state.pixel[section.direction === "row" ? 0 : 1], tiles: view.tiles, costs: view.costs, chosen: view.chosen });
      } else {
        slice.show(null);
        stage.show({ ...view, scene: traced.scene, switched: scene, recombined, trace, state, lit: lit ?? event, ring });
      }
      stage.element.hidden = pad.element.hidden = section !== null;
      viewSwitch.show(state);
      legend.show(view.kinds, view.left);
      picture.show(state, scene, trace, recombined);
      card.show(state, scene, trace, missing);
      card.light(lit, event);
      controls.show(state, scene);
      const last = view.timeline?.events.at(-1);
      lesson.show(state, scene, event, last?.what === "pixel" ? last.why : null);
      player.show(state, isAsking(state, scene) && !event ? null : view.timeline); // its colours would give the answer away
      code.show(event, trace, pixelIndex(state));
      whatIf.show(state, traced.scene);
      tileColours.show(state, view, trace, session.pointed);
      page.show(traced.scene, traced.trace);
      savings.show(scene);
      spoken.show(state, scene, trace, isAsking(state, scene));
      drawn = { scene: scene.id, n: state.n, tiles: trace ? view.tiles : 0, lines: view.thin.length };
    },
    /** What the stage shows, as a picture with a line under it; null before there is anything. */
    snapshot(): HTMLCanvasElement | null {
      const told = caption();
      if (told === null) return null;
      const flat = slice.element.hidden ? null : slice.element;
      const canvas = flat ? flat.querySelector("canvas")! : stage.redrawn();
      return snapshot(canvas, (flat ?? stage.element).querySelector(".labels"), told);
    },
    /** The same as an SVG whose rays and words can be edited; null where the stage is not what shows. */
    slide(): string | null {
      const told = caption();
      return told === null || stage.element.hidden ? null : stage.slide(told);
    },
    recolour: stage.recolour,
    linesDrawn: () => drawn.lines,
    /** For tests. */
    stats: () => ({ ...stage.stats(), shown: drawn, renders }),
    loseContext: stage.loseContext,
  };
}
