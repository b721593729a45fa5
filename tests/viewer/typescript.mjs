/** The viewer's own modules for tests in node: bundled, then imported. */
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

export const VIEWER = fileURLToPath(new URL("../../site_src/viewer/", import.meta.url));

/** A language's sentences, as site_src/words/ has them. */
export const wordsOf = (language) => JSON.parse(readFileSync(new URL(`../../site_src/words/${language}.json`, import.meta.url), "utf8"));
globalThis.raywalkWords = wordsOf("en"); // in a page a script before the viewer's does this

/** path: below site_src/viewer, e.g. "state/address.ts". */
export async function load(...paths) {
  const contents = paths.map((path) => `export * from "./${path}";`).join("\n");
  const result = await build({ stdin: { contents, resolveDir: VIEWER, loader: "ts" }, bundle: true, write: false, format: "esm", logLevel: "silent" });
  return import(`data:text/javascript;base64,${Buffer.from(result.outputFiles[0].text).toString("base64")}`);
}
