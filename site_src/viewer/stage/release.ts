/** Gives back what the graphics card keeps for a world: geometries, materials with their textures, shadow maps. */
import { DataTexture, PointLight, type BufferGeometry, type IUniform, type Material, type Object3D } from "three";

type Drawn = Object3D & { geometry?: BufferGeometry; material?: Material & { uniforms?: Readonly<Record<string, IUniform>> } };

export function release(world: Object3D) {
  world.traverse((each: Drawn) => {
    const { geometry, material } = each;
    geometry?.dispose();
    material?.dispose();
    const values = Object.values(material ?? {});
    for (const value of [...values, ...Object.values(material?.uniforms ?? {}).map((uniform) => uniform.value)]) if (value instanceof DataTexture) value.dispose();
    if (each instanceof PointLight) each.dispose();
  });
}
