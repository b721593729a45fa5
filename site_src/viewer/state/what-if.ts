/**
 * The trace as it would be with switches set. A pixel is a weighted sum over its ray tree, so every switch
 * leaves out or scales terms that the trace holds; nothing is lit or followed anew. What each one means, and
 * what a fresh trace would be given instead (tests/viewer/what-if.test.mjs compares both):
 *
 * - bounce limit k: rays with more than k bounces are not there             (render.depth = k)
 * - lamp off or dimmed: both factors of its lights times f                  (its intensity times f)
 * - shadows off: each light counts as seen, glass on the way takes nothing  (render.shadows = false)
 * - without ambient, diffuse, specular: that colour is black in all materials
 * - without reflected: mirrored rays are not followed; a totally reflected ray keeps what it has of `transmit`
 * - without refracted: refracted rays are not followed; a totally reflected ray keeps what it has of `reflect`;
 *   in both cases every other share stays as it was, the local colour's too, and so do shadows through glass
 */
import { eightBit, recombine } from "../trace/rebuild";
import { KIND, RAY_KINDS, RAYS } from "../trace/kinds";
import { VISIBILITY, type SceneData, type Trace, type Vec3 } from "../trace/types";
import { memo } from "./memo";
import { factorsOf, HIDDEN, isSwitched, type Switches } from "./switches";

export interface WhatIf {
  trace: Trace;
  scene: SceneData;
}

const BLACK: Vec3 = [0, 0, 0];

/** The scene's colours, shares and limits with the switches set: what words and sums are made from. */
export function switchedScene(scene: SceneData, switches: Switches): SceneData {
  const factors = factorsOf(switches, scene);
  const without = (part: Switches["without"][number]) => switches.without.includes(part);
  return {
    ...scene,
    shadows: scene.shadows && switches.shadows,
    depth: switches.bounces ?? scene.depth,
    lights: scene.lights.map((light, k) => ({ ...light, intensity: light.intensity * factors[k] })),
    materials: scene.materials.map((material) => ({
      ...material,
      ambient: without("ambient") ? BLACK : material.ambient,
      diffuse: without("diffuse") ? BLACK : material.diffuse,
      specular: without("specular") ? BLACK : material.specular,
      reflect: without("reflected") ? 0 : material.reflect,
      transmit: without("refracted") ? 0 : material.transmit,
    })),
  };
}

interface Followed {
  pixel: Int32Array; // HIDDEN where a ray is left out
  weight: Float64Array;
}

/** Which rays are still there, and their shares. */
function follow(trace: Trace, scene: SceneData, switches: Switches): Followed {
  const limit = switches.bounces ?? Infinity;
  const mirrors = !switches.without.includes("reflected");
  const refracts = !switches.without.includes("refracted");
  const isOff = RAY_KINDS.map((kind) => switches.without.some((part) => part === RAYS[kind].part)); // by code
  if (limit === Infinity && !isOff.includes(true)) return trace;
  const pixel = trace.pixel.slice();
  const weight = trace.weight.slice();
  for (let ray = 0; ray < trace.count; ray++) {
    const parent = trace.parent[ray];
    if (parent < 0) continue;
    const kind = trace.kind[ray];
    if (kind === KIND.total && !(mirrors && refracts)) {
      const { reflect, transmit } = scene.materials[trace.material[parent]];
      weight[ray] = (mirrors ? reflect : 0) + (refracts ? transmit : 0);
    } else if (isOff[kind]) weight[ray] = 0;
    if (pixel[parent] === HIDDEN || weight[ray] === 0 || trace.depth[ray] > limit) {
      pixel[ray] = HIDDEN;
      weight[ray] = 0;
    }
  }
  return { pixel, weight };
}

/** Of each ray and light: off, seen because nothing counts as in the way, or as traced. */
function see(trace: Trace, isOff: readonly boolean[], shadows: boolean): Uint8Array {
  if (shadows && !isOff.includes(true)) return trace.visibility;
  const visibility = shadows ? trace.visibility.slice() : new Uint8Array(trace.visibility.length).fill(VISIBILITY.untested);
  for (let light = 0; light < trace.lights; light++)
    if (isOff[light]) for (let at = light; at < visibility.length; at += trace.lights) visibility[at] = VISIBILITY.off;
  return visibility;
}

function scaled(factor: Float64Array, trace: Trace, bright: readonly number[], shadows: boolean): Float64Array {
  if (shadows && bright.every((each) => each === 1)) return factor;
  const out = new Float64Array(factor.length);
  for (let light = 0; light < trace.lights; light++)
    for (let at = light; at < out.length; at += trace.lights) out[at] = (shadows ? factor[at] : factor[at] / trace.passed[at]) * bright[light];
  return out;
}

/** Remembers its last answer, and of it what another switch leaves as it is: columns keep their identity. */
export function createWhatIf() {
  const whole = memo<WhatIf>();
  const scenes = memo<SceneData>();
  const followed = memo<Followed>();
  const seen = memo<Uint8Array>();

  function make(trace: Trace, scene: SceneData, switches: Switches): WhatIf {
    const bright = factorsOf(switches, scene);
    const shadows = switches.shadows || !scene.shadows;
    const now = scenes([scene, switches], () => switchedScene(scene, switches));
    const { pixel, weight } = followed([trace, switches.bounces, switches.without.join()], () => follow(trace, scene, switches));
    const visibility = seen([trace, bright.map((each) => each === 0).join(), shadows], () => see(trace, bright.map((each) => each === 0), shadows));
    const diffuse = scaled(trace.diffuse, trace, bright, shadows);
    const specular = scaled(trace.specular, trace, bright, shadows);
    const altered = { ...trace, pixel, weight, visibility, diffuse, specular };
    const colour = recombine(now, altered);
    const tiles = new Uint8Array(3 * trace.n * trace.n);
    // What rays give is rounded in files, tiles are not: one that the switches leave as it was keeps its byte.
    for (let k = 0; k < tiles.length; k++) tiles[k] = colour[k] === trace.colour[k] ? trace.tiles[k] : eightBit(colour[k]);
    return { trace: { ...altered, colour, tiles }, scene: now };
  }

  return {
    /** The same objects where nothing is switched. */
    of: (trace: Trace, scene: SceneData, switches: Switches): WhatIf =>
      whole([trace, scene, switches], () => (isSwitched(switches) ? make(trace, scene, switches) : { trace, scene })),
  };
}
