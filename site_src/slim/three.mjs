/** three as the viewer needs it: one module with what the viewer's script names, and what that needs. */
import { readFile } from "node:fs/promises";
import { build, transform } from "esbuild";
import { withoutRays } from "../strip-rays.mjs";
import { withConstants, withShortMessages } from "./constants.mjs";
import { namesIn, withoutUnnamed } from "./members.mjs";
import { isNever, withoutUnusedParts } from "./never.mjs";
import { withLeanShaders } from "./shaders.mjs";

const MOST_ROUNDS = 8; // each takes out what only the last one's parts needed; two or three are enough

const slimming = (names) => ({
  name: "slim-three",
  setup(build) {
    build.onLoad({ filter: /[\\/]node_modules[\\/]three[\\/].*\.js$/ }, async ({ path }) => ({
      contents: withoutRays(withoutUnusedParts(path, await readFile(path, "utf8"), names)),
      loader: "js",
    }));
  },
});

const importsOf = (script) => new Set([...script.matchAll(/import \{([^}]*)\} from "three"/g)].flatMap(([, names]) => names.split(",").map((name) => name.trim().split(" as ")[0])).filter(Boolean));

/** own: the viewer's script with its imports of three left in. target: as esbuild takes it. noteInputs: told the
 *  files that went into it. */
export async function slimThree(own, target, noteInputs = () => {}) {
  const names = namesIn(own);
  const tidy = { format: "esm", target, minifySyntax: true, treeShaking: true, legalComments: "none" };
  const whole = await build({
    ...tidy,
    stdin: { contents: `export { ${[...importsOf(own)].join(", ")} } from "three/src/Three.js"`, resolveDir: process.cwd() },
    bundle: true,
    write: false,
    metafile: true,
    logLevel: "warning",
    plugins: [slimming(names)],
  });
  noteInputs(Object.keys(whole.metafile.inputs));
  let three = withShortMessages(whole.outputFiles[0].text);
  for (let round = 0, before = ""; before !== three && round < MOST_ROUNDS; round++) {
    before = three;
    for (const step of [(text) => withoutUnnamed(text, names), (text) => withConstants(text, [own]), (text) => withLeanShaders(text, own, (macro) => isNever(macro, names))])
      three = (await transform(step(three), tidy)).code;
  }
  return three;
}
