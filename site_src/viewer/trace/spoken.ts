/** A scene in another language: words-<language>.js holds its words, scene.js everything else. */
import type { SceneData, SceneWords } from "./types";

export function wordsFrom(json: unknown): SceneWords {
  const words = json as SceneWords;
  if (!words?.title || !words.objects || !words.lesson) throw new Error("not a scene's words");
  return words;
}

export function inWords(scene: SceneData, words: SceneWords): SceneData {
  const named = <T extends { name: string }>(things: readonly T[], names: readonly string[]) => things.map((thing, k) => ({ ...thing, name: names[k] ?? thing.name }));
  return { ...scene, ...words, objects: named(scene.objects, words.objects), lights: named(scene.lights, words.lights), materials: named(scene.materials, words.materials) };
}
