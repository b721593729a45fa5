/** Two mistakes, one of which acts on the whole picture: it is undone, and what is left is named. On the atlases of the built site. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { dataOf } from "./check-data.mjs";
import { load } from "./typescript.mjs";

const { aboutOf, atlasOf, recogniserOf, stripsOf } = await load("../check/main.ts");
const { undoOf, UNDONE } = await load("../check/undone.ts");
const { ON_WHOLE_PICTURES } = await load("../check/together.ts");

async function atlasIn(scene) {
  const atlas = atlasOf(aboutOf(dataOf(scene, "about")), await stripsOf(dataOf(scene, "atlas")));
  return { ...atlas, recogniser: recogniserOf(atlas), wrong: (name) => atlas.mistakes.find((each) => each.name === name).pictures[0] };
}
const SCENES = Object.fromEntries(await Promise.all(["01-shading", "02-shadows", "08-glass"].map(async (scene) => [scene, await atlasIn(scene)])));
const pictureOf = (values, size) => ({ width: size, height: size, values: Uint8Array.from(values, Math.round), isLossy: false, hadAlpha: false });

function recognised(scene, values) {
  const { size, right, recogniser } = SCENES[scene];
  return recogniser.recognise(pictureOf(values, size), pictureOf(right, size));
}

const PAIRS = [
  ["01-shading", "gamma-applied", "highlight-forgotten"], ["02-shadows", "gamma-applied", "view-reversed"],
  ["02-shadows", "gamma-applied", "shadow-darkens-ambient"], ["08-glass", "gamma-applied", "total-black"],
  ["08-glass", "red-and-blue-swapped", "no-fresnel"], ["02-shadows", "upside-down", "highlight-forgotten"],
  ["01-shading", "rows-and-columns-swapped", "highlight-forgotten"],
];
for (const [scene, whole, second] of PAIRS) {
  test(`${whole} hides no ${second}: both are named, together`, () => {
    const { size, wrong } = SCENES[scene];
    const { answers, isPair } = recognised(scene, ON_WHOLE_PICTURES[whole](Float32Array.from(wrong(second)), size));
    assert.ok(isPair);
    const named = answers.slice(0, 2).map(({ names }) => names);
    for (const name of [whole, second]) assert.ok(named.some((names) => names.includes(name)), JSON.stringify(named));
  });
}

test("what can be undone is one mistake where it is alone", () => {
  for (const scene of Object.keys(SCENES)) {
    for (const name of [...Object.keys(UNDONE), "fov-not-halved", "fov-in-radians"]) {
      const { answers, isPair } = recognised(scene, SCENES[scene].wrong(name));
      assert.deepEqual([scene, answers[0].names.includes(name), isPair], [scene, true, false], name);
    }
  }
});

const CURVES = { "a root": (v) => v ** (1 / 2), "sRGB's curve": (v) => (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055), "a gamma of 2.4": (v) => v ** (1 / 2.4) };
for (const [curve, of] of Object.entries(CURVES)) {
  test(`${curve} is a gamma, and no second mistake is made up for what it leaves`, () => {
    for (const scene of Object.keys(SCENES)) {
      const { answers, isPair } = recognised(scene, Float32Array.from(SCENES[scene].right, (value) => 255 * of(value / 255)));
      assert.deepEqual([scene, answers[0].names[0], isPair], [scene, "gamma-applied", false]);
    }
  });
}

test("what is undone is the picture as it was", () => {
  const { right, size } = SCENES["01-shading"];
  for (const [name, act] of Object.entries(ON_WHOLE_PICTURES)) {
    const back = UNDONE[name](act(Float32Array.from(right), size), size);
    back.forEach((value, i) => assert.ok(Math.abs(value - right[i]) < 0.2, name)); // a curve laid out; a fifteenth of noise
  }
});

test("a wrong field of view is drawn out to the right one, as far as it shows the same", () => {
  for (const [scene, atlas] of Object.entries(SCENES)) {
    const { right, size, mistakes } = atlas;
    const { name, drawnIn, pictures: [picture] } = mistakes.find((each) => each.name === "fov-not-halved");
    const back = undoOf({ name, drawnIn, picture }, right, size)(Float32Array.from(picture), size);
    const far = back.filter((value, i) => Math.abs(value - right[i]) > 24).length / back.length;
    assert.ok(far < 0.05, `${scene}: ${far}`); // edges, of a picture half as fine
  }
});
