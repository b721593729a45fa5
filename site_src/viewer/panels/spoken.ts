/** The selected ray in words, for those who listen: spoken once the selection rests, and not while anything plays. */
import { the } from "../articles";
import { lightShares } from "../state/events";
import { treeOf } from "../state/lines";
import { memo } from "../state/memo";
import { pixelIndex, tileColour, type ViewState } from "../state/view-state";
import type { SceneData, Trace } from "../trace/types";
import { say } from "../words";
import { element } from "../element";
import { listenToFingers } from "./fingers";
import { createPointed } from "./pointed";
import { createYours } from "./yours";

const RESTS = 500; // ms: while arrows are held down nothing is spoken

function lightsOf(trace: Trace, scene: SceneData, ray: number): string {
  if (trace.localWeight[ray] === 0) return ""; // a mirror asks no light
  return lightShares(trace, scene, ray)
    .map(({ name: light, seen }, k) => say(`spoken.${seen}`, { light: the(light), name: the(scene.objects[trace.blocker[ray * trace.lights + k]]?.name ?? "") }))
    .join(" ");
}

export function selectionInWords(state: ViewState, scene: SceneData, trace: Trace): string {
  const pixel = pixelIndex(state);
  const [camera, ...others] = treeOf(trace, pixel);
  const slots = { column: state.pixel[0], row: state.pixel[1], bytes: tileColour(trace, pixel).join(", ") };
  const object = scene.objects[trace.object[camera]];
  if (!object) return say("spoken.miss", slots);
  return say("spoken.hit", { ...slots, count: others.length + 1, object: the(object.name), lights: lightsOf(trace, scene, camera) }).replace("  ", " "); // a mirror asks none
}

export function createSpoken(home: HTMLElement) {
  const root = element("p", "unseen");
  root.setAttribute("role", "status");
  root.setAttribute("aria-live", "polite");
  home.append(root);
  const spoken = memo<void>();
  const pointed = createPointed(home);
  const yours = createYours(home);
  listenToFingers(home); // here, because this part comes by itself
  let timer = 0;
  return {
    show(state: ViewState, scene: SceneData, trace: Trace | null, isCovered: boolean) {
      const isBusy = !trace || isCovered || state.playing || state.tiles === "filling" || state.event !== null; // an event's sentence is read out where it stands
      pointed.show(state, scene, isCovered ? null : trace);
      yours?.show(state, isCovered);
      spoken(isBusy ? [] : [trace, pixelIndex(state)], () => {
        clearTimeout(timer);
        if (!isBusy) timer = window.setTimeout(() => (root.textContent = selectionInWords(state, scene, trace)), RESTS);
      });
    },
  };
}
