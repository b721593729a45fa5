/**
 * Mirrors and glass as the pipeline's surroundings show them (trace/surroundings.py says what they hold). For each pixel a
 * look-up says how far a ray turns at this angle, another what is seen that way: nothing is worked out but places in pictures.
 */
import type { Surrounded, SurroundedLook } from "../state/surrounded";
import type { Surroundings, SurroundingsData } from "../trace/types";
import { flatMirrors } from "./flat-mirrors";

const STEPS = 9; // towards what is seen from a place beside the centre, by how far things are
const CAREFUL = 0.6; // of each step: with all of it edges would swing to and fro
const FARTHEST = 60; // radii: what is farther, or nothing, lies as well there

const VERTEX = `
varying vec3 vWorld, vOut;
void main() {
  vec4 world = modelMatrix * vec4(position, 1.0);
  vWorld = world.xyz;
#ifndef FACES
  vOut = transpose(inverse(mat3(modelMatrix))) * normal;
#endif
  gl_Position = projectionMatrix * viewMatrix * world;
}`;

const FRAGMENT = `
uniform sampler2D around;
uniform vec4 turns[ROWS];
uniform vec3 centre;
uniform float radius;
varying vec3 vWorld, vOut;

vec4 towards(vec3 way) {
  way /= abs(way.x) + abs(way.y) + abs(way.z);
  vec2 at = way.xz;
  if (way.y < 0.0) at = (1.0 - abs(at.yx)) * mix(vec2(-1.0), vec2(1.0), step(0.0, at));
  return texture2D(around, 0.5 * at + 0.5);
}
float farTowards(vec3 way) { return min(${FARTHEST.toFixed(1)}, 1.0 / max(0.004, towards(way).a) - 1.0); }

vec3 seen(vec3 from, vec3 way) { // radii from the centre
  float gone = farTowards(way);
  for (int k = 0; k < ${STEPS}; k++) {
    vec3 at = from + gone * way;
    gone = max(0.0, gone + ${CAREFUL} * (farTowards(at) - length(at)));
  }
  return towards(from + gone * way).rgb;
}
vec3 aside(vec3 of, vec3 along, float by) { // what is left of a direction beside another one
  vec3 left = of + by * along;
  return left / max(1e-5, length(left));
}

void main() {
  vec3 way = normalize(vWorld - cameraPosition);
#ifdef FACES
  vec3 out_ = normalize(cross(dFdx(vWorld), dFdy(vWorld)));
#else
  vec3 out_ = normalize(vOut);
#endif
  if (dot(out_, way) > 0.0) out_ = -out_;
  float slant = -dot(out_, way);
  float row = slant * float(ROWS - 1);
  int low = min(int(row), ROWS - 2);
  vec4 turn = mix(turns[low], turns[low + 1], row - float(low));
  vec3 up = aside(out_, way, slant), on = aside(way, out_, slant);
  vec3 from = (vWorld - centre) / radius;
  vec3 colour = turn.y > 0.0 ? turn.y * seen(from, cos(turn.x) * way + sin(turn.x) * up) : vec3(0.0);
  if (turn.y < 1.0) {
    vec3 exit = from + length(from) * (turn.w == 0.0 ? vec3(0.0) : cos(turn.w) * out_ + sin(turn.w) * on - out_);
    colour += (1.0 - turn.y) * seen(exit, cos(turn.z) * way + sin(turn.z) * up);
  }
  gl_FragColor = vec4(colour, 1.0);
}`;

/** A look of one body, as three's materials are described; faces: it has no normals but its triangles' own. */
function lookOf({ centre, radius, turns }: Surroundings, picture: HTMLImageElement, faces: boolean): SurroundedLook {
  return {
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT.replaceAll("ROWS", String(turns.length)),
    defines: faces ? { FACES: 1 } : {},
    picture,
    uniforms: { turns: { value: turns.flat() }, centre: { value: centre }, radius: { value: radius } },
    isClear: turns.some(([, mirrored]) => mirrored < 1),
  };
}

async function pictureOf(uri: string): Promise<HTMLImageElement> {
  const image = new Image();
  image.src = uri;
  await image.decode();
  return image;
}

export function surroundingsFrom(json: unknown): SurroundingsData {
  const surroundings = json as SurroundingsData;
  if (surroundings?.format !== 2 || !surroundings.objects) throw new Error("not surroundings");
  return surroundings;
}

export async function createSurroundings({ scene, objects, flat, background }: SurroundingsData): Promise<Surrounded> {
  const pictures = await Promise.all(objects.map(({ picture }) => pictureOf(picture)));
  return {
    scene,
    onFlat: (solids) => flatMirrors(solids, flat, background),
    lookOf(object, faces) {
      const at = objects.findIndex((each) => each.object === object);
      return at < 0 ? null : lookOf(objects[at], pictures[at], faces);
    },
  };
}
