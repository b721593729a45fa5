/** A scene in another language: words-<language>.js holds its words, scene.js everything else. */
import type { SceneData, SceneWords, View } from "./types";

export function wordsFrom(json: unknown): SceneWords {
  const words = json as SceneWords;
  if (!words?.title || !words.objects || !words.lesson) throw new Error("not a scene's words");
  return words;
}

/** Of a light, or of the area light that it is a point of. */
const lampName = (light: string) => light.replace(/ \d+\/\d+$/, "");

/** A lesson's view names lights as the scene does. */
function viewInWords(view: View, scene: SceneData, words: SceneWords): View {
  if (!view.switches?.lights) return view;
  const names = new Map(scene.lights.map(({ name }, k) => [lampName(name), lampName(words.lights[k] ?? name)]));
  const lights = Object.fromEntries(Object.entries(view.switches.lights).map(([lamp, factor]) => [names.get(lamp) ?? lamp, factor]));
  return { ...view, switches: { ...view.switches, lights } };
}

export function inWords(scene: SceneData, words: SceneWords): SceneData {
  const inView = ({ view }: { view: View }) => viewInWords(view, scene, words);
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
      return { ...step, html, view: inView(step), ...(step.answer && { answer: { html: answer!, view: inView(step.answer) } }) };
    }),
  };
}
