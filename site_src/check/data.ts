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

/** atlas: null where about says why there is none. */
export function sceneOf(about: About, places: Uint8Array, atlas: Uint8Array | null): Scene {
  return { about, places: rightOf(places), recogniser: atlas && recogniserOf(atlasOf(about, rightOf(atlas))) };
}
