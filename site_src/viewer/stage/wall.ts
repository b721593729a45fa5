/** An endless plane, drawn as far as the scene reaches and then fading out. */
import {
  BufferAttribute,
  BufferGeometry,
  DataTexture,
  FrontSide,
  Mesh,
  NearestFilter,
  Plane,
  RepeatWrapping,
  Vector3,
  type MeshPhongMaterial,
} from "three";
import { STAGE } from "../palette";
import { planeOf } from "../state/placing";
import { add, cross, dot, scale, sub, unit, type Vec3 } from "../state/vectors";
import type { ObjectData, SceneData } from "../trace/types";
import type { Looks } from "./looks";

const REACH = 2.1; // of the scene's radius
type Side = { point: Vec3; normal: Vec3 };

/** The half of space on the eye's side: what lies behind another wall is not drawn. */
function eyeSide({ point, normal }: Side, eye: Vec3): Plane {
  const facing = dot(sub(eye, point), normal) < 0 ? scale(normal, -1) : normal;
  return new Plane(new Vector3(...facing), 1e-4 - dot(facing, point));
}

function checkerTexture(object: ObjectData, scene: SceneData): DataTexture {
  const [a, b] = [object.material, object.checker!.material].map((k) =>
    [...scene.materials[k].diffuse.map((v, c) => Math.round(255 * v * STAGE.wall[c])), 255],
  );
  const texture = new DataTexture(new Uint8Array([...a, ...b, ...b, ...a]), 2, 2);
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.magFilter = texture.minFilter = NearestFilter;
  texture.needsUpdate = true;
  return texture;
}

export function createWall(object: ObjectData, scene: SceneData, looks: Looks, others: Side[]): Mesh {
  const { point, normal } = planeOf(object);
  const { eye } = scene.camera;
  const facing = dot(sub(eye, point), normal) < 0 ? scale(normal, -1) : normal;
  const { center, radius } = scene.bounds;
  const reach = REACH * radius;
  const middle = sub(center, scale(normal, dot(sub(center, point), normal)));
  const across = unit(cross(Math.abs(facing[1]) < 0.9 ? [0, 1, 0] : [0, 0, 1], facing));
  const down = cross(facing, across);
  const at = (u: number, v: number) => add(middle, add(scale(across, u * reach), scale(down, v * reach)));
  const corners = [at(-1, -1), at(1, -1), at(1, 1), at(-1, 1)];

  const geometry = new BufferGeometry();
  const floats = (values: number[], size: number) => new BufferAttribute(new Float32Array(values), size);
  geometry.setAttribute("position", floats(corners.flat(), 3));
  geometry.setAttribute("normal", floats(corners.flatMap(() => [...facing]), 3));
  geometry.setAttribute("spread", floats([-1, -1, 1, -1, 1, 1, -1, 1], 2));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);

  const look = looks.of(scene.materials[object.material], FrontSide) as MeshPhongMaterial;
  look.color.setRGB(look.color.r * STAGE.wall[0], look.color.g * STAGE.wall[1], look.color.b * STAGE.wall[2]);
  look.emissive?.multiplyScalar(0.6); // a mirror or glass wall has neither
  look.specular?.multiplyScalar(0.4);
  const { checker } = object;
  if (checker) {
    const share = (corner: Vec3, axis: Vec3) => dot(sub(corner, checker.origin), axis) / (2 * checker.size);
    geometry.setAttribute("uv", floats(corners.flatMap((c) => checker.axes.map((axis) => share(c, axis))), 2));
    look.map = checkerTexture(object, scene);
    look.color.set(0xffffff);
  }
  look.transparent = true;
  look.clippingPlanes = others.map((other) => eyeSide(other, eye));
  look.onBeforeCompile = (shader) => {
    shader.vertexShader = shader.vertexShader
      .replace("void main() {", "attribute vec2 spread;\nvarying vec2 vSpread;\nvoid main() {\nvSpread = spread;");
    shader.fragmentShader = shader.fragmentShader
      .replace("void main() {", "varying vec2 vSpread;\nvoid main() {")
      .replace("#include <opaque_fragment>", "diffuseColor.a *= 1.0 - smoothstep(0.6, 1.0, length(vSpread));\n#include <opaque_fragment>");
  };
  const mesh = new Mesh(geometry, look);
  mesh.receiveShadow = true;
  mesh.renderOrder = -1; // before everything: it is see-through at its edge
  return mesh;
}
