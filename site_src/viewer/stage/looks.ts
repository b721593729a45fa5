/**
 * How surfaces look on the stage: matte (three's Phong), mirror and glass. The stage only
 * rasterises: what a mirror or a glass really shows is in the picture, brought by rays, so here
 * they get a painted look that says "mirror" and "glass" and claims no more.
 */
import { Color, DataTexture, FrontSide, LinearFilter, MeshMatcapMaterial, MeshPhongMaterial, type Material, type Side } from "three";
import { isClear, isMirror } from "../state/look";
import type { Part } from "../state/switches";
import type { MaterialData, Vec3 } from "../trace/types";

type Paints = Readonly<Record<string, Part>>;

const SIZE = 128; // pixels across a painted ball
type Paint = (x: number, y: number, z: number) => [number, number, number, number];

/** A ball painted by its outward direction (x right, y up, z to the viewer), as matcap shading wants it. */
function paintedBall(paint: Paint): DataTexture {
  const data = new Uint8Array(4 * SIZE * SIZE);
  for (let row = 0; row < SIZE; row++)
    for (let column = 0; column < SIZE; column++) {
      const x = ((column + 0.5) / SIZE) * 2 - 1;
      const y = ((row + 0.5) / SIZE) * 2 - 1;
      const rim = Math.max(1, Math.hypot(x, y));
      const z = Math.sqrt(Math.max(0, 1 - (x * x + y * y) / (rim * rim)));
      data.set(paint(x / rim, y / rim, z).map((v) => Math.round(255 * Math.min(1, Math.max(0, v)))), 4 * (row * SIZE + column));
    }
  const texture = new DataTexture(data, SIZE, SIZE);
  texture.magFilter = texture.minFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

const ramp = (from: number, to: number, at: number) => {
  const t = Math.min(1, Math.max(0, (at - from) / (to - from)));
  return t * t * (3 - 2 * t);
};

/** Chrome: a dark floor that lightens towards us, a soft horizon, a pale sky that deepens upwards,
 *  a small window of light. */
const chrome: Paint = (x, y, z) => {
  const sky = ramp(-0.12, 0.1, y + 0.05 * x);
  const above = 0.8 - 0.52 * ramp(0.05, 0.9, y);
  const below = 0.16 + 0.3 * ramp(-0.05, -0.85, y);
  const window = 0.5 * ramp(0.94, 1.0, -0.45 * x + 0.52 * y + 0.73 * z);
  const sheen = 0.16 * ramp(0.55, 1, -0.45 * x + 0.52 * y + 0.73 * z);
  const edge = 1 - 0.45 * (1 - z) ** 2.5;
  const shade = (warm: number, cold: number) => (below * warm * (1 - sky) + above * cold * sky) * edge + sheen + window;
  return [shade(0.95, 0.93), shade(1, 0.98), shade(1.08, 1.05), 1];
};

/** Glass: clear in the middle, pale at the rim, one sharp highlight and a softer one across from it. */
const clear: Paint = (x, y, z) => {
  const rim = (1 - z) ** 2.2;
  const glint = ramp(0.955, 0.985, -0.45 * x + 0.55 * y + 0.7 * z);
  const far = ramp(0.9, 1, 0.5 * x - 0.55 * y + 0.67 * z);
  return [0.72 + 0.28 * glint, 0.86 + 0.14 * glint, 0.93 + 0.07 * glint, 0.09 + 0.62 * rim + 0.85 * glint + 0.14 * far];
};

const colour = (v: Vec3) => new Color(v[0], v[1], v[2]);

/** three spreads a Blinn-Phong highlight's energy; course materials give its height instead. */
const highlight = (material: MaterialData) => colour(material.specular).multiplyScalar(4 / (material.shininess / 2 + 1));

export type Looks = ReturnType<typeof createLooks>;

/** plain: no mirror and no glass, every surface is matte in its own colour. */
export function createLooks(plain: boolean) {
  const balls = { chrome: paintedBall(chrome), clear: paintedBall(clear) };
  const made: { look: Material; paints: Paints; full?: number[][] }[] = [];
  /** paints: which of its colours stands for which part. */
  const keep = <M extends Material>(look: M, paints: Paints): M => (made.push({ look, paints }), look);

  function glass(side: Side, flat: boolean) {
    const look = keep(new MeshMatcapMaterial({ matcap: balls.clear, transparent: true, depthWrite: false, side, flatShading: flat }), { color: "refracted" });
    look.onBeforeCompile = (shader) => {
      shader.fragmentShader = shader.fragmentShader.replace(
        "#include <opaque_fragment>",
        "diffuseColor.a *= matcapColor.a;\n#include <opaque_fragment>",
      );
    };
    return look;
  }

  const seenThrough = (material: MaterialData) => !plain && isClear(material);
  return {
    /** Is it drawn as something to look through? */
    seenThrough,
    /** side: draw this one only. */
    of(material: MaterialData, side: Side = FrontSide, flat = false): Material {
      if (seenThrough(material)) return glass(side, flat);
      if (!plain && isMirror(material)) return keep(new MeshMatcapMaterial({ matcap: balls.chrome, side, flatShading: flat }), { color: "reflected" });
      return keep(
        new MeshPhongMaterial({
          color: colour(material.diffuse),
          emissive: colour(material.ambient),
          specular: highlight(material),
          shininess: material.shininess,
          side,
          flatShading: flat,
        }),
        { color: "diffuse", emissive: "ambient", specular: "specular" },
      );
    },
    /** Only these parts of the surfaces' colours count: what brings the others is black. */
    count(isOn: (part: Part) => boolean) {
      for (const each of made) {
        const colours = Object.entries(each.paints).map(([name, part]) => ({ part, colour: (each.look as unknown as Record<string, Color>)[name] }));
        each.full ??= colours.map(({ colour }) => colour.toArray()); // only now: walls have toned theirs down
        for (const [k, { part, colour }] of colours.entries()) colour.fromArray(each.full[k]).multiplyScalar(isOn(part) ? 1 : 0);
      }
    },
  };
}
