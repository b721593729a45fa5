/** What of a lesson depends on its language: words, never what is switched. In node, without a page. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { load } from "./typescript.mjs";

const { inWords } = await load("trace/spoken.ts");
const { switchesFrom } = await load("state/switches.ts");

test("in another language a lesson's step switches the same lights, points of an area light too", () => {
  const light = (name) => ({ name, position: [0, 0, 0], colour: [1, 1, 1], intensity: 1 });
  const view = { switches: { lights: { lamp: 0, "light 2": 0.5 } } };
  const scene = { depth: 1, shadows: true, objects: [], materials: [], lights: [light("lamp 1/2"), light("lamp 2/2"), light("light 2")], lesson: [{ html: "", view: {} }, { html: "", view: {}, answer: { html: "", view } }] };
  const words = { title: "", teaches: "", objects: [], materials: [], lights: ["Lampe 1/2", "Lampe 2/2", "Licht 2"], lesson: [["eins"], ["zwei", "drei"]] };
  const spoken = inWords(scene, words);
  const [own, translated] = [scene, spoken].map((each) => switchesFrom(each.lesson[1].answer.view.switches, each));
  assert.deepEqual(translated, own);
  assert.deepEqual(own.lamps, [0, 0.5]);
  assert.equal(spoken.lesson[1].answer.html, "drei");
});
