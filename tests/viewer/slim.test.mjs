/** three is shipped without what nothing names: what goes, what stays, and that the site draws is shown by all other tests. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { withConstants } from "../../site_src/slim/constants.mjs";
import { namesIn, withoutUnnamed } from "../../site_src/slim/members.mjs";
import { withShortMessages } from "../../site_src/slim/messages.mjs";
import { withoutUnusedParts } from "../../site_src/slim/never.mjs";
import { preprocessed, tight, withLeanShaders } from "../../site_src/slim/shaders.mjs";

const none = new Set();

test("a method goes if nothing names it, and with it what only it needed", () => {
  const source = "class V { length() { return this.dot(); } dot() { return 1; } unit() { return this.length(); } }\nexport { V };";
  assert.doesNotMatch(withoutUnnamed(source, none), /length|dot|unit/);
  assert.match(withoutUnnamed(source, new Set(["length"])), /length\(\) [\s\S]*dot\(\)/);
  assert.doesNotMatch(withoutUnnamed(source, new Set(["length"])), /unit/);
});

test("a name in a string, a key or a pattern is named too", () => {
  for (const use of ['x["far"]', "x = { far: 1 }", "const { far } = x", "x.far = 2"]) assert.match(withoutUnnamed(`class C { far() {} }\n${use};`, none), /far\(\)/, use);
  assert.ok(["near", "far"].every((name) => namesIn('a.near(); b("far")').has(name)));
});

test("of settings only the unnamed go, wherever they stand, and a 0 is left for the bundler; so do inner functions", () => {
  const settings = (names) => withoutUnnamed("class C { constructor() { this.a = 1, this.b = f, this.c = 2; } }", new Set(names));
  assert.match(settings(["a", "c"]), /\{ this\.a = 1, 0, this\.c = 2; \}/);
  assert.match(settings([]), /\{ 0, 0, 0; \}/);
  assert.equal(withoutUnnamed("function f() { function g() {} return b; }", none), "function f() {  return b; }");
});

test("what has effects stays, named or not, and so does a setting whose value is used", () => {
  for (const kept of ["this.a = start();", "return this.a = 1;", "let b = (this.c = 2, this.a = 1);"]) assert.ok(withoutUnnamed(`function f() { ${kept} }`, new Set(["c"])).includes(kept), kept);
});

test("a flag that nothing sets is undefined, a property set to nothing else than null is no condition", () => {
  const source = "class M { constructor() { this.fog = null; this.map = null; } }\nif (object.isSprite) a(); if (material.fog) b(); if (material.map) c(); if (material.fog !== null) d();";
  const folded = withConstants(source, ["look.map = texture();"]);
  assert.match(folded, /if \(\(void 0\)\) a/);
  assert.match(folded, /if \(\(!1\)\) b/);
  assert.match(folded, /if \(material\.map\) c/); // the other script sets it
  assert.match(folded, /material\.fog !== null/); // not asked as a condition: null and undefined differ
  assert.match(withConstants("if (object.isSprite) a();", ["thing.isSprite = true;"]), /object\.isSprite/);
});

test("shaders lose comments and what hangs on macros that are off, else and elif read right", () => {
  const isOff = (macro) => macro === "OFF";
  const kept = (text) => preprocessed(text, isOff).split("\n");
  assert.deepEqual(kept("#ifdef OFF\na\n#else\nb\n#endif"), ["b"]);
  assert.deepEqual(kept("#ifndef OFF\na\n#else\nb\n#endif"), ["a"]);
  assert.deepEqual(kept("#if defined( OFF ) || defined( ON )\na\n#endif"), ["#if defined( OFF ) || defined( ON )", "a", "#endif"]);
  assert.deepEqual(kept("#if defined( OFF ) && defined( ON )\na\n#elif defined( ON )\nb\n#else\nc\n#endif"), ["#if defined( ON )", "b", "#else", "c", "#endif"]);
  assert.deepEqual(kept("#ifdef ON\n#ifdef OFF\na\n#endif\nb\n#endif"), ["#ifdef ON", "b", "#endif"]);
  assert.deepEqual(kept("#if OFF > 0\na\n#endif\nb"), ["b"]);
  assert.equal(tight("// c\nvoid main() {\n  /* d */ float  a = 1.0 ;\n#ifdef ON\n  a *= 2.0;\n#endif\n}"), "void main() {float a=1.0;\n#ifdef ON\na*=2.0;\n#endif\n}");
});

test("a shader chunk that nothing includes goes, and so does an include of an empty one", () => {
  const source = 'var a = "#ifdef OFF\\nx;\\n#endif", b = "float f();\\n#include <d>", c = "z;", d = "y;", ShaderChunk = { a, b, c, d };\nvar main = "#include <a>\\n#include <b>\\nvoid main() { f(); }";\nexport { ShaderChunk, main };';
  const lean = withLeanShaders(source, "", () => false);
  assert.match(lean, /ShaderChunk = \{ b, d \}/);
  assert.match(lean, /main = "\\n#include <b>\\nvoid main/);
  assert.match(withLeanShaders(source, "ShaderChunk.c", () => false), /ShaderChunk = \{ b, c, d \}/);
});

test("messages are their first word, but for what does something while it is said", () => {
  assert.equal(withShortMessages('warn("WebGLRenderer: lost.", gl); error(`${name}: no`, at++);'), 'warn("WebGLRenderer"); error(`${name}: no`, at++);');
});

test("three's parts that are left out by hand throw if they are called, and come back when they are named", () => {
  const source = "export class Mesh {\n\tcopy( source, recursive ) {\n\t\treturn this;\n\t}\n\tupdateMorphTargets() {\n\t\tmorph();\n\t}\n}";
  const path = "/x/node_modules/three/src/objects/Mesh.js";
  assert.match(withoutUnusedParts(path, source, none), /copy\(\) \{ throw new Error\("three: copying is not shipped/);
  assert.match(withoutUnusedParts(path, source, new Set(["clone"])), /return this;/);
  assert.throws(() => withoutUnusedParts(path, "export class Mesh {}", none), /Mesh\.js no longer holds/);
});
