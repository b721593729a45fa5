/** A picture of another scene than was chosen is known, and a wrong one of the chosen scene is not taken for another's. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { DIST } from "./browser.mjs";
import { load } from "./typescript.mjs";

const { aboutOf, allScenesOf, atlasOf, otherScene, rightOf } = await load("../check/main.ts");
const bytesOf = (path) => Buffer.from(readFileSync(`${DIST}/check/${path}.js`, "latin1").split('"')[3], "base64");
const ALL = allScenesOf(bytesOf("scenes"));
const right = (scene, size = aboutOf(bytesOf(`${scene}/about`)).own.at(-1)) => rightOf(bytesOf(`${scene}/${size}`));

test("all scenes that can be checked are told of", () => {
  const page = readFileSync(`${DIST}/check/index.html`, "utf8");
  assert.deepEqual([...ALL.scenes].sort(), [...page.matchAll(/name="scene" value="([^"]+)"/g)].map(([, id]) => id).sort());
  for (const means of ALL.means) assert.equal(means.length, 3 * ALL.along ** 2);
});

test("the right picture of any scene is that scene's, at its own size and at 100 pixels, whichever was chosen", () => {
  for (const scene of ALL.scenes.filter((id) => !/^1[2-6]-/.test(id))) // of the soft shadows: see below
    for (const size of [undefined, 100]) {
      assert.equal(otherScene(right(scene, size), scene, false, ALL), null, `${scene} ${size}`);
      const chosen = ALL.scenes.find((id) => id !== scene);
      assert.equal(otherScene(right(scene, size), chosen, false, ALL), scene, `${scene} ${size} taken for ${chosen}`);
    }
});

test("scenes that look the same from afar are not told for one another where the chosen one fits as well", () => {
  for (const scene of ALL.scenes.filter((id) => /^1[2-6]-/.test(id))) assert.equal(otherScene(right(scene), scene, false, ALL), null, scene);
});

test("what a mistake makes of a scene is taken for no other scene, unless it is that one's picture", () => {
  const told = [];
  for (const scene of ["01-shading", "02-shadows", "03-two-lights", "04-one-bounce", "05-many-bounces", "08-glass", "10-cornell-box"]) {
    const { size, mistakes } = atlasOf(aboutOf(bytesOf(`${scene}/about`)), rightOf(bytesOf(`${scene}/atlas`)));
    for (const { name, pictures } of mistakes)
      for (const values of pictures) {
        const other = otherScene({ width: size, height: size, values }, scene, true, ALL);
        if (other) told.push(`${name} in ${scene}: ${other}`);
      }
  }
  // Without shadows scene 2 is scene 1, and with one mirror image less scene 5 is nearly scene 4.
  assert.deepEqual(told.filter((each) => !/in 02-shadows: 01-shading$|in 0[45]-\S+: 0[45]-/.test(each)), [], told.join("\n"));
});
