/** A scene's data for checks out of the bytes that build/raywalk/check/write.py packs. */
import { gunzipSync } from "fflate";
import { atlasOf, type About } from "./atlas";
import type { Scene } from "./check";
import { pictureOf, type Picture } from "./formats/picture";
import { recogniserOf } from "./recognise";

export const aboutOf = (bytes: Uint8Array): About => JSON.parse(new TextDecoder().decode(gunzipSync(bytes)));

/** Megabytes, which an engine's own code unpacks in a tenth of the time that a library's takes. Rejects what is damaged. */
export async function stripsOf(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array> {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Of rows, each by what it differs from the one above it. */
export async function rightOf(bytes: Uint8Array<ArrayBuffer>): Promise<Picture> {
  const values = await stripsOf(bytes);
  const size = Math.sqrt(values.length / 3);
  for (let i = 3 * size; i < values.length; i++) values[i] += values[i - 3 * size];
  return pictureOf(size, size, values);
}

/** atlas: null where about says why there is none. */
export async function sceneOf(about: About, places: Uint8Array<ArrayBuffer>, atlas: Uint8Array<ArrayBuffer> | null): Promise<Scene> {
  return { about, places: await rightOf(places), recogniser: atlas && recogniserOf(atlasOf(about, await stripsOf(atlas))) };
}
