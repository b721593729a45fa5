/** A scene in another language: words-<language>.js holds its words, scene.js everything else. */
import type { SceneData } from "./types";

export interface SceneWords {
  title: string;
  teaches: string;
  objects: readonly string[];
  lights: readonly string[];
  materials: readonly string[];
  lesson: readonly (readonly string[])[]; // of each step its text as HTML, and its answer's if it has one
}

export function wordsFrom(json: unknown): SceneWords {
  const words = json as SceneWords;
  if (!words?.title || !words.objects || !words.lesson) throw new Error("not a scene's words");
  return words;
}

export function inWords(scene: SceneData, words: SceneWords): SceneData {
  const named = <T extends { name: string }>(things: readonly T[], names: readonly string[]) => things.map((thing, k) => ({ ...thing, name: names[k] ?? thing.name }));
  return {
    ...scene,
    title: words.title,
    teaches: words.teaches,
    objects: named(scene.objects, words.objects),
    lights: named(scene.lights, words.lights),
    materials: named(scene.materials, words.materials),
    lesson: scene.lesson.map((step, k) => {
      const [html = step.html, answer = step.answer?.html] = words.lesson[k] ?? [];
      return { ...step, html, ...(step.answer && { answer: { ...step.answer, html: answer! } }) };
    }),
  };
}
