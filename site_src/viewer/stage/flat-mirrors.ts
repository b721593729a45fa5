/**
 * Planes, discs and triangles that mirror: what stands on the eye's side of one is drawn once more, as the eye's mirror image
 * sees it, and laid over it as strongly as it mirrors. Of three this uses only what the viewer's own script keeps of it.
 */
import type { AmbientLight, Material, Mesh as AnyMesh, MeshPhongMaterial, Object3D, WebGLRenderer } from "three";
import { STAGE } from "../palette";
import { add, cross, dot, scale, sub, unit, type Vec3 } from "../state/vectors";
import type { FlatMirror } from "../trace/types";
import { Mesh, PerspectiveCamera, ShaderMaterial, WebGLRenderTarget } from "./surrounded";

const [BACK, BOTH] = [1, 2]; // sides, as three numbers them

const VERTEX = `
attribute vec2 spread;
varying vec2 vSpread;
varying vec3 vWorld;
void main() {
  vec4 mvPosition = modelViewMatrix * vec4(position, 1.0);
  gl_Position = projectionMatrix * mvPosition;
  gl_Position.z -= 1e-5 * gl_Position.w; // on the mirror, not in it
  vWorld = (modelMatrix * vec4(position, 1.0)).xyz;
  vSpread = spread;
}`;

const FRAGMENT = `
uniform sampler2D seen;
uniform vec2 size;
uniform float share;
uniform vec3 background;
#if ENDS > 0
uniform vec4 ends[ENDS];
#endif
varying vec2 vSpread;
varying vec3 vWorld;
void main() {
#if ENDS > 0
  for (int k = 0; k < ENDS; k++) if (dot(vWorld, ends[k].xyz) + ends[k].w < 0.0) discard;
#endif
  vec4 found = texture2D(seen, vec2(1.0 - gl_FragCoord.x / size.x, gl_FragCoord.y / size.y)); // left is right there
  gl_FragColor = vec4(found.rgb + (1.0 - found.a) * background, share * (1.0 - smoothstep(0.6, 1.0, length(vSpread))));
}`;

type Numbers = ArrayLike<number>;
const part = (of: Numbers, at: number): Vec3 => [of[at], of[at + 1], of[at + 2]];
/** A direction in the frame of a column-major matrix. */
const turned = (m: Numbers, [x, y, z]: Vec3): Vec3 => add(add(scale(part(m, 0), x), scale(part(m, 4), y)), scale(part(m, 8), z));

interface Plane {
  point: Vec3;
  normal: Vec3; // unit
  hasBack: boolean; // which mirrors too
}

/** The plane of a flat mesh. */
function planeOf({ geometry, matrix, material }: AnyMesh): Plane {
  const corners = geometry.getAttribute("position").array;
  const at = (k: number): Vec3 => add(turned(matrix.elements, part(corners, 3 * (geometry.index?.array[k] ?? k))), part(matrix.elements, 12));
  const [a, b, c] = [at(0), at(1), at(2)];
  const { side } = material as Material;
  const normal = unit(cross(sub(b, a), sub(c, a)));
  return { point: a, normal: side === BACK ? scale(normal, -1) : normal, hasBack: side === BOTH };
}

/** Puts a camera at the mirror image of another one; false: that sees no mirror. What it sees is the mirror's picture, left
 *  for right. */
function putAtImage(there: PerspectiveCamera, of: PerspectiveCamera, { point, normal, hasBack }: Plane): boolean {
  const world = of.matrixWorld.elements;
  const eye = part(world, 12);
  const heightOf = (at: Vec3) => dot(sub(at, point), normal);
  const height = heightOf(eye);
  if (height === 0 || (height < 0 && !hasBack)) return false;
  const imageOf = (at: Vec3): Vec3 => {
    const foot = sub(at, scale(normal, heightOf(at)));
    return add(foot, sub(foot, at)); // as far behind as it stands before
  };
  const image = imageOf(eye);
  there.position.set(...image);
  there.up.set(...sub(imageOf(add(eye, part(world, 4))), image));
  there.lookAt(...imageOf(sub(eye, part(world, 8)))); // a camera looks along its -z
  there.updateMatrixWorld();
  const inverse = there.matrixWorldInverse.elements;
  const out = turned(inverse, scale(normal, Math.sign(height)));
  const [to, from] = [there.projectionMatrix.elements, of.projectionMatrix.elements];
  for (let k = 0; k < 16; k++) to[k] = from[k];
  startAt(to, [...out, -dot(out, add(turned(inverse, point), part(inverse, 12)))]);
  return true;
}

