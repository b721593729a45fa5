/**
 * What of three the viewer never uses, listed by hand where names do not show it (constants.mjs and
 * members.mjs find the rest). Each rule says why, what is replaced by what in which file, and which names
 * in the viewer's script, if it ever holds one, bring the part back by themselves (`unless`).
 * A pattern that is not found stops the build: three has changed there, look again. pays.mjs
 * shows what each rule saves.
 */

const PHYSICAL = ["MeshStandardMaterial", "MeshPhysicalMaterial"];
const gone = (name) => `throw new Error("three: ${name} is not shipped, see site_src/slim/never.mjs");`;

/** The body of a function, by its name, at the indentation of its line. */
const emptied = (name, body = gone(name)) => [new RegExp(`^(\\t*)(function ${name}\\(.*\\) \\{)[\\s\\S]*?^\\1\\}`, "m"), `$1$2 ${body} }`];
const emptiedMethod = (name) => [new RegExp(`^\\t${name}\\(.*\\) \\{[\\s\\S]*?^\\t\\}`, "m"), `\t${name}() { ${gone(name)} }`];
const NO_MORPH = [/geometry\.morphAttributes\.position \|\| geometry\.morphAttributes\.normal \|\| geometry\.morphAttributes\.color/, "undefined"];

/** All that is stored beside what is drawn to a texture is its depths. */
const STORED_DEPTH = `
  _gl.bindRenderbuffer(_gl.RENDERBUFFER, renderbuffer);
  _gl.renderbufferStorage(_gl.RENDERBUFFER, _gl.DEPTH_COMPONENT24, renderTarget.width, renderTarget.height);
  _gl.framebufferRenderbuffer(_gl.FRAMEBUFFER, _gl.DEPTH_ATTACHMENT, _gl.RENDERBUFFER, renderbuffer);`;

