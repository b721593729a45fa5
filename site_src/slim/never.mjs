/**
 * What of three the viewer never uses, told by hand where names do not tell it (constants.mjs and
 * members.mjs find the rest). Each entry says in which file, what is replaced by what, and which names
 * in the viewer's script, if it ever holds one, bring the part back by themselves (`unless`).
 * A pattern that is not found stops the build: three has changed there, look again.
 */

const NO_XR = "no headset";
const NO_MORPH = "no shape changes";
const PHYSICAL = ["MeshStandardMaterial", "MeshPhysicalMaterial"];
const gone = (name) => `throw new Error("three: ${name} is not shipped, see site_src/slim/never.mjs");`;

/** The body of a function, by its name, at the indentation of its line. */
const bodyOf = (name) => new RegExp(`^(\\t*)(function ${name}\\(.*\\) \\{)[\\s\\S]*?^\\1\\}`, "m");
const emptied = (name, body = gone(name)) => [bodyOf(name), `$1$2 ${body} }`];

const PARTS = [
  {
    file: "renderers/WebGLRenderer.js",
    why: NO_XR,
    changes: [
      [/const xr = new WebXRManager\(.*\);/, ""],
      [/this\.xr = xr;/, "this.xr = { enabled: false, isPresenting: false };"],
      [/xr\.(dispose|addEventListener|removeEventListener|setAnimationLoop)\(.*\);/g, ""],
      [/if \( xr\.enabled === true && xr\.isPresenting === true && .*\{[\s\S]*?\n\t\t\t\}\n/, ""],
      [/if \( xr\.enabled === true && xr\.isPresenting === true \) \{[\s\S]*?\n\t\t\t\}\n/, ""],
      [/_renderBackground = xr\.enabled === false.*;/, "_renderBackground = true;"],
      [/xr\.enabled === true && xr\.isPresenting === true/g, "false"],
      [/xr\.isPresenting/g, "false"],
      [/_frustumArray = new FrustumArray\(\)/, "_frustumArray = null"],
      [/camera\.isArrayCamera/g, "false"],
    ],
  },
  { file: "renderers/webgl/WebGLBackground.js", why: NO_XR, changes: [[/renderer\.xr\.getEnvironmentBlendMode\(\)/, "'opaque'"]] },
  {
    file: "renderers/webgl/WebGLBackground.js",
    why: "the page is the background",
    changes: [emptied("addToRenderList", `if ( getBackground( scene )?.isTexture ) ${gone("a background texture")}`)],
  },
  {
    file: "renderers/webgl/WebGLBackground.js",
    why: "the page is the background",
    changes: [[/environments\.get\( background, usePMREM \)/, "background"], emptied("dispose", "")],
  },
  {
    file: "renderers/WebGLRenderer.js",
    why: "frames are drawn on demand, to the canvas as it is",
    changes: [
      [/if \( _outputBufferType !== UnsignedByteType \) \{[\s\S]*?\n\t\t\}/, ""],
      [/const animation = new WebGLAnimation\(\);\s*animation\.setAnimationLoop.*\s*if \( typeof self.*/, ""],
      [/animation\.stop\(\);\n/g, "\n"],
      [/animation\.start\(\);\n/g, "\n"],
      [/\( callback === null \) \? animation\.stop\(\) : /, ""],
    ],
  },
  {
    file: "renderers/WebGLRenderer.js",
    why: "no blocks of uniforms",
    unless: ["uniformsGroups", "UniformsGroup"],
    changes: [
      [/uniformsGroups = new WebGLUniformsGroups\(.*\);/, ""],
      [/uniformsGroups\.dispose\(\);/, ""],
      [/if \( material\.uniformsGroups !== undefined \) \{[\s\S]*?\n\t\t\t\}\n/, ""],
    ],
  },
  {
    file: "renderers/WebGLRenderer.js",
    why: NO_MORPH,
    unless: ["morphAttributes"],
    changes: [
      [/morphtargets = new WebGLMorphtargets\(.*\);/, ""],
      [/if \( morphAttributes\.position !== undefined [\s\S]*?\n\t\t\t\}\n/, ""],
      [/!! geometry\.morphAttributes\.(position|normal|color)/g, "false"],
      [/geometry\.morphAttributes\.position \|\| geometry\.morphAttributes\.normal \|\| geometry\.morphAttributes\.color/, "undefined"],
    ],
  },
  {
    file: "renderers/webgl/WebGLPrograms.js",
    why: NO_MORPH,
    unless: ["morphAttributes"],
    changes: [
      [/geometry\.morphAttributes\.(position|normal|color) !== undefined/g, "false"],
      [/geometry\.morphAttributes\.position \|\| geometry\.morphAttributes\.normal \|\| geometry\.morphAttributes\.color/, "undefined"],
    ],
  },
  {
    file: "core/BufferGeometry.js",
    why: NO_MORPH,
    unless: ["morphAttributes"],
    changes: [[/const morphAttributesPosition = this\.morphAttributes\.position;/g, "const morphAttributesPosition = undefined;"]],
  },
  ...["Line", "Mesh", "Points"].map((thing) => ({
    file: `objects/${thing}.js`,
    why: NO_MORPH,
    unless: ["morphAttributes"],
    changes: [[/updateMorphTargets\(\) \{[\s\S]*?\n\t\}/, "updateMorphTargets() {}"]],
  })),
  {
    file: "renderers/WebGLRenderer.js",
    why: "no light passes through a thing on the stage but by a shader of ours",
    unless: PHYSICAL,
    changes: [
      [/transmissiveObjects\.length > 0/g, "false"],
      emptied("renderTransmissionPass"),
      [/m_uniforms\.dfgLUT\.value = getDFGLUT\(\);/, ""],
    ],
  },
  {
    file: "renderers/webgl/WebGLEnvironments.js",
    why: "an environment is a cube of a render target or none",
    unless: [...PHYSICAL, "EquirectangularReflectionMapping", "EquirectangularRefractionMapping"],
    changes: [emptied("getCube", "return texture;"), emptied("getPMREM"), emptied("dispose", "")],
  },
  { file: "renderers/WebGLRenderer.js", why: "no grid of light probes", changes: [[/countLightProbeGrids\( current.* \)(?=;| \))/g, "0"], [/materialProperties\.numLightProbeGrids > 0/, "false"]] },
  { file: "renderers/webgl/WebGLPrograms.js", why: "no grid of light probes", changes: [[/lightProbeGrids\.filter\(.*\)\.length/, "0"]] },
  {
    file: "renderers/webgl/WebGLPrograms.js",
    why: "colours are display values",
    unless: ["toneMapping"],
    changes: [[/toneMapping = renderer\.toneMapping;/, ""]],
  },
  { file: "renderers/webgl/WebGLProgram.js", why: "colours are display values", unless: ["toneMapping"], changes: [[/\( parameters\.toneMapping !== NoToneMapping \)/g, "( false )"]] },
  {
    file: "renderers/webgl/WebGLProgram.js",
    why: "asking for a shader's errors waits for the compiler; take this entry out to see them",
    unless: ["getProgramInfoLog"],
    changes: [[/renderer\.debug\.checkShaderErrors/, "false"]],
  },
  {
    file: "renderers/webgl/WebGLShadowMap.js",
    why: "shadows of lamps only, with hard or filtered edges",
    unless: ["VSMShadowMap"],
    changes: [[/(this\.)?type === VSMShadowMap/g, "false"], emptied("VSMPass"), [/const shadowMaterialVertical = [\s\S]*?const fullScreenMesh = .*/, ""]],
  },
  {
    file: "renderers/webgl/WebGLUtils.js",
    why: "textures are made of plain numbers",
    changes: [[/if \( p === RGB_S3TC_DXT1_Format[\s\S]*?(?=if \( p === UnsignedInt248Type)/, ""]],
  },
  {
    file: "renderers/webgl/WebGLUniforms.js",
    why: "no volumes, no stacks of pictures",
    unless: ["Data3DTexture", "DataArrayTexture"],
    changes: [
      [/const empty(Array|3d)Texture = .*/g, ""],
      ...["setValueT3D1", "setValueT2DArray1", "setValueT3DArray", "setValueT2DArrayArray"].map((name) => emptied(name)),
    ],
  },
  { file: "renderers/webgl/WebGLTextures.js", why: "no volumes, no stacks of pictures", unless: ["Data3DTexture", "DataArrayTexture"], changes: [emptied("setTexture2DArray"), emptied("setTexture3D")] },
];

const CLONED = "nothing on the stage is a copy of another";
for (const file of [
  "core/Object3D", "core/BufferGeometry", "core/BufferAttribute", "core/InstancedBufferAttribute", "core/InstancedBufferGeometry", "core/RenderTarget",
  "objects/Mesh", "objects/Line", "objects/Points", "scenes/Scene", "lights/Light", "lights/LightShadow", "lights/PointLight",
  "cameras/Camera", "cameras/PerspectiveCamera", "geometries/BoxGeometry", "geometries/SphereGeometry", "geometries/CylinderGeometry", "geometries/CircleGeometry",
  "materials/Material", "materials/MeshPhongMaterial", "materials/MeshMatcapMaterial", "materials/ShaderMaterial", "materials/LineBasicMaterial", "materials/MeshBasicMaterial",
  "materials/MeshDepthMaterial", "materials/MeshDistanceMaterial", "materials/PointsMaterial", "textures/Texture", "textures/DepthTexture",
])
  PARTS.push({ file: `${file}.js`, why: CLONED, unless: ["clone"], changes: [[/^\tcopy\( source.*\) \{[\s\S]*?^\t\}/m, `\tcopy() { ${gone("copying")} }`]] });
PARTS.push({ file: "math/Color.js", why: "colours are numbers or #rrggbb", changes: [[/const _colorKeywords = \{[\s\S]*?\};/, "const _colorKeywords = {};"], [/if \( m = \/\^\(\\w[\s\S]*? else (?=if \( m = \/\^\\#)/, ""]] });

/** Of ShaderLib: by the materials that use it. Lines and what casts a shadow need three of them always. */
const SHADER_OF = {
  basic: null, depth: null, distance: null,
  lambert: ["MeshLambertMaterial"], phong: ["MeshPhongMaterial"], standard: PHYSICAL, toon: ["MeshToonMaterial"], matcap: ["MeshMatcapMaterial"],
  points: ["PointsMaterial"], dashed: ["LineDashedMaterial"], normal: ["MeshNormalMaterial"], sprite: ["SpriteMaterial"], shadow: ["ShadowMaterial"],
  background: [], backgroundCube: [], cube: [], equirect: [],
};

function withoutShaders(source, names) {
  let kept = source;
  for (const [name, materials] of Object.entries(SHADER_OF)) {
    if (!materials || materials.some((each) => names.has(each))) continue;
    kept = replaced(kept, [new RegExp(`^\\t${name}: \\{[\\s\\S]*?^\\t\\},?\\n`, "m"), ""], "ShaderLib.js");
  }
  return PHYSICAL.some((each) => names.has(each)) ? kept : replaced(kept, [/^ShaderLib\.physical = \{[\s\S]*?^\};/m, ""], "ShaderLib.js");
}

function replaced(source, [pattern, text], file) {
  const after = source.replace(pattern, text);
  if (after === source) throw new Error(`three's ${file} no longer holds ${pattern}: see site_src/slim/never.mjs`);
  return after;
}

/** A file of three without what is never used. names: all that the viewer's script names. */
export function withoutUnusedParts(path, source, names) {
  const file = path.replaceAll("\\", "/").split("/three/src/")[1];
  if (!file) return source;
  let kept = file.endsWith("shaders/ShaderLib.js") ? withoutShaders(source, names) : source;
  for (const part of PARTS) {
    if (part.file !== file || part.unless?.some((name) => names.has(name))) continue;
    for (const change of part.changes) kept = replaced(kept, change, file);
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
