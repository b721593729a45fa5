/** The stage drawn with three. One frame for each call of draw: nothing runs by itself. */
import { ColorManagement, LinearSRGBColorSpace, PCFShadowMap, PerspectiveCamera, Scene, WebGLRenderer } from "three";
import { lampColour, LINES, STAGE } from "../palette";
import type { Line } from "../state/lines";
import { memo } from "../state/memo";
import { dot, length, sub } from "../state/vectors";
import { createCameraSign } from "./camera-sign";
import { createDots, type Dot } from "./dots";
import { createLineSet } from "./line-set";
import { release } from "./release";
import type { Drawn, StageRenderer, StageView } from "./renderer";
import { createSegments } from "./segments";
import { createSolids } from "./solids";
import { createTiles } from "./tiles";

const endsOf = (lines: readonly Line[], blocked: boolean): Dot[] =>
  lines
    .filter((line) => (blocked ? line.kind === "blocked" : line.light < 0) && !line.leaves && !line.growing)
    .map((line) => ({ at: line.to, colour: LINES[line.kind].colour, ...(blocked ? { sign: 1 as const } : {}) }));

/** How bright a lamp's sign is: a faint light is a fainter sign, one that is off a struck ring. */
const lampDots = ({ scene, switched }: StageView): Dot[] =>
  switched.lights.map(({ position, intensity, colour }, k) => {
    const share = scene.lights[k].intensity > 0 ? intensity / scene.lights[k].intensity : 1;
    return share > 0 ? { at: position, colour: lampColour(colour), bright: Math.min(1, 0.45 + 0.55 * share) } : { at: position, colour: STAGE.lampOff, sign: 2 };
  });

const OPTIONS = { alpha: true, antialias: true, powerPreference: "low-power" } as const;
const KEPT_SETS = 4;
const DOTS_UP_TO = 1500; // lines: beyond, the dots would hide what they lie on

const isPlain = (view: StageView) => view.state.look === "plain";

/** What stays while the scene stays. */
function createSet(view: StageView) {
  const world = new Scene();
  const solids = createSolids(view.scene, isPlain(view));
  const tiles = createTiles(view.plane);
  const sign = createCameraSign(view.plane, view.scene.bounds.radius);
  const lamps = createDots(34, 0.55);
  const [chosen, thin] = [createLineSet(true), createLineSet(false)];
  const [hits, thinHits, stops] = [9, 6, 19].map((size) => createDots(size));
  // Nothing hides boxes: most lie inside the mesh.
  const [missed, entered] = [createSegments(STAGE.boxMissed, 0.6, true), createSegments(STAGE.boxEntered, 0.85, true)];
  world.add(...[solids, tiles, sign, lamps, chosen, thin, hits, thinHits, stops, missed, entered].map((part) => part.object));
  const [forChosen, forThin, forBoxes, forSwitches, forSurroundings] = [1, 2, 3, 4, 5].map(() => memo<void>());
  return {
    of: view.scene,
    world,
    show(now: StageView, fromEye: boolean) {
      tiles.object.visible = !now.state.wipe; // the bodies are compared
      tiles.show(now.costs?.colours ?? null, now.state.n, now.tiles, now.state.pixel, now.ring);
      sign.object.visible = !fromEye; // the observer looks through it
      forChosen([now.chosen, now.lit], () => {
        chosen.show(now.chosen, now.lit);
        hits.show(endsOf(now.chosen, false));
        stops.show(endsOf(now.chosen, true));
      });
      forThin([now.thin], () => {
        thin.show(now.thin, null);
        thinHits.show(now.thin.length > DOTS_UP_TO ? [] : endsOf(now.thin, false));
      });
      forBoxes([now.boxLines], () => {
        missed.show(now.boxLines.missed);
        entered.show(now.boxLines.entered);
      });
      forSurroundings([now.surroundings], () => solids.surround(now.surroundings));
      forSwitches([now.switched], () => {
        solids.follow(now.switched, now.state.switches);
        lamps.show(lampDots(now));
      });
    },
    resize(width: number, height: number, ratio: number) {
      for (const lines of [chosen, thin]) lines.resize(width, height);
      for (const dots of [lamps, hits, thinHits, stops]) dots.resize(ratio);
    },
  };
}

