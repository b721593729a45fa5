/** What the tracer is asked for a lesson's figures: shaded views, what hides a line, all digits of what is printed. */
import type { Switches } from "../state/switches";
import type { Vec3 } from "../state/vectors";
import { pixelIndex, stopOf } from "../state/view-state";
import { switchedScene } from "../state/what-if";
import type { ViewState } from "../state/types";
import type { SceneData } from "../trace/types";
import { mapsFor, type ShadowMaps } from "./rasterised";
import { seenAt, settingOf, stopsOf, walksPixel, type Places, type Seen, type Size } from "./seen";
import { worksheetOf, type Worksheet } from "./worksheet";

/** A place to look from, and the scene as it is lit. */
interface Viewpoint extends Size {
  sweep?: string; // the stop at which the scene is seen
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
  exact: readonly { n: number; pixels: readonly number[]; sweep?: string }[];
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

function viewpointOf({ observer: { eye }, projection }: Seen, lit: Lit, maps: ShadowMaps | null, sweep: string): Viewpoint {
  const { right, up, forward, focal, width, height } = projection;
  return { eye, right, up, forward, focal, width, height, lit, ...(maps && { maps }), ...(sweep && { sweep }) };
}

/** A grid at a stop, as a map's key and back. */
export const placeOf = ({ n, sweep = "" }: { n: number; sweep?: string }): string => `${n} ${sweep}`;

function placed(where: string): { n: number; sweep?: string } {
  const [n, sweep] = where.split(" ");
  return { n: Number(n), ...(sweep && { sweep }) };
}

export function ask(places: Places, size: Size): Asked {
  const all = stopsOf(places("").scene);
  const viewpoints: string[] = [];
  const exact = new Map<string, Set<number>>();
  const want = (where: string, pixel: number) => exact.set(where, (exact.get(where) ?? new Set()).add(pixel));
  const stops = all.map(({ state }) => {
    const { scene, traces } = places(state.sweep);
    const setting = settingOf(scene, size);
    const { origin, across, down } = setting.plane;
    const seen = seenAt(state, traces(state.n), setting);
    const maps = stopOf(scene, state)?.view.look === "approximate" ? mapsFor(seen.scene) : null;
    const viewpoint = JSON.stringify(viewpointOf(seen, litBy(scene, switchesOf(state)), maps, state.sweep));
    if (!viewpoints.includes(viewpoint)) viewpoints.push(viewpoint);
    if (walksPixel(state)) want(placeOf(state), pixelIndex(state));
    const lines = [...seen.chosen, ...seen.thin].map(({ from, to }) => [from, to] as const);
    return { viewpoint: viewpoints.indexOf(viewpoint), lines, tiles: { n: state.n, origin, across, down } };
  });
  return { viewpoints: viewpoints.map((each) => JSON.parse(each)), stops, exact: [...exact].map(([where, pixels]) => ({ ...placed(where), pixels: [...pixels].sort((a, b) => a - b) })), worksheet: worksheetOf(all) };
}
