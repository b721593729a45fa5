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

/** A part's bundled module as a call that offers it. asked: noted there is what it takes from the viewer's script, by module. */
export function asOfferedPart(name, text, asked) {
  const taking = text.replace(/import\{([^}]*)\}from"shared:([^"]+)";/g, (_, names, from) => {
    const pairs = names.split(",").map((each) => each.split(" as "));
    asked.set(from, new Set([...(asked.get(from) ?? []), ...pairs.map(([wanted]) => wanted)]));
    return `const{${pairs.map((pair) => pair.join(":")).join()}}=$shared["${from}"];`;
  });
  const giving = taking.replace(/export\{([^}]*)\};?\s*$/, (_, names) => `return{${names.split(",").map((each) => each.split(" as ").reverse().join(":")).join()}};`);
  if (giving === taking || /\bimport[{*"]|\bexport[{*]/.test(giving)) throw new Error(`the part ${name} imports or exports in a way that parts.mjs does not read`);
  return `raywalkParts.offer("${name}",$shared=>{"use strict";${giving.trim()}});\n`;
}

/** What the viewer's script has to hand out. */
export function loadingParts(asked) {
  const from = [...asked].map(([path, names], k) => [path, k, [...names].sort()]);
  const imports = from.map(([path, k, names]) => `import { ${names.map((name) => `${name} as ${name}_${k}`).join(", ")} } from "./${path}";`);
  const handed = from.map(([path, k, names]) => `"${path}": { ${names.map((name) => `${name}: ${name}_${k}`).join(", ")} }`);
  return `${imports.join("\n")}\nwindow.raywalkShared = { ${handed.join(", ")} };`;
}
