/** A material that shows what a body has round it, out of what the part `surroundings` says of it. */
import { LinearFilter, Mesh, PerspectiveCamera, ShaderMaterial, Texture, WebGLRenderTarget, type Side } from "three";
import type { SurroundedLook } from "../state/surrounded";

// For parts, which bundle nothing of three.
export { Mesh, PerspectiveCamera, ShaderMaterial, WebGLRenderTarget };

export function surroundedLook({ picture, uniforms, isClear, ...shaders }: SurroundedLook, side: Side): ShaderMaterial {
  const around = new Texture(picture);
  around.magFilter = around.minFilter = LinearFilter;
  around.generateMipmaps = around.flipY = false;
  around.needsUpdate = true;
  const look = new ShaderMaterial({ ...shaders, uniforms: { ...uniforms, around: { value: around } }, side });
  look.transparent = true; // after the walls, and before the rays that go through it
  look.depthWrite = !isClear;
  look.addEventListener("dispose", () => around.dispose());
  return look;
}