/** Lets a projection show nothing before a plane, which is given in the camera's frame: it takes the near plane's place
 *  (Lengyel, Oblique View Frustum Depth Projection and Clipping, 2005, equation 7). */
function startAt(e: number[], plane: readonly number[]) {
  const corner = [(Math.sign(plane[0]) + e[8]) / e[0], (Math.sign(plane[1]) + e[9]) / e[5], -1, (1 + e[10]) / e[14]];
  const by = 2 / plane.reduce((sum, each, k) => sum + each * corner[k], 0);
  for (const [k, place] of [2, 6, 10, 14].entries()) e[place] = plane[k] * by + (k === 2 ? 1 : 0);
}

/** Colours as the tracer has them, and not as the stage does, whose walls are toned down and whose shade is lit a little; what
 *  it gives brings those back. */
function inFullColour(solids: Object3D): () => void {
  const everywhere = solids.children[0].children[0] as AmbientLight; // of the lights' group
  const { intensity } = everywhere;
  const walls = solids.children.flatMap((each) => ("geometry" in each && (each as AnyMesh).geometry.getAttribute("spread") ? [(each as AnyMesh).material as MeshPhongMaterial] : []));
  const tone = (by: number) => {
    for (const { color, emissive } of walls) {
      color?.fromArray(color.toArray().map((v, k) => v * STAGE.wall[k] ** by));
      emissive?.multiplyScalar(STAGE.wallGlow ** by);
    }
  };
  tone(-1);
  everywhere.intensity = 0;
  return () => {
    tone(1);
    everywhere.intensity = intensity;
  };
}

/** Draws the solids alone: no rays, no tiles, and no mirror in mirrors. */
function drawInto(target: WebGLRenderTarget, renderer: WebGLRenderer, world: Object3D, camera: PerspectiveCamera, solids: Object3D, mirrors: readonly Object3D[]) {
  const hidden = [...world.children.filter((each) => each !== solids), ...mirrors].filter(({ visible }) => visible);
  const before = renderer.getRenderTarget();
  const asBefore = inFullColour(solids);
  for (const each of hidden) each.visible = false;
  renderer.setRenderTarget(target);
  renderer.render(world, camera);
  renderer.setRenderTarget(before);
  for (const each of hidden) each.visible = true;
  asBefore();
}

/** What a wall, disc or triangle mirrors, to be laid over it. */
function sheetOver(mirror: AnyMesh, share: number, background: Vec3) {
  const ends = ((mirror.material as Material).clippingPlanes ?? []).map(({ normal: { x, y, z }, constant }) => [x, y, z, constant]);
  const look = new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    defines: { ENDS: ends.length },
    uniforms: { seen: { value: null }, size: { value: [1, 1] }, share: { value: share }, background: { value: background }, ends: { value: ends.flat() } },
  });
  look.side = (mirror.material as Material).side;
  look.transparent = true;
  look.depthWrite = false;
  const sheet = new Mesh(mirror.geometry, look);
  sheet.applyMatrix4(mirror.matrix);
  sheet.renderOrder = mirror.renderOrder + 0.5; // over the mirror, under what stands on it
  return sheet;
}

/** Lays over flat mirrors what they show; what it gives takes it away again. solids: the group of a scene's objects, each of
 *  them a child, after the lights'. */
export function flatMirrors(solids: Object3D, flat: readonly FlatMirror[], background: Vec3): () => void {
  const there = new PerspectiveCamera();
  const sheets = flat.map(({ object, share }) => {
    const mirror = solids.children[object + 1] as AnyMesh;
    const plane = planeOf(mirror);
    const target = new WebGLRenderTarget(1, 1);
    const sheet = sheetOver(mirror, share, background);
    const { uniforms } = sheet.material;
    uniforms.seen.value = target.texture;
    sheet.material.addEventListener("dispose", () => target.dispose());
    let drawnFrom = "";
    sheet.onBeforeRender = (renderer, world, camera) => {
      const { width, height } = renderer.domElement;
      const from = [...camera.matrixWorld.elements, ...(camera as PerspectiveCamera).projectionMatrix.elements, width, height].join();
      if (from === drawnFrom || !putAtImage(there, camera as PerspectiveCamera, plane)) return; // nothing moves but the eye
      drawnFrom = from;
      target.setSize(width, height);
      uniforms.size.value = [width, height];
      drawInto(target, renderer, world, there, solids, [mirror, ...sheets]);
    };
    return sheet;
  });
  for (const sheet of sheets) solids.add(sheet);
  return () => {
    for (const sheet of sheets) sheet.removeFromParent(), sheet.material.dispose();
  };
}
