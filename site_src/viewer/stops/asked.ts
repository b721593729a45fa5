/** What the tracer is asked for a lesson's figures: shaded views, what hides a line, all digits of what is printed. */
import type { Switches } from "../state/switches";
import type { Vec3 } from "../state/vectors";
import { pixelIndex, stopOf } from "../state/view-state";
import { switchedScene } from "../state/what-if";
import type { ViewState } from "../state/types";
import type { SceneData } from "../trace/types";
import { mapsFor, type ShadowMaps } from "./rasterised";
import { seenAt, settingOf, stopsOf, walksPixel, type Seen, type Size, type Traces } from "./seen";
import { worksheetOf, type Worksheet } from "./worksheet";

/** A place to look from, and the scene as it is lit. */
interface Viewpoint extends Size {
  eye: Vec3;
  right: Vec3;
  up: Vec3;
  forward: Vec3;
  focal: number;
  lit: Lit;
  maps?: ShadowMaps; // its shadows are those of a rasteriser
}

type Lit = Pick<SceneData, "depth" | "shadows"> & {
  intensities: readonly number[]; // by light
  paints: readonly (readonly [Vec3, Vec3, Vec3])[]; // by material: ambient, diffuse, specular
};

export interface Asked {
  viewpoints: readonly Viewpoint[];
  stops: readonly {
    viewpoint: number;
    lines: readonly (readonly [Vec3, Vec3])[]; // chosen ones, then thin ones
    tiles: { n: number; origin: Vec3; across: Vec3; down: Vec3 };
  }[];
  exact: readonly { n: number; pixels: readonly number[] }[];
  worksheet: Worksheet;
}

/** Rasterised without tricks there are no shadows, and nothing is mirrored or bent. */
const switchesOf = ({ look, switches }: ViewState): Switches => (look === "plain" ? { ...switches, shadows: false, bounces: 0 } : switches);

const isPaint = (part: string) => part === "ambient" || part === "diffuse" || part === "specular";

/** Which rays are sent on stays: the view is pale, and mirrors are to be known as such. */
function litBy(whole: SceneData, switches: Switches): Lit {
  const { depth, shadows, lights, materials } = switchedScene(whole, { ...switches, without: switches.without.filter(isPaint) });
  return { depth, shadows, intensities: lights.map(({ intensity }) => intensity), paints: materials.map(({ ambient, diffuse, specular }) => [ambient, diffuse, specular]) };
}

function viewpointOf({ observer: { eye }, projection }: Seen, lit: Lit, maps: ShadowMaps | null): Viewpoint {
  const { right, up, forward, focal, width, height } = projection;
  return { eye, right, up, forward, focal, width, height, lit, ...(maps && { maps }) };
}

export function ask(scene: SceneData, traces: Traces, size: Size): Asked {
  const setting = settingOf(scene, size);
  const { origin, across, down } = setting.plane;
  const all = stopsOf(scene);
  const viewpoints: string[] = [];
  const exact = new Map<number, Set<number>>();
  const want = (n: number, pixel: number) => exact.set(n, (exact.get(n) ?? new Set()).add(pixel));
  const stops = all.map(({ state }) => {
    const seen = seenAt(state, traces(state.n), setting);
    const maps = stopOf(scene, state)?.view.look === "approximate" ? mapsFor(seen.scene) : null;
    const viewpoint = JSON.stringify(viewpointOf(seen, litBy(scene, switchesOf(state)), maps));
    if (!viewpoints.includes(viewpoint)) viewpoints.push(viewpoint);
    if (walksPixel(state)) want(state.n, pixelIndex(state));
    const lines = [...seen.chosen, ...seen.thin].map(({ from, to }) => [from, to] as const);
    return { viewpoint: viewpoints.indexOf(viewpoint), lines, tiles: { n: state.n, origin, across, down } };
  });
  return { viewpoints: viewpoints.map((each) => JSON.parse(each)), stops, exact: [...exact].map(([n, pixels]) => ({ n, pixels: [...pixels].sort((a, b) => a - b) })), worksheet: worksheetOf(all) };
}
