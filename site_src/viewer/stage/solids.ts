/** The scene's objects, lit by its lights. World units, +y up. */
import {
  AmbientLight,
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  CircleGeometry,
  CylinderGeometry,
  Group,
  Matrix4,
  Mesh,
  PointLight,
  SphereGeometry,
  type Material,
  type MeshMatcapMaterial,
} from "three";
import { meshOf } from "../state/mesh";
import { endsOf } from "../state/shapes";
import { drawsShadows } from "../state/look";
import { facesOf, isLamp, lampsApart, shadowMapOf } from "../state/shadow-map";
import type { Part, Switches } from "../state/switches";
import { scale } from "../state/vectors";
import type { ObjectData, SceneData } from "../trace/types";
import { createLooks } from "./looks";
import { surroundedLook } from "./surrounded";
import type { Surrounded } from "../state/surrounded";
import { createWall } from "./wall";

// Segments round a sphere: no corner shows at full screen. Of thousands, which are small there, as few
// as a graphics card draws at ease.
const roundOf = ({ objects }: SceneData) => Math.max(8, Math.min(64, 2 * Math.floor(400 / Math.sqrt(objects.length))));
const EVERYWHERE = 0.22 * Math.PI; // strength of the light that comes from all sides

const GEOMETRIES: Record<ObjectData["type"], (object: ObjectData, scene: SceneData) => BufferGeometry> = {
  sphere: (_, scene) => new SphereGeometry(1, roundOf(scene), roundOf(scene) / 2),
  cylinder: (object, scene) => {
    const [low, high] = endsOf(object);
    return new CylinderGeometry(high, low, 2, roundOf(scene), 1, object.open).rotateX(Math.PI / 2);
  },
  box: () => new BoxGeometry(2, 2, 2),
  disc: (_, scene) => new CircleGeometry(1, roundOf(scene)),
  plane: () => new BufferGeometry(), // a wall, made by itself
  triangle: () => {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]), 3));
    geometry.computeVertexNormals();
    return geometry;
  },
  mesh: ({ mesh }, { meshes }) => {
    const geometry = new BufferGeometry();
    const data = mesh ? meshes[mesh] : undefined;
    if (!data) return geometry;
    const { positions, normals, colours, indices } = meshOf(data);
    geometry.setAttribute("position", new BufferAttribute(positions, 3));
    geometry.setIndex(new BufferAttribute(indices, 1));
    if (normals) geometry.setAttribute("normal", new BufferAttribute(normals, 3));
    if (colours) geometry.setAttribute("color", new BufferAttribute(colours, 3, true));
    return geometry;
  },
};

function lightsOf(scene: SceneData, plain: boolean) {
  const group = new Group();
  const lamps: PointLight[] = [];
  // A little light from everywhere, so that shapes keep their form in the shade: the caption says so (panels/view-switch.ts).
  const everywhere = new AmbientLight(0xffffff, EVERYWHERE);
  group.add(everywhere);
  const every = lampsApart(scene);
  const map = shadowMapOf(scene);
  for (const { colour, attenuation } of scene.lights.filter((_, k) => isLamp(k, every))) {
    const near = Math.max(1e-6, attenuation[0]);
    const light = new PointLight(0xffffff, 1, attenuation[1] / near, attenuation[2] / near); // its place and strength: follow; slim/never.mjs says the rest
    light.color.setRGB(...scale(colour, 1 / near));
    light.castShadow = !plain && drawsShadows(scene);
    light.shadow.mapSize.set(map.pixels, map.pixels);
    light.shadow.camera.near = map.near;
    light.shadow.camera.far = map.far;
    light.shadow.bias = map.bias;
    light.shadow.normalBias = map.normalBias;
    lamps.push(light);
    group.add(light);
  }
  return { group, lamps, everywhere, every };
}

/** plain: each surface by itself, without shadows, mirrors or glass. */
export function createSolids(scene: SceneData, plain: boolean) {
  const object = new Group();
  const looks = createLooks(plain);
  const lights = lightsOf(scene, plain);
  const made = new Map<string, BufferGeometry>(); // one of each shape
  object.add(lights.group);
  const painted: { mesh: Mesh; look: Material; at: number }[] = [];
  let bare: (() => void) | undefined;
  for (const [at, each] of scene.objects.entries()) {
    const material = scene.materials[each.material];
    if (each.type === "plane") {
      object.add(createWall(each, scene, looks));
      continue;
    }
    const shape = each.mesh ?? each.type + each.open + each.tip;
    const geometry = made.get(shape) ?? GEOMETRIES[each.mesh ? "mesh" : each.type](each, scene);
    made.set(shape, geometry);
    const look = looks.of(material, facesOf(each, scene), !geometry.getAttribute("normal"));
    look.vertexColors = !!geometry.getAttribute("color");
    const mesh = new Mesh(geometry, look);
    mesh.castShadow = !looks.seenThrough(material);
    mesh.receiveShadow = true;
    if (looks.seenThrough(material)) mesh.renderOrder = 2;
    object.add(mesh);
    painted.push({ mesh, look, at });
  }
  return {
    object,
    /** Mirrors and glass show what is round them; null: they are painted. */
    surround(surroundings: Surrounded | null) {
      if (plain) return;
      bare?.();
      bare = surroundings?.onFlat(object as never);
      for (const { mesh, look, at } of painted) {
        if (mesh.material !== look) (mesh.material as Material).dispose();
        const around = surroundings?.lookOf(at, !mesh.geometry.getAttribute("normal"));
        mesh.material = around ? surroundedLook(around, look.side) : look;
        if (around) (look as MeshMatcapMaterial).matcap?.dispose(); // the painted ball is no longer held
      }
    },
    /** Things where they are at a stop of a sweep, lights and colours as the switches leave them. A light that is off stays,
     *  without strength: another number of lights or shadow maps would compile every shader anew. */
    follow(switched: SceneData, { without, bounces }: Switches) {
      const isOn = (part: Part) => !without.includes(part) && !(bounces === 0 && (part === "reflected" || part === "refracted"));
      for (const [k, lamp] of lights.lamps.entries()) {
        const { position, intensity } = switched.lights[k * lights.every + (lights.every >> 1)];
        lamp.position.set(...position);
        lamp.intensity = intensity * lights.every * Math.PI; // three divides by pi
        lamp.shadow.intensity = switched.shadows ? 1 : 0;
      }
      for (const { mesh, at } of painted) new Matrix4().fromArray([...switched.objects[at].transform]).decompose(mesh.position, mesh.quaternion, mesh.scale);
      lights.everywhere.intensity = isOn("ambient") ? EVERYWHERE : 0;
      looks.count(isOn);
    },
  };
}
