/** What the part `surroundings` takes of three: parts import modules of the viewer only. */
export { LinearFilter, ShaderMaterial, Texture } from "three";
