/**
 * node site_src/packaged.mjs --out DIR SCRIPT...: scripts that node runs, each with all that it imports in it, so that they need
 * neither npm's packages nor TypeScript. What they ask modulesOf (modules.mjs) for is found in their texts.
 */
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const HERE = fileURLToPath(new URL("./", import.meta.url));

/** In place of modules.mjs: the modules that a script asks for, imported. */
const heldIn = (script) => ({
  name: "modules held",
  setup(build) {
    build.onResolve({ filter: /^\.\/modules\.mjs$/ }, ({ path }) => ({ path, namespace: "held" }));
    build.onLoad({ filter: /./, namespace: "held" }, async () => {
      const asked = [...(await readFile(join(HERE, script), "utf8")).matchAll(/\bmodulesOf\(("[^"]+")\)/g)].map(([, path]) => path);
      if (!asked.length) throw new Error(`${script} asks modulesOf for no path that stands in it`);
      const imports = asked.map((path, k) => `import * as held${k} from ${path};`);
      return { contents: `${imports.join("\n")}\nconst HELD = { ${asked.map((path, k) => `${path}: held${k}`).join()} };\nexport const modulesOf = (path) => HELD[path];`, resolveDir: HERE };
    });
  },
});

const [, , flag, folder, ...scripts] = process.argv;
if (flag !== "--out" || !folder || !scripts.length) throw new Error("usage: node site_src/packaged.mjs --out DIR SCRIPT...");
for (const script of scripts)
  await build({ entryPoints: [join(HERE, script)], absWorkingDir: HERE, outfile: join(folder, script), bundle: true, platform: "node", format: "esm", target: "node20", charset: "utf8", legalComments: "none", logLevel: "warning", plugins: [heldIn(script)] });
