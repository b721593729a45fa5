/** The viewer's decoder, compiled for node. */
import { build } from "esbuild";
import { fileURLToPath } from "node:url";

const FOLDER = fileURLToPath(new URL("../../../site_src/viewer/trace/", import.meta.url));

export async function loadDecoder() {
  const entry = ["decode", "unpack", "errors"].map((name) => `export * from "./${name}";`).join("\n");
  const built = await build({
    stdin: { contents: entry, resolveDir: FOLDER, loader: "ts" },
    bundle: true, write: false, format: "esm", platform: "neutral", logLevel: "silent",
  });
  return import(`data:text/javascript;base64,${Buffer.from(built.outputFiles[0].text).toString("base64")}`);
}
