/** three as the viewer needs it: one module with what the viewer's script names, and what that needs. */
import { readFile } from "node:fs/promises";
import { build, transform } from "esbuild";
import { withoutRays } from "../strip-rays.mjs";
import { withConstants } from "./constants.mjs";
import { namesIn, withoutUnnamed } from "./members.mjs";
import { withShortMessages } from "./messages.mjs";
import { isNever, withoutUnusedParts } from "./never.mjs";
import { withLeanShaders } from "./shaders.mjs";

const MOST_ROUNDS = 8; // each takes out what only the last one's parts needed; two or three are enough

/** own: the viewer's script; names: all that it names. */
export const PASSES = {
  messages: (three) => withShortMessages(three),
  members: (three, { names }) => withoutUnnamed(three, names),
  constants: (three, { own }) => withConstants(three, [own]),
  shaders: (three, { own, names, macros }) => withLeanShaders(three, own, (macro) => macros && isNever(macro, names)),
};

const slimming = (names, without) => ({
  name: "slim-three",
  setup(build) {
    build.onLoad({ filter: /[\\/]node_modules[\\/]three[\\/].*\.js$/ }, async ({ path }) => ({
      contents: withoutRays(withoutUnusedParts(path, await readFile(path, "utf8"), names, without)),
      loader: "js",
    }));
  },
});

const importsOf = (script) => new Set([...script.matchAll(/import \{([^}]*)\} from "three"/g)].flatMap(([, names]) => names.split(",").map((name) => name.trim().split(" as ")[0])).filter(Boolean));

/** own: the viewer's script with its imports of three left in. target: as esbuild takes it. noteInputs: is given
 *  the files that went into it. without: a pass or a rule that is left out, to know what it saves. */
export async function slimThree(own, target, noteInputs = () => {}, without = "") {
  const names = namesIn(own);
  const tidy = { format: "esm", target, minifySyntax: true, treeShaking: true, legalComments: "none" };
  const whole = await build({
    ...tidy,
    stdin: { contents: `export { ${[...importsOf(own)].join(", ")} } from "three/src/Three.js"`, resolveDir: process.cwd() },
    bundle: true,
    write: false,
    metafile: true,
    logLevel: "warning",
    plugins: [slimming(names, without)],
  });
  noteInputs(Object.keys(whole.metafile.inputs));
  let three = whole.outputFiles[0].text;
  const passes = Object.entries(PASSES).filter(([name]) => name !== without);
  for (let round = 0, before = ""; before !== three && round < MOST_ROUNDS; round++) {
    before = three;
    for (const [, pass] of passes) three = (await transform(pass(three, { own, names, macros: without !== "macros" }), tidy)).code;
  }
  return three;
}
