/**
 * Scenes and traces, by classic scripts put into the page: from file:// a browser refuses fetch and
 * modules, but runs these. Each calls raywalkReceive(name, base64 of gzip of JSON).
 */
import { decodeWithRests } from "./trace/decode";
import { TraceError } from "./trace/errors";
import { inWords, wordsFrom } from "./trace/spoken";
import { unpack } from "./trace/unpack";
import type { Boxes } from "./state/box-lines";
import type { SceneData, SectionsData, SurroundingsData, Trace } from "./trace/types";
import { languageCode } from "./words";

export type Loss = "missing" | "damaged" | "other version" | "old browser";

/** What could not be loaded, and why. */
export class LoadError extends Error {
  constructor(
    readonly what: string, // "<id>/scene", "<id>/<n>", "<id>/sections" or a part's name
    readonly why: Loss,
  ) {
    super(`${what}: ${why}`);
  }
}

declare global {
  interface Window {
    raywalkReceive: (name: string, base64: string) => void;
  }
}

const OWN_LANGUAGE = "en"; // of scene.js
const SCENE_FORMAT = 1;
const KEPT_TRACES = 8; // a few megabytes each at most
const KEPT_SCENES = 4;

const coming = new Set<string>();
/** What is still loading: scripts, and data that is being read. */
export const loading = () => [...coming];

/** Runs a script. times: how often it was asked for in vain; its address says so, or the browser would give the damaged
 *  copy again. Rejects with LoadError. */
export function addScript(address: string, name: string, times = 0): Promise<void> {
  return new Promise((resolve, reject) => {
    const element = document.createElement("script");
    element.src = address + (times ? `?again=${times}` : "");
    const end = () => (element.remove(), coming.delete(address));
    element.onload = () => (end(), resolve());
    element.onerror = () => (end(), reject(new LoadError(name, "missing")));
    coming.add(address);
    document.head.append(element);
  });
}

const MARK = 16; // last characters of base64: gzip's checksum and length of what it packed
const marks = new Map<string, string>();
/** All files of a scene are of one build. On a plain host an open page would meet the data of the next one, too. */
function mark(name: string, text: string) {
  if ((marks.get(name) ?? text) !== text) throw new LoadError(name, "other version");
  marks.set(name, text);
}

type Read<T> = (json: unknown, name: string) => T | Promise<T>;

/** root: relative path from the page to the site's root, "" or ending in "/". */
function createScripts(root: string) {
  const arrived = new Map<string, string>();
  const failed = new Map<string, number>(); // how often each was asked for in vain
  window.raywalkReceive = (name, base64) => void arrived.set(name, base64);

  async function run(name: string): Promise<string> {
    await addScript(`${root}scenes/${name}.js`, name, failed.get(name));
    const text = arrived.get(name);
    arrived.delete(name);
    if (text === undefined) throw new LoadError(name, "damaged");
    return text;
  }

  return async <T>(name: string, read: Read<T>): Promise<T> => {
    coming.add(name);
    try {
      const text = await run(name);
      if (typeof DecompressionStream === "undefined") throw new LoadError(name, "old browser");
      const value = await read(await unpack(text), name);
      mark(name, text.slice(-MARK));
      return value;
    } catch (error) {
      failed.set(name, (failed.get(name) ?? 0) + 1);
      if (error instanceof LoadError) throw error;
      throw new LoadError(name, error instanceof TraceError && error.code === "version" ? "other version" : "damaged");
    } finally {
      coming.delete(name);
    }
  };
}

/** Remembers the last `size`; what failed is asked for anew. */
function remembering<T>(size: number, load: (name: string) => Promise<T>) {
  const known = new Map<string, Promise<T>>();
  return (name: string): Promise<T> => {
    const value = known.get(name) ?? load(name);
    known.delete(name);
    known.set(name, value);
    value.catch(() => known.delete(name));
    for (const old of known.keys()) if (known.size > size) known.delete(old);
    return value;
  };
}

/** Parts of the viewer that know whether data is what it must be, which only they need. */
interface Readers {
  (part: "box-lines"): Promise<{ boxesFrom: (json: unknown, scene: string) => Boxes }>;
  (part: "slice"): Promise<{ sectionsFrom: (json: unknown) => SectionsData }>;
  (part: "surroundings"): Promise<{ surroundingsFrom: (json: unknown) => SurroundingsData }>;
}

/** root: relative path from the page to the site's root, "" or ending in "/". */
export function createLoader(root: string, come: Readers) {
  const load = createScripts(root);
  const kept = <T>(size: number, read: Read<T>) => remembering(size, (name) => load(name, read));
  const scenes = kept(KEPT_SCENES, sceneFrom);
  const boxes = kept<Boxes>(KEPT_SCENES, async (json, name) => (await come("box-lines")).boxesFrom(json, name.split("/")[0]));
  const traces = kept(KEPT_TRACES, traceFrom);
  const sections = kept(KEPT_SCENES, async (json) => (await come("slice")).sectionsFrom(json));
  const surroundings = kept(KEPT_SCENES, async (json) => (await come("surroundings")).surroundingsFrom(json));
  const words = kept(KEPT_SCENES, wordsFrom);
  /** A lesson on another scene is laid over that scene. */
  const whole = async (id: string): Promise<SceneData> => {
    const scene = await scenes(`${id}/scene`);
    if (scene.of === id) return scene;
    const base = await scenes(`${scene.of}/scene`);
    return { ...base, ...scene, files: base.files };
  };
  return {
    async scene(id: string): Promise<SceneData> {
      const code = languageCode();
      const [scene, translated] = await Promise.all([whole(id), code === OWN_LANGUAGE ? null : words(`${id}/words-${code}`).catch(() => null)]);
      return translated ? inWords(scene, translated) : scene; // better in its own language than not at all
    },
    /** For what only a part reads, which knows whether it is what it must be. */
    kept,
    trace: (id: string, n: number) => traces(`${id}/${n}`),
    /** By the name of a file: of a scene with a mesh, with mirrors or glass. */
    boxes,
    surroundings,
    sections,
  };
}

export type Loader = ReturnType<typeof createLoader>;

function traceFrom(json: unknown, name: string): Promise<Trace> {
  const [scene, n] = name.split("/");
  return decodeWithRests(json, { scene, n: Number(n) }, nextTask);
}

/** Lets the browser draw and answer keys in between. */
const nextTask = () => new Promise<void>((resolve) => setTimeout(resolve));

function sceneFrom(json: unknown): SceneData {
  const scene = json as SceneData;
  if (typeof scene?.format === "number" && scene.format !== SCENE_FORMAT) throw new TraceError("version", `written as ${scene.format}, this reads ${SCENE_FORMAT}`);
  if (!scene?.format || (scene.of === scene.id && !scene.levels?.length)) throw new Error("not a scene");
  for (const file in scene.files) mark(`${scene.id}/${file}`, scene.files[file]);
  return scene;
}
