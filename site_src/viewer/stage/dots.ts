/** Round dots of a fixed size on screen: hit points and lamps. */
import { BufferAttribute, BufferGeometry, Points, ShaderMaterial } from "three";
import { rgb } from "../palette";
import type { Vec3 } from "../state/vectors";

const VERTEX = `
attribute vec3 tint;
uniform float size, ratio;
varying vec3 vTint;
void main() {
  vTint = tint;
  gl_Position = projectionMatrix * viewMatrix * vec4(position, 1.0);
  gl_Position.z -= 0.0008 * gl_Position.w; // lies on the surface: come before it
  gl_PointSize = size * ratio;
}`;

const FRAGMENT = `
uniform float size, glow;
varying vec3 vTint;
void main() {
  float away = length(gl_PointCoord - 0.5) * size;
  float disc = 0.5 * size * (1.0 - glow);
  if (glow > 0.0) {
    float halo = pow(max(0.0, 1.0 - away / (0.5 * size)), 2.0) * 0.5;
    float core = 1.0 - smoothstep(disc - 1.0, disc, away);
    gl_FragColor = vec4(vTint, max(core, halo));
  } else {
    if (away > disc) discard;
    gl_FragColor = vec4(away > disc - 1.2 ? vec3(0.05, 0.06, 0.08) : vTint, 1.0);
  }
}`;

export interface Dot {
  at: Vec3;
  colour: string; // #rrggbb
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
      geometry.setAttribute("tint", new BufferAttribute(new Float32Array(dots.flatMap((dot) => rgb(dot.colour))), 3));
      object.visible = dots.length > 0;
    },
    /** Device pixels a CSS pixel. */
    resize(ratio: number) {
      material.uniforms.ratio.value = ratio;
    },
    dispose() {
      geometry.dispose();
      material.dispose();
    },
  };
}
