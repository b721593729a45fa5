/**
 * node site_src/bundle.mjs --out DIR: the viewer as classic scripts. DIR/viewer.js is what a first view needs; each
 * import() in the viewer becomes a part of its own, DIR/part-<module>.js (parts.mjs); DIR/kiosk.js is what only a kiosk
 * loads, DIR/check.js what the page check/ does, DIR/check-mistake.js what it has a mistake's page do, DIR/page.js what every page does;
 * DIR/packages.json names the npm packages that are in them.
 * Classic, not modules, because from file:// browsers refuse modules. Ends with 1 if ray code is left.
 */
import { mkdir, readFile, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { build, transform } from "esbuild";
import { asOfferedPart, handingOut, partsApart, sharedWith, sharing } from "./parts.mjs";
import { tight } from "./slim/shaders.mjs";
import { slimThree } from "./slim/three.mjs";
import { raysLeftIn } from "./strip-rays.mjs";

const HERE = fileURLToPath(new URL("./", import.meta.url));
const PAGE = ["./page/broken.js", "./page/kiosk.js", "./page/language.js", "./page/offline.js"]; // in every page's head
const TARGET = ["chrome100", "firefox113", "safari16.4"]; // the first with DecompressionStream
const BANNERS = { viewer: "/* Holds three.js, MIT */", check: "/* Holds fast-png, fflate, iobuffer, jpeg-js: LICENSES.txt */", other: "/* Raywalk, MIT */" };

/** Our own shaders without comments and spaces, as three's: template texts with a shader's main in them. */
const tightShaders = {
  name: "tight shaders",
  setup(build) {
    build.onLoad({ filter: /[\\/]viewer[\\/]stage[\\/][\w-]+\.ts$/ }, async ({ path }) => ({
      contents: (await readFile(path, "utf8")).replace(/`([^`$]*\bvoid main\(\) \{[^`$]*)`/g, (_, shader) => JSON.stringify(tight(shader))),
      loader: "ts",
    }));
  },
};

/** contents: of a module in this folder. Gives { text, inputs, imports }: esbuild's, with paths below it. */
async function bundled(contents, { noteInputs, ...more }) {
  const result = await build({
    stdin: { contents, resolveDir: HERE, loader: "ts" },
    absWorkingDir: HERE,
    bundle: true,
    write: false,
    metafile: true,
    target: TARGET,
    legalComments: "none",
    logLevel: "warning",
    ...more,
  });
  const [{ imports }] = Object.values(result.metafile.outputs);
  const inputs = Object.keys(result.metafile.inputs).filter((path) => path !== "<stdin>");
  noteInputs?.(inputs);
  return { text: result.outputFiles[0].text, inputs, imports };
}

const APART = { format: "esm", external: ["three"], plugins: [partsApart, tightShaders] };

/** The viewer's parts by name, the modules in each script, and what is left for the viewer's own: its entry, and that
 *  bundled without three: { parts, modules, entry, own }. */
export async function bundleParts(noteInputs = () => {}) {
  const alone = await bundled('import "./viewer/main"', APART);
  const parts = new Map(alone.imports.filter(({ kind }) => kind === "dynamic-import").map(({ path }) => path.replace("part:", "")).map((path) => [path.split("/").at(-1), path]));
  const shared = await sharedWith(parts, alone.inputs, (path, plugin) => bundled(`export * from "./${path}"`, { format: "esm", plugins: [plugin, tightShaders] }));
  const modules = {};
  const offered = {};
  const taken = [];
  for (const [name, path] of parts) {
    const { text, inputs } = await bundled(`export * from "./${path}"`, { noteInputs, format: "esm", minify: true, plugins: [sharing(shared), tightShaders] });
    modules[name] = inputs;
    offered[name] = `${BANNERS.other}\n${asOfferedPart(name, text, taken)}`;
  }
  const entry = `import "./viewer/main";\n${handingOut(taken)}`;
  const own = await bundled(entry, APART);
  modules.viewer = own.inputs;
  return { parts: offered, modules, entry, own: own.text };
}

/** The viewer's script and its parts by name: { viewer, parts }. */
export async function bundleViewer(noteInputs = () => {}, without = "") {
  const { parts, entry, own } = await bundleParts(noteInputs);
  const three = await slimThree(own, TARGET, noteInputs, without);
  const slim = {
    name: "slim",
    setup(build) {
      build.onResolve({ filter: /^three$/ }, () => ({ path: "three", namespace: "slim" }));
      build.onLoad({ filter: /./, namespace: "slim" }, () => ({ contents: three, loader: "js" }));
    },
  };
  const whole = await bundled(entry, { noteInputs, format: "iife", minify: true, banner: { js: BANNERS.viewer }, plugins: [partsApart, tightShaders, slim] });
  return { viewer: whole.text.replace(/\bimport\("part:(?:[\w-]+\/)*([\w-]+)"\)/g, 'raywalkParts.load("$1")'), parts };
}

/** The packages that esbuild took something from. */
const packagesIn = (paths) => [...new Set(paths.map((path) => /.*node_modules\/((?:@[^/]+\/)?[^/]+)/.exec(path)?.[1]).filter(Boolean))].sort();

async function main() {
  const at = process.argv.indexOf("--out");
  const folder = process.argv[at + 1];
  if (at < 0 || !folder) throw new Error("--out: no folder is named\n  usage: node site_src/bundle.mjs --out DIR");
  const paths = [];
  const noteInputs = (inputs) => paths.push(...inputs);
  const { viewer, parts } = await bundleViewer(noteInputs);
  const left = raysLeftIn(viewer);
  if (left.length) throw new Error(`viewer.js still holds ray code: ${[...new Set(left)].join(", ")}`);
  const kiosk = await bundled('import "./viewer/kiosk/main"', { noteInputs, format: "iife", minify: true, banner: { js: BANNERS.other } });
  const check = await bundled('import "./check/page/main"', { noteInputs, format: "iife", minify: true, banner: { js: BANNERS.check } });
  const mistake = await bundled('import "./check/page/mistake"', { noteInputs, format: "iife", minify: true, banner: { js: BANNERS.check } });
  const page = await Promise.all(PAGE.map((path) => readFile(join(HERE, path), "utf8")));
  const scripts = { viewer, kiosk: kiosk.text, check: check.text, "check-mistake": mistake.text, page: (await transform(page.join("\n"), { minify: true, target: TARGET })).code, ...Object.fromEntries(Object.entries(parts).map(([name, text]) => [`part-${name}`, text])) };
  await mkdir(folder, { recursive: true });
  for (const [name, text] of Object.entries(scripts)) await writeFile(join(folder, `${name}.js`), text);
  await writeFile(join(folder, "packages.json"), JSON.stringify(packagesIn(paths)));
  for (const [name, text] of Object.entries(scripts)) console.log(`${name}.js ${(gzipSync(text, { level: 9 }).length / 1000).toFixed(1)} KB gzip`);
}

if (process.argv[1] === fileURLToPath(import.meta.url))
  main().catch((error) => {
    console.error(error.message);
    process.exitCode = 1;
  });
