/** The page's parts, where they stand, and what each of them shows of the present. */
import type { Actions } from "./actions";
import type { OnDemand } from "./on-demand";
import type { Loader } from "./load";
import { contrastWith } from "./palette";
import { createCard } from "./panels/card";
import { createControls } from "./panels/controls";
import { element } from "./element";
import { createLegend } from "./panels/legend";
import { createLesson } from "./panels/lesson";
import { createPage, type PageParts } from "./panels/page";
import { createPicture } from "./panels/picture";
import { createPlayer } from "./panels/player";
import { createToolsDrawer } from "./panels/tools-drawer";
import type { SavedView } from "./saving";
import type { Session } from "./session";
import type { Label } from "./stage/labels";
import type { Drawn, StageRenderer } from "./stage/renderer";
import type { SliceView } from "./stage/slice-sheet";
import { createStage, type Stage } from "./stage/stage";
import { isSwitched } from "./state/switches";
import { isAsking, stopOf, type ViewState } from "./state/view-state";
import { say } from "./words";

export interface PartsPlace {
  home: HTMLElement; // the element they go into
  page: PageParts;
  withGl: boolean;
  pictureFailed: (again: () => void) => void;
  kept: Loader["kept"];
  /** Why the stage is drawn in a simpler way from now on; "": it no longer is. */
  simpler: (why: string) => void;
}

const ON_STAGE = ".stage > .picture, .busy-note"; // what must not hide a label
const NARROW = "(max-width: 760px)";

function createPanels(session: Session, stage: Stage, acts: Actions, onDemand: OnDemand, { home, page, pictureFailed, kept }: PartsPlace) {
  const whatIf = onDemand.one("what-if", ({ createWhatIf }) => createWhatIf(acts, home));
  const drawer = createToolsDrawer({ ...acts, ...stage, start: () => acts.observer("start"), whatIf: () => whatIf.use(({ turn }) => (turn(), session.changed())) }, session.changed, onDemand);
  return {
    picture: createPicture(page.root, { ...acts, failed: pictureFailed }),
    card: createCard(acts, onDemand),
    controls: createControls(acts),
    legend: createLegend(),
    lesson: createLesson(acts),
    player: createPlayer(acts),
    whatIf,
    drawer,
    choices: onDemand.one("choices", ({ createChoices }) => createChoices(acts, home, session.changed, onDemand)),
    guide: onDemand.one("guide", ({ createGuide }) => createGuide(drawer.open)),
    tileColours: onDemand.one("tile-legend", ({ createTileLegend }) => createTileLegend(home.querySelector(".below-row")!)),
    page: createPage(page, onDemand),
    sweeps: onDemand.one("sweeps", ({ createSweeps }) => createSweeps(session, home, kept)),
    savings: onDemand.one("told", ({ createSavings }) => createSavings(home.querySelector(".side")!)),
    // Nothing is spoken before the page is whole.
    spoken: onDemand.one("spoken", ({ createSpoken }) => createSpoken(home)),
  };
}
type Panels = ReturnType<typeof createPanels>;

/** The stage with the drawer beside it and the ray card at its other side, and under all of them what is told and done. */
function layOut(home: HTMLElement, draw: () => void, stage: Stage, { picture, card, controls, legend, lesson, player, drawer }: Panels) {
  const space = element("section", "stage", stage.element);
  const side = element("div", "side", card.head, card.element, legend.element);
  // What is told comes first for those who go through the page by Tab, wherever it stands.
  home.append(
    element("div", "below", lesson.element, element("div", "below-row", player.element, controls.element)),
    element("div", "stage-row", drawer.element, space),
    side,
  );
  document.querySelector(".menu-open")!.before(drawer.toggle);
  // Where the card is not beside the stage, the picture stands in the stage's corner.
  const narrow = matchMedia(NARROW);
  narrow.addEventListener("change", draw);
  let isInset: boolean | null = null;
  return (state: ViewState) => {
    const inset = narrow.matches || document.body.classList.contains("embed") || (state.projector && state.tab === "none");
    if (inset !== isInset) (inset ? space : side).prepend(picture.element);
    return (isInset = inset);
  };
}

/** What a frame shows; null until all of it is there. */
function presentOf(session: Session) {
  const { state, scene, lit, missing } = session;
  const now = session.switched();
  const view = session.shown();
  return state && scene && now && view && { state, lit, missing, ...now, view, event: session.currentEvent(), recombined: session.recombined(), traced: { scene, trace: session.traced() } };
}
type Present = NonNullable<ReturnType<typeof presentOf>>;

function showPanels(panels: Panels, session: Session, words: () => typeof import("./event-words") | null, { state, lit, missing, scene, trace, view, event, recombined, traced }: Present) {
  const asking = isAsking(state, scene);
  const last = view.timeline?.events.at(-1);
  panels.drawer.show(state, traced.scene);
  panels.legend.show(view.kinds, view.left);
  panels.picture.show(state, scene, trace, recombined);
  panels.card.show(state, scene, trace, missing, lit, event);
  panels.controls.show(state, scene);
  panels.choices.when(!!scene.lesson[state.step!]?.choices, session.changed)?.show(state, scene, traced.trace); // before the lesson: the focus goes on to what it leaves
  panels.lesson.show(state, scene, event, last, words);
  panels.player.show(state, asking && !event ? null : view.timeline, (event && words()?.sentence(event)) ?? ""); // its colours would give the answer away
  panels.guide.when(state.step !== null, session.changed)?.show(state);
  panels.whatIf.when(isSwitched(state.switches), session.changed)?.show(state, session.here()!);
  panels.tileColours.when(state.colours !== "picture", session.changed)?.show(state, view, trace, session.pointed);
  panels.page.show(traced.scene, traced.trace);
  panels.sweeps.when(!!scene.sweeps, session.changed)?.show(state, scene);
  panels.savings.when(state.tab !== "none", session.changed)?.show(scene); // it stands under a tab
  panels.spoken.when(!!location.search, session.changed)?.show(state, scene, trace, asking); // it shows what the address brings from a check
}

