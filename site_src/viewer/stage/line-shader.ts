/**
 * Lines of a given width in screen pixels, dashed in screen pixels, with arrow heads. One instance a
 * line. The vertex shader divides by w itself, so that lengths along a line are screen lengths.
 */
import { Color, ShaderMaterial, Vector2, type ShaderMaterialParameters } from "three";
import { STAGE } from "../palette";

const VERTEX = `
attribute vec3 lineFrom, lineTo, tint;
attribute float worth; // of width and opacity
attribute vec4 style; // drawn and gap in pixels; 1 if the line is lit up; times as wide as others
uniform vec2 stage;   // pixels
uniform float width, around; // of a casing on both sides of its line
varying vec3 vTint;
varying vec2 vDash;
varying float vLit, vAlong, vWorth;

vec4 inFront(vec4 a, vec4 b) { // the part before the near plane
  float da = a.z + a.w, db = b.z + b.w;
  return da > 0.0 ? a : mix(a, b, (1e-4 - da) / (db - da));
}

void main() {
  vec4 a = projectionMatrix * viewMatrix * vec4(lineFrom, 1.0);
  vec4 b = projectionMatrix * viewMatrix * vec4(lineTo, 1.0);
  if (a.z + a.w <= 0.0 && b.z + b.w <= 0.0) { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); return; }
  vec4 front = inFront(a, b);
  b = inFront(b, a);
  vec3 p = front.xyz / front.w, q = b.xyz / b.w;
  vec2 run = (q.xy - p.xy) * stage * 0.5;
  float span = length(run);
  vec2 ahead = span > 0.0 ? run / span : vec2(1.0, 0.0);
  vec2 aside = vec2(-ahead.y, ahead.x);
#ifdef ARROW
  float size = span < 3.0 * width ? 0.0 : width * (0.3 + 0.7 * worth) * (1.0 + 0.3 * style.z) * sqrt(style.w);
  vec3 at = mix(p, q, 0.56);
  at.xy += (ahead * position.x + aside * position.y) * size * 2.0 / stage;
#else
  vec3 at = mix(p, q, position.x);
  at.xy += aside * position.y * (width * worth * (1.0 + 0.6 * style.z) * style.w + around) / stage;
#endif
  vTint = tint;
  vDash = style.xy;
  vLit = style.z;
  vWorth = worth;
  vAlong = position.x * span;
  gl_Position = vec4(at, 1.0);
}`;

const FRAGMENT = `
uniform float opacity;
uniform vec3 casing;
varying vec3 vTint;
varying vec2 vDash;
varying float vLit, vAlong, vWorth;
void main() {
#ifdef CASING
  gl_FragColor = vec4(casing, opacity * vWorth);
  return;
#endif
#ifndef ARROW
  if (mod(vAlong, vDash.x + vDash.y) > vDash.x) discard;
#endif
  gl_FragColor = vec4(mix(vTint, vec3(1.0), 0.25 * vLit), opacity * vWorth);
}`;

/** width: of the line, or of its arrow head, in CSS pixels. */
export function createLineMaterial(kind: "line" | "arrow" | "casing", width: number, opacity: number, more: ShaderMaterialParameters = {}) {
  return new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    defines: { arrow: { ARROW: 1 }, casing: { CASING: 1 }, line: {} }[kind],
    uniforms: { stage: { value: new Vector2(1, 1) }, width: { value: width }, around: { value: kind === "casing" ? 4 : 0 }, casing: { value: new Color(STAGE.casing) }, opacity: { value: opacity } },
    transparent: true, // drawn with the see-through things, that is after the walls
    depthWrite: false,
    side: 2,
    ...more,
  });
}
