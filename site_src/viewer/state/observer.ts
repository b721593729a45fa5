/** The observer: the eye the user moves. The ray-tracing camera never moves. */
import type { SceneData } from "../trace/types";
import { planeCorners, type PicturePlane } from "./frustum";
import { corners } from "./placing";
import { createProjection } from "./projection";
import type { Observer, ViewState } from "./types";
import { add, cross, dot, length, scale, sub, unit, type Vec3 } from "./vectors";

export type ObserverChoice = ViewState["observer"];

const FOV = 40;
/** Degrees round from behind the ray-tracing camera: beside it on a wide stage, nearer behind it on a
 *  narrow one, where camera and scene would not fit side by side. */
const azimuth = (aspect: number) => 36 + 16 * Math.min(1, Math.max(0, (aspect - 0.9) / 0.8));
const ELEVATION = 20;
const FILL = 0.86; // of the stage that the scene may take at the start
const CAMERA_MARGIN = 1.12; // a little more than the ray-tracing camera sees, so that the tiles' edge shows
const STEEPEST = 89;
const WORLD_UP: Vec3 = [0, 1, 0];

const radians = (degrees: number) => (degrees * Math.PI) / 180;

/** What the start view must show: the eye, its picture plane, every finite object and every light. */
export function landmarks(scene: SceneData, plane: PicturePlane): Vec3[] {
  const within = (p: Vec3) => length(sub(p, scene.bounds.center)) < 1.5 * scene.bounds.radius;
  return [
    add(scene.camera.eye, scale(plane.forward, -0.2 * length(plane.across))), // the camera's back
    ...planeCorners(plane),
    ...scene.lights.map((light) => light.position),
    ...scene.objects.flatMap((object) => corners(object, scene)).filter(within),
  ];
}

/** Beside and above the ray-tracing camera, as near as shows every landmark.
 *  aspect: the stage's width over its height. */
function startObserver(scene: SceneData, plane: PicturePlane, aspect: number): Observer {
  const ahead: Vec3 = unit([plane.forward[0], 0, plane.forward[2] || 1e-9]);
  const side = unit(cross(ahead, WORLD_UP));
  const turn = radians(azimuth(aspect));
  const tilt = radians(ELEVATION);
  const flat = add(scale(side, Math.sin(turn)), scale(ahead, -Math.cos(turn)));
  const away = add(scale(flat, Math.cos(tilt)), scale(WORLD_UP, Math.sin(tilt)));
  const points = landmarks(scene, plane);
  let target = scene.bounds.center;
  let distance = 2.5 * scene.bounds.radius;
  // Centre what is seen and step back or forth until it just fits; a few rounds are enough.
  for (let round = 0; round < 12; round++) {
    const view = createProjection({ eye: add(target, scale(away, distance)), target, up: WORLD_UP, fov: FOV }, aspect, 1);
    const seen = points.map(view.project);
    const [left, right] = [Math.min(...seen.map((p) => p.x)), Math.max(...seen.map((p) => p.x))];
    const [top, bottom] = [Math.min(...seen.map((p) => p.y)), Math.max(...seen.map((p) => p.y))];
    const perUnit = view.focal / distance;
    target = add(target, scale(view.right, ((left + right) / 2 - aspect / 2) / perUnit));
    target = add(target, scale(view.up, (0.5 - (top + bottom) / 2) / perUnit));
    distance *= Math.max((right - left) / aspect, bottom - top) / FILL;
  }
  return { eye: add(target, scale(away, distance)), target, up: WORLD_UP, fov: FOV };
}

/** Looking through the ray-tracing camera: the tiles cover exactly what they show. */
function cameraObserver(scene: SceneData): Observer {
  const { eye, target, up, fov } = scene.camera;
  const half = Math.tan(radians(fov / 2)) * CAMERA_MARGIN;
  const reach = Math.max(dot(sub(scene.bounds.center, eye), unit(sub(target, eye))), 0.1 * scene.bounds.radius);
  return { eye, target: add(eye, scale(unit(sub(target, eye)), reach)), up, fov: (Math.atan(half) * 360) / Math.PI };
}

/** What moves the observer. */
export interface Moves {
  /** Degrees to the right and up. */
  turn: (right: number, up: number) => void;
  /** Shares of the stage. */
  shift: (right: number, up: number) => void;
  /** A factor on the distance. */
  come: (factor: number) => void;
}

/** A choice ("start", "camera" or a place) as a place. */
export function observerOf(choice: ObserverChoice, scene: SceneData, plane: PicturePlane, aspect: number): Observer {
  if (choice === "start") return startObserver(scene, plane, aspect);
  if (choice === "camera") return cameraObserver(scene);
  return { ...choice, up: WORLD_UP, fov: FOV };
}

/** A moved observer has the ordinary field of view: keep what is on screen as large as it was. */
function ordinary(observer: Observer): Observer {
  if (observer.fov === FOV) return observer;
  const nearer = Math.tan(radians(observer.fov / 2)) / Math.tan(radians(FOV / 2));
  const eye = add(observer.target, scale(sub(observer.eye, observer.target), nearer));
  return { ...observer, eye, up: WORLD_UP, fov: FOV };
}

/** Degrees round the target to the right and up. */
export function orbit(from: Observer, right: number, up: number): ObserverChoice {
  const { eye, target } = ordinary(from);
  const arm = sub(eye, target);
  const reach = length(arm);
  const heading = Math.atan2(arm[0], arm[2]) + radians(right);
  const tilt = Math.asin(arm[1] / reach) + radians(up);
  const limit = radians(STEEPEST);
  const elevation = Math.max(-limit, Math.min(limit, tilt));
  const flat = Math.cos(elevation) * reach;
  return { eye: add(target, [Math.sin(heading) * flat, Math.sin(elevation) * reach, Math.cos(heading) * flat]), target };
}

/** Sideways, in shares of the stage's shorter side at the target's distance. */
export function pan(from: Observer, right: number, up: number): ObserverChoice {
  const observer = ordinary(from);
  const view = createProjection(observer, 1, 1);
  const unitsAcross = length(sub(observer.eye, observer.target)) / view.focal;
  const by = add(scale(view.right, right * unitsAcross), scale(view.up, up * unitsAcross));
  return { eye: add(observer.eye, by), target: add(observer.target, by) };
}

/** factor < 1 comes nearer; reach keeps within 1/50 to 12 of the scene's radius. */
export function zoom(from: Observer, factor: number, radius: number): ObserverChoice {
  const { eye, target } = ordinary(from);
  const reach = length(sub(eye, target));
  const next = Math.max(radius / 50, Math.min(12 * radius, reach * factor));
  return { eye: add(target, scale(sub(eye, target), next / reach)), target };
}
