/**
 * What scripts that node runs (stops.mjs, check.mjs) use of our TypeScript: bundled when they start. In a wheel, which has
 * no npm packages, they hold it already (packaged.mjs).
 */
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

/** What a module exports; its path is relative to this folder. */
export async function modulesOf(path) {
  const entry = fileURLToPath(new URL(path, import.meta.url));
  const { outputFiles } = await build({ entryPoints: [entry], bundle: true, write: false, format: "esm", logLevel: "silent" });
  return import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].contents).toString("base64")}`);
}
