/** A picture of another scene than was chosen is known, and a wrong one of the chosen scene is not taken for another's. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { DIST } from "./browser.mjs";
import { load } from "./typescript.mjs";

const { aboutOf, allScenesOf, atlasOf, otherScene, rightOf, stripsOf, toldApartFromAfar } = await load("../check/main.ts");
const bytesOf = (path) => Buffer.from(readFileSync(`${DIST}/check/${path}.js`, "latin1").split('"')[3], "base64");
const ALL = allScenesOf(bytesOf("scenes"));
const right = (scene, size = aboutOf(bytesOf(`${scene}/about`)).own.at(-1)) => rightOf(bytesOf(`${scene}/${size}`));

test("all scenes that can be checked are told of", () => {
  const page = readFileSync(`${DIST}/check/index.html`, "utf8");
  assert.deepEqual([...ALL.scenes].sort(), [...page.matchAll(/name="scene" value="([^"]+)"/g)].map(([, id]) => id).sort());
  for (const means of ALL.means) assert.equal(means.length, 3 * ALL.along ** 2);
  for (const means of ALL.wrong.flatMap((of) => Object.values(of)).flat()) assert.equal(means.length, 3 * ALL.wrongAlong ** 2);
});

test("the right picture of any scene is that scene's, at its own size and at 100 pixels, whichever was chosen", async () => {
  for (const scene of ALL.scenes.filter((id) => !/^1[2-6]-/.test(id))) // of the soft shadows: see below
    for (const size of [undefined, 100]) {
      assert.equal(otherScene(await right(scene, size), scene, false, ALL), null, `${scene} ${size}`);
      const chosen = ALL.scenes.find((id) => id !== scene);
      assert.equal(otherScene(await right(scene, size), chosen, false, ALL), scene, `${scene} ${size} taken for ${chosen}`);
    }
});

test("scenes that look the same from afar are not told for one another where the chosen one fits as well", async () => {
  for (const scene of ALL.scenes.filter((id) => /^1[2-6]-/.test(id))) assert.equal(otherScene(await right(scene), scene, false, ALL), null, scene);
});

test("what a mistake makes of a scene is taken for no other scene, unless it is that one's picture", async () => {
  const told = [];
  for (const scene of ["01-shading", "02-shadows", "03-two-lights", "04-one-bounce", "05-many-bounces", "08-glass", "10-cornell-box"]) {
    const { size, mistakes } = atlasOf(aboutOf(bytesOf(`${scene}/about`)), await stripsOf(bytesOf(`${scene}/atlas`)));
    for (const { name, pictures } of mistakes)
      for (const values of pictures) {
        const other = otherScene({ width: size, height: size, values }, scene, true, ALL);
        if (other) told.push(`${name} in ${scene}: ${other}`);
      }
  }
  // Without shadows scene 2 is scene 1, and with one mirror image less scene 5 is nearly scene 4.
  assert.deepEqual(told.filter((each) => !/in 02-shadows: 01-shading$|in 0[45]-\S+: 0[45]-/.test(each)), [], told.join("\n"));
});

/** Of a scene: each mistake's name and the picture it makes. */
async function wrongIn(scene) {
  const { size, mistakes } = atlasOf(aboutOf(bytesOf(`${scene}/about`)), await stripsOf(bytesOf(`${scene}/atlas`)));
  return mistakes.flatMap(({ name, pictures }) => pictures.map((values) => ({ name, picture: { width: size, height: size, values } })));
}

test("a wrong picture is known as its own scene's where no mistake of the chosen one explains it, though the right ones look alike", async () => {
  const wrong = await wrongIn("02-shadows");
  const told = wrong.filter(({ picture }) => otherScene(picture, "01-shading", false, ALL) === "02-shadows").map(({ name }) => name);
  assert.ok(told.includes("shadow-darkens-ambient"), told.join());
  for (const { name, picture } of wrong) assert.equal(otherScene(picture, "02-shadows", false, ALL) ?? "01-shading", "01-shading", name);
});

test("in any scene most wrong pictures of another one are known as that one's", async () => {
  for (const [scene, chosen] of [["08-glass", "10-cornell-box"], ["03-two-lights", "08-glass"], ["10-cornell-box", "02-shadows"]]) {
    const all = await wrongIn(scene);
    const told = all.filter(({ picture }) => otherScene(picture, chosen, false, ALL) === scene);
    assert.ok(told.length > 0.9 * all.length, `${told.length} of ${all.length}: ${scene} taken for ${chosen}`);
  }
});

test("mistakes that look the same in a scene are told apart by one where they do not, and by none where they never differ", () => {
  const first = "01-shading";
  assert.equal(toldApartFromAfar("upside-down", "red-and-blue-swapped", ALL), first, "in the course's order");
  const scene = toldApartFromAfar("shadows-forgotten", "glass-shadow-opaque", ALL);
  assert.ok(["shadows-forgotten", "glass-shadow-opaque"].every((name) => name in ALL.wrong[ALL.scenes.indexOf(scene)]), scene);
  assert.equal(toldApartFromAfar("upside-down", "upside-down", ALL), null);
  assert.equal(toldApartFromAfar("upside-down", "no such mistake", ALL), null);
});
