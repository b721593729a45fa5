/** Where state's modules meet: everything that decides what is on the page, as one object, and who looks at it. */
import type { Vec3, View } from "../trace/types";
import type { Switches } from "./switches";

export const TABS = ["rays", "tree", "sum", "code"] as const;
export type Tab = (typeof TABS)[number] | "none";

export interface ViewState {
  scene: string;
  n: number; // tiles across and down
  pixel: readonly [number, number]; // column, row from the top left
  /** The selected place in the picture, 0..1 across and down: kept when n changes, so that going
   *  to another resolution and back ends on the same ray. */
  place: readonly [number, number];
  rays: NonNullable<View["rays"]>;
  tiles: "empty" | "filling" | "filled";
  drawn: number; // tiles shown so far while filling; may be a fraction
  speed: number;
  observer: NonNullable<View["observer"]>;
  look: NonNullable<View["look"]>;
  wipe: number; // in the traced look: share of the picture, from its left, that gives way to the approximate one
  before: ViewState["observer"] | null; // in the traced look: the observer to whom any other look goes back
  slice: NonNullable<View["slice"]>; // the plane of the selected row's or column's rays, drawn flat instead of the stage
  tab: Tab; // of the ray card; "none": what the colour is made of
  step: number | null; // of the lesson
  revealed: boolean; // the step's answer
  projector: boolean; // large type on a light page
  still: boolean; // no clock: no blinking, tiles fill at once, no line grows
  event: number | null; // of the selected pixel, the one the player is at; null: all of it shows
  share: number; // of that event's time that has passed, 0..1
  playing: boolean;
  gl: boolean; // false: draw without WebGL
  switches: Switches;
  colours: NonNullable<View["colours"]>; // what the tiles show
  sweep: string; // the stop of what is moved, "lamp-height:7"; "": the scene as it is
}

/** What stays when another scene or a lesson's step is shown. */
export type Kept = Pick<ViewState, "speed" | "still" | "gl"> & Partial<Pick<ViewState, "projector" | "tab">>;

export interface Observer {
  eye: Vec3;
  target: Vec3;
  up: Vec3;
  fov: number; // degrees across the stage's shorter side
}

/** A line that is lit up. */
export interface LitLine {
  ray: number;
  light: number; // of a shadow ray from the ray's hit; -1: the ray itself
}
