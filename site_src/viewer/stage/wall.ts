/** An endless plane, drawn as far as the scene reaches and then fading out. */
import { BufferAttribute, BufferGeometry, DataTexture, FrontSide, LinearFilter, Mesh, NearestFilter, Plane, RepeatWrapping, Vector3, type MagnificationTextureFilter, type MeshPhongMaterial } from "three";
import { STAGE } from "../palette";
import { dot, sub } from "../state/vectors";
import type { ObjectData, SceneData } from "../trace/types";
import type { Looks } from "./looks";
import { otherWalls, wallSheet, type WallSheet } from "./wall-sheet";

function again(texture: DataTexture, filter: MagnificationTextureFilter): DataTexture {
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.magFilter = texture.minFilter = filter;
  texture.needsUpdate = true;
  return texture;
}

function checkerTexture(object: ObjectData, scene: SceneData): DataTexture {
  const [a, b] = [object.material, object.checker!.material].map((k) =>
    [...scene.materials[k].diffuse.map((v, c) => Math.round(255 * v * STAGE.wall[c])), 255],
  );
  return again(new DataTexture(new Uint8Array([...a, ...b, ...b, ...a]), 2, 2), NearestFilter);
}

/** A plane's small picture, again and again. */
function tileTexture({ width, pixels }: NonNullable<ObjectData["tile"]>): DataTexture {
  const bytes = atob(pixels);
  const data = Uint8Array.from({ length: (bytes.length / 3) * 4 }, (_, k) => (k % 4 === 3 ? 255 : bytes.charCodeAt((k >> 2) * 3 + (k % 4))));
  return again(new DataTexture(data, width, bytes.length / 3 / width), LinearFilter);
}

function geometryOf({ at, facing }: WallSheet, { checker, tile }: ObjectData): BufferGeometry {
  const spread = [[-1, -1], [1, -1], [1, 1], [-1, 1]] as const;
  const corners = spread.map(([u, v]) => at(u, v));
  const geometry = new BufferGeometry();
  const put = (name: string, values: number[], size: number) => geometry.setAttribute(name, new BufferAttribute(new Float32Array(values), size));
  put("position", corners.flat(), 3);
  put("normal", corners.flatMap(() => [...facing]), 3);
  put("spread", spread.flat(), 2);
  if (checker) put("uv", corners.flatMap((corner) => checker.axes.map((axis) => dot(sub(corner, checker.origin), axis) / (2 * checker.size))), 2);
  if (tile) put("uv", corners.flatMap((corner) => tile.axes.map((axis) => dot(sub(corner, tile.origin), axis))), 2);
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  return geometry;
}

export function createWall(object: ObjectData, scene: SceneData, looks: Looks): Mesh {
  const look = looks.of(scene.materials[object.material], FrontSide) as MeshPhongMaterial;
  look.color.setRGB(look.color.r * STAGE.wall[0], look.color.g * STAGE.wall[1], look.color.b * STAGE.wall[2]);
  look.emissive?.multiplyScalar(STAGE.wallGlow); // a mirror or glass wall has neither
  look.specular?.multiplyScalar(0.4);
  if (object.checker) {
    look.map = checkerTexture(object, scene);
    look.color.set(0xffffff);
  }
  if (object.tile) look.map = tileTexture(object.tile);
  look.transparent = true;
  // What lies behind another wall is not drawn: only the half of space on the eye's side of each is.
  look.clippingPlanes = otherWalls(object, scene).map(({ point, facing }) => new Plane(new Vector3(...facing), 1e-4 - dot(facing, point)));
  look.onBeforeCompile = (shader) => {
    shader.vertexShader = shader.vertexShader
      .replace("void main() {", "attribute vec2 spread;\nvarying vec2 vSpread;\nvoid main() {\nvSpread = spread;");
    shader.fragmentShader = shader.fragmentShader
      .replace("void main() {", "varying vec2 vSpread;\nvoid main() {")
      .replace("#include <opaque_fragment>", "diffuseColor.a *= 1.0 - smoothstep(0.6, 1.0, length(vSpread));\n#include <opaque_fragment>");
  };
  const mesh = new Mesh(geometryOf(wallSheet(object, scene), object), look);
  mesh.receiveShadow = true;
  mesh.renderOrder = -1; // before everything: it is see-through at its edge
  return mesh;
}
