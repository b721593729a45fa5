/** How right a picture is, and what would fit better: on a made picture without symmetries. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { load } from "./typescript.mjs";

const { compare } = await load("../check/main.ts");
const { FITS } = await load("../check/fits.ts");
const { ON_WHOLE_PICTURES } = await load("../check/together.ts");

const N = 32;
const of = (values) => ({ width: N, height: N, values: Uint8Array.from(values), isLossy: false, hadAlpha: false });
/** Red grows to the right, green downwards but slower, blue is a stripe: no flip, turn or swap leaves it as it is. */
const right = of(Array.from({ length: N * N }, (_, i) => [7 * (i % N) + 10, 3 * Math.floor(i / N) + 60, i % N < 9 ? 230 : 20]).flat());

test("the right picture is right", () => {
  const { within, mean, largest, fits, isTruncated } = compare(right, right);
  assert.deepEqual({ within, mean, largest, fits, isTruncated }, { within: [1, 1, 1], mean: 0, largest: 0, fits: null, isTruncated: false });
});

test("shares are of pixels, by their worst colour", () => {
  const values = right.values.slice();
  values[0] += 1; // still within 1
  values[3] += 8;
  values[4] -= 2; // of the same pixel
  values[7] -= 40;
  const { within, mean, largest, heat } = compare(of(values), right);
  assert.deepEqual(within, [N * N - 2, N * N - 1, N * N - 1].map((count) => count / N ** 2));
  assert.equal(mean, 51 / (3 * N * N));
  assert.equal(largest, 40);
  const brightness = (pixel) => heat[4 * pixel] + heat[4 * pixel + 1] + heat[4 * pixel + 2];
  assert.ok(brightness(3) < brightness(0) && brightness(0) < brightness(1) && brightness(1) < brightness(2), "more deviation is brighter");
  assert.equal(heat[3], 255);
});

for (const [as, change] of FITS) {
  test(`a picture that is ${as} is told as that`, () => {
    const student = of(Array.from(right.values, (_, i) => Math.round(change(right, Math.floor(i / 3) % N, Math.floor(i / 3 / N), i % 3))));
    assert.equal(compare(student, right).fits?.as, as);
  });
}

test("bytes cut off, not rounded, are noticed, and are no deviation to be mended", () => {
  const { fits, isTruncated } = compare(of(right.values.map((value, i) => value - (i % 2))), right);
  assert.deepEqual({ fits, isTruncated }, { fits: null, isTruncated: true });
});

test("what no simple change mends is told as none", () => {
  assert.equal(compare(of(right.values.map((_, i) => (i * 101) % 256)), right).fits, null);
});

test("mistakes that act on a whole picture are some that there are", () => {
  const table = JSON.parse(readFileSync(new URL("../../build/raywalk/mistakes/mistakes.json", import.meta.url), "utf8"));
  const known = Object.values(table).flatMap((rows) => Object.keys(rows));
  for (const name of [...Object.keys(ON_WHOLE_PICTURES), "pixel-corner"]) assert.ok(known.includes(name), name);
});
