/** A built scene and its traces for tests in node: the same files and decoder the page uses. */
import { readFileSync } from "node:fs";
import { gunzipSync } from "node:zlib";
import { DIST } from "./browser.mjs";
import { load } from "./typescript.mjs";

const { decode } = await load("trace/decode.ts");
/** What a script of a scene holds, by its name below scenes/. */
export const read = (path) => JSON.parse(gunzipSync(Buffer.from(readFileSync(`${DIST}/scenes/${path}.js`, "utf8").match(/raywalkReceive\([^,]+,\s*["'`]([^"'`]+)/)[1], "base64")));

/** A lesson on another scene is laid over that scene, as the viewer does. */
export function readScene(id) {
  const own = read(`${id}/scene`);
  if (own.of === id) return own;
  const base = read(`${own.of}/scene`);
  return { ...base, ...own, files: base.files };
}
/** The id of the scene whose rays it shows. */
const of = (id) => read(`${id}/scene`).of;
export const readSections = (id) => read(`${of(id)}/sections`);
export const readSurroundings = (id) => read(`${of(id)}/surroundings`);
/** A scene's words in another language, as its pages there read them. */
export const readWords = (id, language) => read(`${id}/words-${language}`);
export const readTrace = (id, n) => ({ scene: readScene(id), trace: decode(read(`${of(id)}/${n}`), { scene: of(id), n }) });