/** The stage, and what of it comes later. */
function createStageOf(acts: Actions, onDemand: OnDemand, { home, page, withGl, simpler, kept }: PartsPlace, changed: () => void) {
  const flat = (why: "refused" | "lost" | null) => {
    if (why) document.body.dataset.renderer = "flat";
    else delete document.body.dataset.renderer;
    simpler(why ? say(`trouble.${why}`) : "");
  };
  const drawnFlat = onDemand.one("flat", (part) => part);
  const tracedPicture = onDemand.one("traced-picture", ({ createTracedPicture }) => {
    const made = createTracedPicture(page.root, acts.wipe);
    stage.element.append(...made.parts);
    return made;
  });
  const marks = onDemand.one("marks", ({ createMarks }) => {
    const made = createMarks();
    stage.element.append(made.element);
    return made;
  });
  const worked = onDemand.one("worked", ({ createWorked }) => createWorked({ stage: stage.element, side: home.querySelector(".side")!, kept, changed }));
  const hint = onDemand.one("at-hand", ({ createSwipeHint }) => createSwipeHint());
  const later = {
    flat,
    flatRenderer: (use: (make: () => StageRenderer) => void) => drawnFlat.use(({ createFlatRenderer }) => use(createFlatRenderer)),
    scrolled: () => hint.use((tell) => tell()),
    traced: (isWanted: boolean, come: () => void) => tracedPicture.when(isWanted, come),
    marked(drawn: Drawn, labels: Label[], come: () => void) {
      worked.when(!!stopOf(drawn.view.scene, drawn.view.state)?.view.works, come)?.show(drawn);
      return marks.when(drawn.view.state.step !== null, come)?.show(drawn, labels) ?? labels;
    },
  };
  const stage: Stage = createStage({ ...acts, ...later, move: acts.observer }, withGl, () => [...document.querySelectorAll(ON_STAGE)]);
  return stage;
}

export function createParts(session: Session, acts: Actions, onDemand: OnDemand, where: PartsPlace) {
  const { home } = where;
  const eventWords = onDemand.one("event-words", (part) => part);
  const stage = createStageOf(acts, onDemand, where, session.changed);
  const panels = createPanels(session, stage, acts, onDemand, where);
  const place = layOut(home, session.changed, stage, panels);
  const corner = onDemand.one("inset", ({ createInset }) => createInset(panels.picture.element, session.changed));
  const slice = onDemand.one("slice", ({ createSlice, sectionOf }) => {
    const made = createSlice({ pick: acts.pickAlong });
    stage.element.after(made.element);
    return { ...made, sectionOf };
  });

  /** What is shown instead of the stage: a slice, once its outlines have come, and with them what draws it. */
  function sliceOf({ state, scene, trace, view }: Present): SliceView | null {
    const { sections } = session;
    const section = sections && trace && slice.now()?.sectionOf(sections, state, scene, trace, view.plane);
    if (!section) return null;
    return { section, scene, trace, large: state.projector, tile: state.pixel[section.direction === "row" ? 0 : 1], tiles: view.tiles, costs: view.costs, chosen: view.chosen };
  }

  function showStage(present: Present, dark: boolean) {
    const { state, lit, scene, trace, view, event, recombined, traced } = present;
    const flat = sliceOf(present);
    stage.element.hidden = flat !== null;
    if (flat || shownSlice) slice.now()!.show(flat);
    shownSlice = flat && slice.now();
    if (!flat) stage.show({ ...view, scene: traced.scene, switched: scene, ...panels.sweeps.now()?.drawn(scene), recombined, trace, state, surroundings: session.surroundings?.scene === scene.of && !recombined ? session.surroundings : null, lit: lit ?? event, ring: dark ? null : contrastWith(view.ringOn) });
  }

  let shownSlice: SavedView | null = null;
  let renders = 0;
  let drawn = { scene: "", n: 0, tiles: 0, lines: 0 }; // by the last render
  return {
    /** Shows the present. dark: the selected tile's ring blinks off. */
    render(dark: boolean) {
      const present = presentOf(session);
      if (!present) return;
      renders++;
      const { state, scene, trace, view } = present;
      home.classList.toggle("opened", state.tab !== "none"); // first: a card that brings itself into sight must know where it will stand
      showPanels(panels, session, () => eventWords.nowOr(session.changed), present);
      const inset = place(state);
      showStage(present, dark); // last: its labels keep clear of the panels that stand on it now
      if (inset && !shownSlice) corner.nowOr(session.changed)?.show(stage.drawn());
      drawn = { scene: scene.id, n: state.n, tiles: trace ? view.tiles : 0, lines: view.thin.length };
    },
    views: { stage, slice: () => shownSlice },
    recolour: stage.recolour,
    linesDrawn: () => drawn.lines,
    /** For tests. */
    stats: () => ({ ...stage.stats(), shown: drawn, renders, surrounded: session.surroundings?.scene === session.scene?.of }),
    loseContext: stage.loseContext,
  };
}
