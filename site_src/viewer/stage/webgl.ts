/** The stage drawn with three. One frame for each call of draw: nothing runs by itself. */
import { ColorManagement, LinearSRGBColorSpace, PCFShadowMap, PerspectiveCamera, Scene, WebGLRenderer } from "three";
import { LINES, STAGE } from "../palette";
import type { Line } from "../state/lines";
import { dot, length, sub } from "../state/vectors";
import { createBoxSet } from "./box-set";
import { createCameraSign } from "./camera-sign";
import { createDots, type Dot } from "./dots";
import { createLineSet } from "./line-set";
import type { StageRenderer, StageView } from "./renderer";
import { createSolids } from "./solids";
import { createTiles } from "./tiles";

const endsOf = (lines: readonly Line[], blocked: boolean): Dot[] =>
  lines
    .filter((line) => (blocked ? line.kind === "blocked" : line.light < 0) && !line.leaves && !line.growing)
    .map((line) => ({ at: line.to, colour: LINES[line.kind].colour, ...(blocked ? { sign: 1 as const } : {}) }));

/** How bright a lamp's sign is: a faint light is a fainter sign, one that is off a struck ring. */
const lampDots = ({ scene, switched }: StageView): Dot[] =>
  scene.lights.map(({ position, intensity }, k) => {
    const share = intensity > 0 ? switched.lights[k].intensity / intensity : 1;
    return share > 0 ? { at: position, colour: STAGE.lamp, bright: Math.min(1, 0.45 + 0.55 * share) } : { at: position, colour: STAGE.lampOff, sign: 2 };
  });

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
  const chosen = createLineSet(true);
  const thin = createLineSet(false);
  const hits = createDots(9);
  const thinHits = createDots(6);
  const stops = createDots(19);
  const boxes = createBoxSet();
  const parts = [solids, tiles, sign, lamps, chosen, thin, hits, thinHits, stops, boxes];
  world.add(...parts.map((part) => part.object));
  const shown: { chosen?: readonly Line[]; thin?: readonly Line[]; lit?: unknown; boxes?: unknown; switched?: unknown } = {};
  return {
    world,
    show(now: StageView, fromEye: boolean) {
      tiles.show(now.costs?.colours ?? null, now.state.n, now.tiles, now.state.pixel, now.ring);
      sign.show(!fromEye);
      if (shown.chosen !== now.chosen || shown.lit !== now.lit) {
        chosen.show(now.chosen, now.lit);
        hits.show(endsOf(now.chosen, false));
        stops.show(endsOf(now.chosen, true));
      }
      if (shown.boxes !== now.boxLines) boxes.show(now.boxLines);
      if (shown.thin !== now.thin) {
        thin.show(now.thin, null);
        thinHits.show(now.thin.length > DOTS_UP_TO ? [] : endsOf(now.thin, false));
      }
      if (shown.switched !== now.switched) {
        solids.follow(now.switched, now.state.switches);
        lamps.show(lampDots(now));
      }
      Object.assign(shown, { chosen: now.chosen, thin: now.thin, lit: now.lit, boxes: now.boxLines, switched: now.switched });
    },
    resize(width: number, height: number, ratio: number) {
      for (const lines of [chosen, thin]) lines.resize(width, height);
      for (const dots of [lamps, hits, thinHits, stops]) dots.resize(ratio);
    },
    dispose: () => parts.forEach((part) => part.dispose()),
  };
}

/** null where the browser gives no WebGL. */
export function createWebglRenderer(onLost: () => void): StageRenderer | null {
  const canvas = document.createElement("canvas");
  const options = { alpha: true, antialias: true, powerPreference: "low-power" } as const;
  const context = canvas.getContext("webgl2", options) as WebGL2RenderingContext | null;
  if (!context) return null;
  // Before three hears of it: another renderer takes over, nothing is to be restored.
  canvas.addEventListener("webglcontextlost", (event) => (event.stopImmediatePropagation(), onLost()));
  ColorManagement.enabled = false; // the course's colours are display values
  const renderer = new WebGLRenderer({ canvas, context, ...options });
  renderer.outputColorSpace = LinearSRGBColorSpace;
  renderer.localClippingEnabled = true;
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = PCFShadowMap;
  renderer.shadowMap.autoUpdate = false; // nothing moves but the observer
  renderer.debug.checkShaderErrors = false; // asking waits for the compiler; the tests look at what is drawn
  const camera = new PerspectiveCamera();
  let size = { width: 1, height: 1, ratio: 1 };
  const sets = new Map<string, ReturnType<typeof createSet> & { of: StageView["scene"] }>();

  /** The last few scenes stay on the graphics card: going back to one takes no time. */
  function setFor(view: StageView) {
    const name = `${view.scene.id} ${isPlain(view)}`;
    const last = sets.get(name);
    const known = last?.of === view.scene ? last : null;
    if (last && !known) last.dispose(); // the scene was read anew since
    const set = known ?? { ...createSet(view), of: view.scene };
    sets.delete(name);
    sets.set(name, set);
    if (known) return set;
    for (const [each, old] of sets) if (sets.size > KEPT_SETS) old.dispose(), sets.delete(each);
    set.resize(size.width, size.height, size.ratio);
    renderer.shadowMap.needsUpdate = true;
    return set;
  }

  return {
    canvas,
    draw(view, observer, projection) {
      const { center, radius } = view.scene.bounds;
      const now = setFor(view);
      const depth = dot(sub(center, observer.eye), projection.forward);
      camera.position.set(...observer.eye);
      camera.up.set(...observer.up);
      camera.lookAt(...observer.target);
      camera.fov = (Math.atan(size.height / 2 / projection.focal) * 360) / Math.PI;
      camera.aspect = size.width / size.height;
      camera.near = Math.max(radius / 300, depth - 8 * radius);
      camera.far = Math.max(depth, 0) + 8 * radius;
      camera.updateProjectionMatrix();
      now.show(view, length(sub(observer.eye, view.plane.eye)) < radius / 50);
      renderer.render(now.world, camera);
    },
    resize(width, height, ratio) {
      size = { width, height, ratio };
      renderer.setPixelRatio(ratio);
      renderer.setSize(width, height, false);
      for (const set of sets.values()) set.resize(width, height, ratio);
    },
    forget() {
      for (const set of sets.values()) set.dispose();
      sets.clear();
    },
    held: () => ({ ...renderer.info.memory, programs: renderer.info.programs?.length ?? 0, sets: sets.size }),
    dispose() {
      for (const set of sets.values()) set.dispose();
      renderer.dispose();
      canvas.remove();
    },
  };
}
