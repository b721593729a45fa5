/**
 * Empties three's shader texts that no material of ours includes. They are strings in one table, so
 * a bundler keeps them all; they are a tenth of the bundle. And the maker of blurred environment maps,
 * which three makes only for materials with such a map.
 */
const OUR_SHADERS = ["depth", "distance", "meshbasic", "meshmatcap", "meshphong"];

/** Parts that are wholly inside an #ifdef of a feature we never turn on. */
const UNUSED_PARTS =
  /physical|transmission|iridescence|clearcoat|cube_uv|toon|gradientmap|lambert|morph|skin|displacement|bumpmap|lightmap|aomap|envmap|batching|alphahash|lightprobes|tonemapping_pars|normalmap/;

/** A class at the start of a line, to its closing brace at the start of another. */
const ENVIRONMENT_BLUR = /^class PMREMGenerator \{[\s\S]*?^\}$/m;

/** three.module.js with the unused texts empty. */
export function withoutUnusedShaders(source) {
  const empty = new Set();
  for (const [, chunk, name] of source.matchAll(/^\t(\w+): ([\w$]+),?$/gm)) {
    const whole = chunk.match(/^(\w+)_(?:vert|frag)$/);
    if (whole ? !OUR_SHADERS.includes(whole[1]) : UNUSED_PARTS.test(chunk)) empty.add(name);
  }
  return source.replace(ENVIRONMENT_BLUR, "class PMREMGenerator { dispose() {} }").replace(/^((?:var|const) ([\w$]+) = )"(?:[^"\\]|\\.)*";$/gm, (text, declaration, name) =>
    empty.has(name) ? `${declaration}"";` : text,
  );
}
