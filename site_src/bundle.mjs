/**
 * node site_src/bundle.mjs --out DIR: the viewer as one classic script, DIR/viewer.js, and what only
 * a kiosk loads, DIR/kiosk.js; DIR/packages.json names the npm packages that are in them.
 * Classic, not a module, because from file:// browsers refuse modules. Prints its size
 * gzipped; ends with 1 if ray code is left in it or it has outgrown its goal.
 */
import { mkdir, readFile, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { build } from "esbuild";
import { tight } from "./slim/shaders.mjs";
import { slimThree } from "./slim/three.mjs";
import { raysLeftIn } from "./strip-rays.mjs";

const GOAL_BYTES = 125 * 1024;
const ENTRY = fileURLToPath(new URL("./viewer/main.ts", import.meta.url));
const EXTRAS = { kiosk: "./viewer/kiosk/main.ts" };
const TARGET = ["chrome100", "firefox113", "safari16.4"]; // the first with DecompressionStream

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

/** The viewer's script as text. `plugins` lets a test put in its own trace decoder. */
export async function bundleViewer({ plugins = [], minify = true, noteParts = () => {} } = {}) {
  const bundled = async (more) => {
    const result = await build({ entryPoints: [ENTRY], bundle: true, write: false, metafile: true, target: TARGET, legalComments: "none", logLevel: "warning", ...more });
    noteParts(result.metafile);
    return result.outputFiles[0].text;
  };
  const own = await bundled({ format: "esm", external: ["three"], plugins: [...plugins, tightShaders] });
  const three = await slimThree(own, TARGET, noteParts);
  const slim = {
    name: "slim",
    setup(build) {
      build.onResolve({ filter: /^three$/ }, () => ({ path: "three", namespace: "slim" }));
      build.onLoad({ filter: /./, namespace: "slim" }, () => ({ contents: three, loader: "js" }));
    },
  };
  return bundled({
    format: "iife",
    minify,
    banner: { js: "/* Raywalk viewer, MIT. Holds three.js (MIT), https://threejs.org */" },
    plugins: [...plugins, tightShaders, slim],
  });
}

/** The packages that esbuild took something from. */
const packagesIn = (metafiles) => {
  const names = metafiles.flatMap(({ inputs }) => Object.keys(inputs)).map((path) => /.*node_modules\/((?:@[^/]+\/)?[^/]+)/.exec(path)?.[1]);
  return [...new Set(names.filter(Boolean))].sort();
};

/** A script of its own, beside the viewer's. */
async function bundleExtra(path, noteParts) {
  const entry = fileURLToPath(new URL(path, import.meta.url));
  const result = await build({ entryPoints: [entry], bundle: true, write: false, metafile: true, target: TARGET, legalComments: "none", logLevel: "warning", format: "iife", minify: true, banner: { js: "/* Raywalk, MIT */" } });
  noteParts(result.metafile);
  return result.outputFiles[0].text;
}

async function main() {
  const at = process.argv.indexOf("--out");
  const folder = process.argv[at + 1];
  if (at < 0 || !folder) throw new Error("--out: no folder is named\n  usage: node site_src/bundle.mjs --out DIR");
  const metafiles = [];
  const noteParts = (metafile) => metafiles.push(metafile);
  const script = await bundleViewer({ noteParts });
  const left = raysLeftIn(script);
  if (left.length) throw new Error(`viewer.js still holds ray code: ${[...new Set(left)].join(", ")}`);
  const size = gzipSync(script, { level: 9 }).length;
  if (size > GOAL_BYTES) throw new Error(`viewer.js is ${size} bytes gzipped; its goal is ${GOAL_BYTES}`);
  await mkdir(folder, { recursive: true });
  await writeFile(join(folder, "viewer.js"), script);
  for (const [name, path] of Object.entries(EXTRAS)) await writeFile(join(folder, `${name}.js`), await bundleExtra(path, noteParts));
  await writeFile(join(folder, "packages.json"), JSON.stringify(packagesIn(metafiles)));
  console.log(`viewer.js ${(size / 1024).toFixed(1)} KB gzip`);
}

if (process.argv[1] === fileURLToPath(import.meta.url))
  main().catch((error) => {
    console.error(error.message);
    process.exitCode = 1;
  });