export const RULES = [
  {
    why: "no headset",
    in: {
      "renderers/WebGLRenderer": [
        [/const xr = new WebXRManager\(.*\);/, ""],
        [/this\.xr = xr;/, "this.xr = { enabled: false, isPresenting: false };"],
        [/xr\.(dispose|addEventListener|removeEventListener|setAnimationLoop)\(.*\);/g, ""],
        [/xr\.enabled === true && xr\.isPresenting === true/g, "false"],
        [/_renderBackground = xr\.enabled === false.*;/, "_renderBackground = true;"],
        [/_frustumArray = new FrustumArray\(\)/, "_frustumArray = null"],
        [/camera\.isArrayCamera/g, "false"],
      ],
      "renderers/webgl/WebGLBackground": [[/renderer\.xr\.getEnvironmentBlendMode\(\)/, "'opaque'"]],
    },
  },
  {
    why: "the page is the background",
    in: { "renderers/webgl/WebGLBackground": [emptied("addToRenderList", `if ( getBackground( scene )?.isTexture ) ${gone("a background texture")}`), emptied("dispose", "")] },
  },
  {
    why: "frames are drawn on demand, to the canvas as it is",
    in: {
      "renderers/WebGLRenderer": [
        [/if \( _outputBufferType !== UnsignedByteType \) \{[\s\S]*?\n\t\t\}/, ""],
        [/const animation = new WebGLAnimation\(\);\s*animation\.setAnimationLoop.*\s*if \( typeof self.*/, ""],
        [/(\( callback === null \) \? animation\.stop\(\) : )?animation\.(start|stop)\(\);\n/g, "\n"],
      ],
    },
  },
  {
    why: "no blocks of uniforms",
    unless: ["uniformsGroups", "UniformsGroup"],
    in: {
      "renderers/WebGLRenderer": [
        [/uniformsGroups = new WebGLUniformsGroups\(.*\);/, ""],
        [/uniformsGroups\.dispose\(\);/, ""],
        [/if \( material\.uniformsGroups !== undefined \) \{[\s\S]*?\n\t\t\t\}\n/, ""],
      ],
    },
  },
  {
    why: "no shape changes",
    unless: ["morphAttributes"],
    in: {
      "renderers/WebGLRenderer": [
        [/morphtargets = new WebGLMorphtargets\(.*\);/, ""],
        [/if \( morphAttributes\.position !== undefined [\s\S]*?\n\t\t\t\}\n/, ""],
        NO_MORPH,
      ],
      "renderers/webgl/WebGLPrograms": [[/geometry\.morphAttributes\.(position|normal|color) !== undefined/g, "false"], NO_MORPH],
      ...Object.fromEntries(["Line", "Mesh", "Points"].map((thing) => [`objects/${thing}`, [[/updateMorphTargets\(\) \{[\s\S]*?\n\t\}/, "updateMorphTargets() {}"]]])),
    },
  },
  {
    why: "no light passes through a thing on the stage but by a shader of ours",
    unless: PHYSICAL,
    in: { "renderers/WebGLRenderer": [[/transmissiveObjects\.length > 0/g, "false"], [/m_uniforms\.dfgLUT\.value = getDFGLUT\(\);/, ""]] },
  },
  {
    why: "an environment is a cube of a render target or none",
    unless: [...PHYSICAL, "EquirectangularReflectionMapping", "EquirectangularRefractionMapping"],
    in: { "renderers/webgl/WebGLEnvironments": [emptied("getCube", "return texture;"), emptied("getPMREM")] },
  },
  {
    why: "colours are display values",
    unless: ["toneMapping"],
    in: { "renderers/webgl/WebGLProgram": [[/\( parameters\.toneMapping !== NoToneMapping \)/g, "( false )"]] },
  },
  {
    why: "asking for a shader's errors waits for the compiler; take this rule out to see them",
    unless: ["getProgramInfoLog"],
    in: { "renderers/webgl/WebGLProgram": [[/renderer\.debug\.checkShaderErrors/, "false"]] },
  },
  {
    why: "shadows of lamps only, with hard or filtered edges",
    unless: ["VSMShadowMap"],
    in: { "renderers/webgl/WebGLShadowMap": [[/(this\.)?type === VSMShadowMap/g, "false"], [/const shadowMaterialVertical = [\s\S]*?const fullScreenMesh = .*/, ""]] },
  },
  {
    // optics/shade.py: a / (a0 + a1 d + a2 d^2). A lamp's colour is divided by a0, and its fields that three calls cutoff
    // distance and exponent hold a1 / a0 and a2 / a0 (stage/solids.ts).
    why: "light weakens with distance as the tracer has it",
    in: {
      "renderers/shaders/ShaderChunk/lights_pars_begin.glsl": [[/float distanceFalloff = [\s\S]*?return distanceFalloff;/, "return 1.0 / ( 1.0 + cutoffDistance * lightDistance + decayExponent * lightDistance * lightDistance );"]],
      "renderers/webgl/WebGLShadowMap": [[/light\.distance \|\| camera\.far/, "camera.far"]],
    },
  },
  {
    why: "textures are made of plain numbers",
    in: { "renderers/webgl/WebGLUtils": [[/if \( p === RGB_S3TC_DXT1_Format[\s\S]*?(?=if \( p === UnsignedInt248Type)/, ""]] },
  },
  {
    why: "uniforms are signed numbers and flat pictures: no volumes, no stacks",
    unless: ["Data3DTexture", "DataArrayTexture"],
    in: {
      "renderers/webgl/WebGLUniforms": [
        [/const empty(Array|3d)Texture = .*/g, ""],
        [/case 0x\w+: return setValueV\dui(Array)?;.*/g, ""],
        ...["setValueT3D1", "setValueT2DArray1", "setValueT3DArray", "setValueT2DArrayArray"].map((name) => emptied(name)),
      ],
    },
  },
  {
    why: "what is drawn to textures has neither smoothed edges nor smaller copies",
    unless: ["samples"],
    in: {
      "renderers/webgl/WebGLTextures": [
        ...["updateMultisampleRenderTarget", "updateRenderTargetMipmap"].map((name) => emptied(name, "")),
        emptied("rebindTextures"),
        emptied("setupRenderBufferStorage", STORED_DEPTH),
      ],
    },
  },
  {
    why: "nobody else draws with the context",
    unless: ["resetState"],
    in: { "renderers/webgl/WebGLState": [emptied("reset")] },
  },
  {
    why: "nothing is turned by Euler's angles",
    unless: ["rotation", "envMap"],
    in: { "math/Matrix4": [emptiedMethod("makeRotationFromEuler")], "math/Quaternion": [emptiedMethod("setFromEuler")] },
  },
  {
    why: "colours are numbers or #rrggbb",
    in: { "math/Color": [[/const _colorKeywords = \{[\s\S]*?\};/, "const _colorKeywords = {};"], [/if \( m = \/\^\(\\w[\s\S]*? else (?=if \( m = \/\^\\#)/, ""]] },
  },
  {
    why: "nothing on the stage is a copy of another",
    unless: ["clone"],
    inAll: /^(core|objects|scenes|lights|cameras|geometries|materials|textures)\//,
    change: [/^\tcopy\( source.*\) \{[\s\S]*?^\t\}/gm, `\tcopy() { ${gone("copying")} }`],
  },
];

const LIBRARY = "renderers/shaders/ShaderLib";
const ALWAYS = ["basic", "depth", "distance"]; // lines, and what casts a shadow

/** ShaderLib's entries for the materials that the viewer names. */
function withoutShaders(source, names) {
  const isPhysical = PHYSICAL.some((each) => names.has(each));
  const isUsed = (shader) => ALWAYS.includes(shader) || (shader === "standard" && isPhysical) || [...names].some((name) => new RegExp(`^(Mesh|Line)?${shader}Material$`, "i").test(name));
  const kept = replaced(source, [/^\t(\w+): \{[\s\S]*?^\t\},?\n/gm, (entry, shader) => (isUsed(shader) ? entry : "")], LIBRARY);
  return isPhysical ? kept : replaced(kept, [/^ShaderLib\.physical = \{[\s\S]*?^\};/m, ""], LIBRARY);
}

function replaced(source, [pattern, text], file) {
  const after = source.replace(pattern, text);
  if (after === source) throw new Error(`three's ${file}.js no longer holds ${pattern}: see site_src/slim/never.mjs`);
  return after;
}

/** A file of three without what is never used. names: all that the viewer's script names. without: a rule to be left out. */
export function withoutUnusedParts(path, source, names, without = "") {
  const file = /\/three\/src\/(.*)\.js$/.exec(path.replaceAll("\\", "/"))?.[1];
  if (!file) return source;
  let kept = file === LIBRARY && without !== "shader library" ? withoutShaders(source, names) : source;
  for (const { why, unless = [], in: files = {}, inAll, change } of RULES) {
    if (why === without || unless.some((name) => names.has(name))) continue;
    for (const each of files[file] ?? []) kept = replaced(kept, each, file);
    if (inAll?.test(file)) kept = kept.replace(...change);
  }
  return kept;
}

/** Macros that are 0 or not defined, and what would bring them in. The stage has lamps, light from everywhere, no other lights. */
const MACROS = [
  [/^NUM_(SUN|DIR)_LIGHT/, ["DirectionalLight"]],
  [/^NUM_SPOT_LIGHT/, ["SpotLight"]],
  [/^NUM_RECT_AREA_LIGHT/, ["RectAreaLight"]],
  [/^NUM_HEMI_LIGHT/, ["HemisphereLight"]],
  [/LIGHT_PROBE/, ["LightProbe"]],
  [/^USE_(REVERSED|LOGARITHMIC)_DEPTH_BUFFER$/, ["reversedDepthBuffer", "logarithmicDepthBuffer"]],
  [/^SHADOWMAP_TYPE_VSM$/, ["VSMShadowMap"]],
  [/^SHADOWMAP_TYPE_BASIC$/, ["BasicShadowMap"]],
  [/^(ENVMAP_TYPE_PMREM|USE_ANISOTROPY|STANDARD|PHYSICAL)$/, PHYSICAL],
  [/^(USE_FOG|FOG_EXP2)$/, ["Fog", "FogExp2"]],
];
export const isNever = (macro, names) => MACROS.some(([pattern, unless]) => pattern.test(macro) && !unless.some((name) => names.has(name)));
