/** The selected ray in words, for those who listen: said once the selection rests, and not while anything plays. */
import { treeOf } from "../state/lines";
import { pixelIndex, tileColour, type ViewState } from "../state/view-state";
import { VISIBILITY, type SceneData, type Trace } from "../trace/types";
import { say } from "../words";
import { element } from "./element";

const RESTS = 500; // ms: while arrows are held down nothing is said

const SAID = { [VISIBILITY.reached]: "arrives", [VISIBILITY.behind]: "away", [VISIBILITY.untested]: "unasked", [VISIBILITY.off]: "off" } as const;

function lightsOf(trace: Trace, scene: SceneData, ray: number): string {
  if (trace.localWeight[ray] === 0) return ""; // a mirror asks no light
  return scene.lights
    .map(({ name }, light) => {
      const at = ray * trace.lights + light;
      const seen = trace.visibility[at];
      if (seen === VISIBILITY.blocked) return say("spoken.blocked", { light: name, name: scene.objects[trace.blocker[at]]?.name ?? "?" });
      const how = SAID[seen as keyof typeof SAID];
      return say(`spoken.${how}`, { light: name });
    })
    .join(" ");
}

export function selectionInWords(state: ViewState, scene: SceneData, trace: Trace): string {
  const pixel = pixelIndex(state);
  const [camera, ...others] = treeOf(trace, pixel);
  const told = { column: state.pixel[0], row: state.pixel[1], bytes: tileColour(trace, pixel).join(", ") };
  const object = scene.objects[trace.object[camera]];
  if (!object) return say("spoken.miss", told);
  return say("spoken.hit", { ...told, count: others.length + 1, object: object.name, lights: lightsOf(trace, scene, camera) }).replace("  ", " "); // a mirror asks none
}

export function createSpoken() {
  const root = element("p", "unseen");
  root.setAttribute("role", "status");
  root.setAttribute("aria-live", "polite");
  let asked: readonly unknown[] = [];
  let timer = 0;
  return {
    element: root,
    show(state: ViewState, scene: SceneData, trace: Trace | null, isCovered: boolean) {
      const isBusy = !trace || isCovered || state.playing || state.tiles === "filling" || state.event !== null; // an event's sentence is said in its own place
      const key = isBusy ? [] : [trace, pixelIndex(state)];
      if (key.length === asked.length && key.every((each, k) => each === asked[k])) return;
      asked = key;
      clearTimeout(timer);
      if (isBusy || !trace) return;
      timer = window.setTimeout(() => (root.textContent = selectionInWords(state, scene, trace)), RESTS);
    },
  };
}
