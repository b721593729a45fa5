/**
 * Parts of the viewer that come when asked for. Each import() is a part. What a part imports from modules that the
 * viewer's own script holds, or that two parts need, is taken from there (raywalkShared) and not bundled again: every
 * module exists once, and so does its state.
 */
import { join, relative } from "node:path";

/** In the viewer's script a part stays an import(), of "part:<path>". */
export const partsApart = {
  name: "parts apart",
  setup(build) {
    build.onResolve({ filter: /^\.\.?\// }, ({ kind, path, resolveDir }) => (kind === "dynamic-import" ? { path: `part:${below(build, resolveDir, path)}`, external: true } : null));
  },
};

/** In a part modules of `shared` (paths below this folder) stay imports, of "shared:<path>". */
export const sharing = (shared) => ({
  name: "sharing",
  setup(build) {
    build.onResolve({ filter: /^\.\.?\// }, ({ path, resolveDir, importer }) => {
      const at = below(build, resolveDir, path);
      return importer && importer !== "<stdin>" && shared.has(`${at}.ts`) ? { path: `shared:${at}`, external: true } : null;
    });
  },
});

const below = (build, folder, path) => relative(build.initialOptions.absWorkingDir, join(folder, path)).replaceAll("\\", "/");

/** parts: name -> module. own: the viewer's modules. Gives those with what several parts need. */
export async function sharedWith(parts, own, bundle) {
  const shared = new Set(own);
  const seen = new Set();
  for (const path of parts.values())
    for (const module of (await bundle(path, sharing(new Set(own)))).inputs) seen.has(module) ? shared.add(module) : seen.add(module);
  return shared;
}

/** A part's bundled module as a call that offers it. taken: "<module> <name>" of all that parts take from the viewer's
 *  script; what this one takes is added. */
export function asOfferedPart(name, text, taken) {
  const placeOf = (each) => (taken.includes(each) ? taken.indexOf(each) : taken.push(each) - 1);
  const taking = text.replace(/import\{([^}]*)\}from"shared:([^"]+)";/g, (_, names, from) => {
    const pairs = names.split(",").map((each) => each.split(" as "));
    return `const ${pairs.map(([wanted, here = wanted]) => `${here}=$shared[${placeOf(`${from} ${wanted}`)}]`).join()};`;
  });
  const giving = taking.replace(/export\{([^}]*)\};?\s*$/, (_, names) => `return{${names.split(",").map((each) => each.split(" as ").reverse().join(":")).join()}};`);
  if (giving === taking || /\bimport[{*"]|\bexport[{*]/.test(giving)) throw new Error(`the part ${name} imports or exports in a way that parts.mjs does not read`);
  return `raywalkParts.offer("${name}",$shared=>{"use strict";${giving.trim()}});\n`;
}

/** What the viewer's script hands out: the same, in this order. */
export function handingOut(taken) {
  const imports = taken.map((each) => each.split(" ")).map(([path, name], k) => `import { ${name} as taken${k} } from "./${path}";`);
  return `${imports.join("\n")}\nwindow.raywalkShared = [${taken.map((_, k) => `taken${k}`).join()}];`;
}
