/** Signs of a fixed size on screen: hit points and lamps, crosses where a light is blocked, struck rings for lamps that are off. */
import { BufferAttribute, BufferGeometry, Points, ShaderMaterial } from "three";
import { rgb } from "../palette";
import type { Vec3 } from "../state/vectors";

const VERTEX = `
attribute vec4 tint; // colour; 0: a dot, 1: a cross, 2: a struck ring
uniform float size, ratio;
varying vec4 vTint;
void main() {
  vTint = tint;
  gl_Position = projectionMatrix * viewMatrix * vec4(position, 1.0);
  gl_Position.z -= 0.0008 * gl_Position.w; // lies on the surface: come before it
  gl_PointSize = size * ratio;
}`;

const FRAGMENT = `
uniform float size, glow;
varying vec4 vTint;
void main() {
  vec2 from = (gl_PointCoord - 0.5) * size;
  float away = length(from);
  float disc = 0.5 * size * (1.0 - glow);
  if (vTint.w > 0.5) {
    vec2 arms = abs(vec2(from.x + from.y, from.x - from.y)) * 0.71;
    float stroke = vTint.w > 1.5 ? min(arms.x, abs(away - disc + 1.5)) : min(arms.x, arms.y);
    if (stroke > 2.8 || away > disc) discard;
    gl_FragColor = vec4(stroke > 1.5 ? vec3(0.05, 0.06, 0.08) : vTint.rgb, 1.0);
  } else if (glow > 0.0) {
    float halo = pow(max(0.0, 1.0 - away / (0.5 * size)), 2.0) * 0.5;
    float core = 1.0 - smoothstep(disc - 1.0, disc, away);
    gl_FragColor = vec4(vTint.rgb, max(core, halo));
  } else {
    if (away > disc) discard;
    gl_FragColor = vec4(away > disc - 1.2 ? vec3(0.05, 0.06, 0.08) : vTint.rgb, 1.0);
  }
}`;

export interface Dot {
  at: Vec3;
  colour: string; // #rrggbb
  sign?: 1 | 2; // a cross; a struck ring
  bright?: number; // share of its colour, 1 unless said
}

/** size: CSS pixels across. glow: share of the radius that is halo, 0 for a plain dot. */
export function createDots(size: number, glow = 0) {
  const geometry = new BufferGeometry();
  const material = new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    uniforms: { size: { value: size }, ratio: { value: 1 }, glow: { value: glow } },
    transparent: glow > 0,
    depthWrite: glow === 0,
  });
  const object = new Points(geometry, material);
  object.frustumCulled = false;
  object.renderOrder = 4;
  return {
    object,
    show(dots: readonly Dot[]) {
      geometry.dispose();
      geometry.setAttribute("position", new BufferAttribute(new Float32Array(dots.flatMap((dot) => [...dot.at])), 3));
      geometry.setAttribute("tint", new BufferAttribute(new Float32Array(dots.flatMap(({ colour, sign = 0, bright = 1 }) => [...rgb(colour).map((v) => v * bright), sign])), 4));
      object.visible = dots.length > 0;
    },
    /** Device pixels a CSS pixel. */
    resize(ratio: number) {
      material.uniforms.ratio.value = ratio;
    },
  };
}
