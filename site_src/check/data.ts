/** A scene's data for checks out of the bytes that build/raywalk/check/write.py packs. */
import { gunzipSync } from "fflate";
import { atlasOf, type About } from "./atlas";
import type { Scene } from "./check";
import type { Picture } from "./formats/picture";
import { readPng } from "./formats/png";
import { recogniserOf } from "./recognise";

export const aboutOf = (bytes: Uint8Array): About => JSON.parse(new TextDecoder().decode(gunzipSync(bytes)));

/** Of our own pipeline: as large as it is. */
export const rightOf = (bytes: Uint8Array): Picture => readPng(bytes, Infinity);

/** Megabytes, which an engine's own code unpacks in a tenth of the time that a library's takes. Rejects what is damaged. */
export async function stripsOf(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array> {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** atlas: null where about says why there is none. */
export async function sceneOf(about: About, places: Uint8Array, atlas: Uint8Array<ArrayBuffer> | null): Promise<Scene> {
  return { about, places: rightOf(places), recogniser: atlas && recogniserOf(atlasOf(about, await stripsOf(atlas))) };
}