/** The last few scenes stay on the graphics card: going back to one takes no time. */
function createSets(made: (set: ReturnType<typeof createSet>) => void) {
  const sets = new Map<string, ReturnType<typeof createSet>>();
  return {
    all: () => [...sets.values()],
    of(view: StageView) {
      const name = `${view.scene.id} ${view.scene.of} ${isPlain(view)} ${view.plane.origin}`;
      const last = sets.get(name);
      const known = last?.of === view.scene ? last : null;
      if (last && !known) release(last.world); // the scene was read anew since
      const set = known ?? createSet(view);
      sets.delete(name);
      sets.set(name, set);
      if (!known) made(set);
      for (const [each, old] of sets) if (sets.size > KEPT_SETS) release(old.world), sets.delete(each);
      return set;
    },
    forget() {
      for (const { world } of sets.values()) release(world);
      sets.clear();
    },
  };
}

/** As the observer sees it: near and far as close together as the scene lets them be. */
function aim(camera: PerspectiveCamera, { view, observer, projection }: Drawn) {
  const { center, radius } = view.scene.bounds;
  const depth = dot(sub(center, observer.eye), projection.forward);
  camera.position.set(...observer.eye);
  camera.up.set(...observer.up);
  camera.lookAt(...observer.target);
  camera.fov = (Math.atan(projection.height / 2 / projection.focal) * 360) / Math.PI;
  camera.aspect = projection.width / projection.height;
  camera.near = Math.max(radius / 300, depth - 8 * radius);
  camera.far = Math.max(depth, 0) + 8 * radius;
  camera.updateProjectionMatrix();
}

function createThree(canvas: HTMLCanvasElement, context: WebGL2RenderingContext): WebGLRenderer {
  ColorManagement.enabled = false; // the course's colours are display values
  const renderer = new WebGLRenderer({ canvas, context, ...OPTIONS });
  renderer.outputColorSpace = LinearSRGBColorSpace;
  renderer.localClippingEnabled = true;
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = PCFShadowMap;
  renderer.shadowMap.autoUpdate = false; // nothing moves but the observer, and what a sweep moves
  renderer.debug.checkShaderErrors = false; // asking waits for the compiler; the tests look at what is drawn
  return renderer;
}

/** null where the browser gives no WebGL. */
export function createWebglRenderer(onLost: () => void): StageRenderer | null {
  const canvas = document.createElement("canvas");
  const context = canvas.getContext("webgl2", OPTIONS) as WebGL2RenderingContext | null;
  if (!context) return null;
  // Before three hears of it: another renderer takes over, nothing is to be restored.
  canvas.addEventListener("webglcontextlost", (event) => (event.stopImmediatePropagation(), onLost()));
  const renderer = createThree(canvas, context);
  const camera = new PerspectiveCamera();
  let size: [number, number, number] = [1, 1, 1];
  let shadowed = ""; // the stop of whatever moves that shadows were drawn for
  const sets = createSets((set) => {
    set.resize(...size);
    renderer.shadowMap.needsUpdate = true;
  });
  return {
    canvas,
    isFlat: false,
    draw(now) {
      const { view, observer } = now;
      const set = sets.of(view);
      renderer.shadowMap.needsUpdate ||= shadowed !== (shadowed = view.switched.of);
      aim(camera, now);
      set.show(view, length(sub(observer.eye, view.plane.eye)) < view.scene.bounds.radius / 50);
      renderer.render(set.world, camera);
    },
    resize(width, height, ratio) {
      size = [width, height, ratio];
      renderer.setPixelRatio(ratio);
      renderer.setSize(width, height, false);
      for (const set of sets.all()) set.resize(...size);
    },
    forget: sets.forget,
    held: () => ({ ...renderer.info.memory, programs: renderer.info.programs?.length ?? 0, sets: sets.all().length }),
    dispose() {
      sets.forget();
      renderer.dispose();
      renderer.domElement.remove(); // named here, it is kept for parts, which ask for its size
    },
  };
}
