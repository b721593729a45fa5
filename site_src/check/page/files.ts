/** A scene's data, by classic scripts put into the page: from file:// a browser refuses anything else. Each calls raywalkReceive. */
import { atlasOf, type About, type Atlas } from "../atlas";
import type { Scene } from "../check";
import { aboutOf, rightOf, sceneOf, stripsOf } from "../data";
import type { Picture } from "../formats/picture";
import { allScenesOf, type AllScenes } from "../other-scene";

const arrived = new Map<string, string>();

function bytesOf(base64: string): Uint8Array<ArrayBuffer> {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < bytes.length; i++) bytes[i] = text.charCodeAt(i);
  return bytes;
}

/** Rejects where it cannot be had. */
function run(address: string, name: string): Promise<Uint8Array<ArrayBuffer>> {
  return new Promise((resolve, reject) => {
    const script = document.createElement("script");
    script.src = address;
    script.onerror = () => (script.remove(), reject(new Error(`${address} is missing`)));
    script.onload = () => {
      script.remove();
      const text = arrived.get(name);
      if (text === undefined) return reject(new Error(`${address} is damaged`));
      arrived.delete(name);
      resolve(bytesOf(text));
    };
    document.head.append(script);
  });
}

/** root: from the page to the site's root. */
export function createFiles(root: string) {
  window.raywalkReceive = (name, base64) => void arrived.set(name, base64);
  let before: Promise<unknown> = Promise.resolve(); // one after the other: scripts of two scenes have the same names
  const read = (path: string, name: string) => {
    const next = before.then(() => run(`${root}check/${path}.js`, `check/${name}`));
    before = next.catch(() => {});
    return next;
  };
  const file = (scene: string, name: string) => read(`${scene}/${name}`, name);
  let all: Promise<AllScenes> | null = null;
  let kept: { id: string; about: Promise<About>; scene?: Promise<Scene> } | null = null;

  function about(id: string): Promise<About> {
    if (kept?.id !== id) {
      const own = { id, about: file(id, "about").then(aboutOf) };
      own.about.catch(() => kept === own && (kept = null)); // it is asked for again the next time
      kept = own;
    }
    return kept.about;
  }

  async function made(id: string): Promise<Scene> {
    const said = await about(id);
    const [places, atlas] = [await file(id, "places"), said.leftOut ? null : await file(id, "atlas")];
    return sceneOf(said, places, atlas);
  }

  return {
    about,
    async scene(id: string): Promise<Scene> {
      await about(id);
      const own = kept!;
      own.scene ??= made(id);
      own.scene.catch(() => delete own.scene);
      return own.scene;
    },
    /** What all look like. */
    scenes(): Promise<AllScenes> {
      all ??= read("scenes", "scenes").then(allScenesOf);
      all.catch(() => (all = null));
      return all;
    },
    /** Its wrong pictures alone: nothing is made ready to recognise them. */
    atlas: async (id: string): Promise<Atlas> => atlasOf(await about(id), await stripsOf(await file(id, "atlas"))),
    right: async (id: string, size: number): Promise<Picture> => rightOf(await file(id, String(size))),
    /** The right colours at the tiles of the finest grid. */
    tiles: async (id: string): Promise<Picture> => rightOf(await file(id, "tiles")),
  };
}

export type Files = ReturnType<typeof createFiles>;

declare global {
  interface Window {
    raywalkReceive: (name: string, base64: string) => void;
  }
}
