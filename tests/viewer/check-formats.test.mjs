/** Files that a student may drop on the page of checks: every format, and what is wrong with hostile ones. */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { BYTES, GOOD, GREY_BYTES, HEIGHT, HOSTILE, text, WIDTH } from "./picture-files.mjs";
import { load } from "./typescript.mjs";

const { pictureOrSentence, readPicture } = await load("../check/main.ts");

for (const [name, bytes, { grey, within = 1e-3, alpha = false, lossy = false } = {}] of GOOD) {
  test(`${name} is read`, () => {
    const picture = readPicture(bytes);
    const expected = lossy ? Float32Array.from({ length: BYTES.length }, (_, i) => 90 + Math.floor(i / 3)) : grey ? GREY_BYTES : BYTES;
    assert.deepEqual([picture.width, picture.height, picture.hadAlpha, picture.isLossy], [WIDTH, HEIGHT, alpha, lossy]);
    assert.equal(picture.values.length, expected.length);
    const worst = Math.max(...expected.map((value, i) => Math.abs(value - picture.values[i])));
    assert.ok(worst <= (lossy ? 3 : within), `it is ${worst} steps of 255 away`); // JPEG at quality 100 still rounds frequencies
  });
}

test("r, g, b a line make a square", () => {
  const { width, height, values } = readPicture(text("r;g;b\n0;0;0\n255;0;0\n0;255;0\n0;0;255\n"));
  assert.deepEqual([width, height, [...values]], [2, 2, [0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0, 255]]);
});

test("a picture of one pixel is read", () => assert.deepEqual([...readPicture(text("12 34 56")).values], [12, 34, 56]));

test("a dark picture of whole numbers keeps its scale, one of fractions is a share of white", () => {
  assert.deepEqual([...readPicture(text("1 0 1")).values], [1, 0, 1]);
  assert.deepEqual([...readPicture(text("0.2 0 1.5")).values], [51, 0, 255]);
});

for (const [name, bytes, word] of HOSTILE) {
  test(`${name}: ${word || "is read"}`, () => {
    const before = process.cpuUsage();
    const { fault, sentence, picture } = pictureOrSentence(bytes);
    const { user, system } = process.cpuUsage(before);
    assert.equal(fault?.word ?? "", word, sentence);
    if (word) assert.match(sentence, /^[A-Z][^{}]+[.?]$/, "a sentence without open slots");
    else assert.equal(picture.width, WIDTH);
    assert.ok(user + system < 1e6, `${(user + system) / 1e6} s of work`);
  });
}

test("all hostile files together need less than 200 MB", () => {
  const folder = mkdtempSync(join(tmpdir(), "raywalk-hostile-"));
  HOSTILE.forEach(([, bytes], i) => writeFileSync(join(folder, `${i}`), bytes)); // read anew: making a bomb takes as much as it holds
  const script = `import { readdirSync, readFileSync } from "node:fs";
    const { load } = await import(${JSON.stringify(fileURLToPath(new URL("typescript.mjs", import.meta.url)))});
    const { pictureOrSentence } = await load("../check/main.ts");
    const before = process.resourceUsage().maxRSS;
    for (const name of readdirSync(${JSON.stringify(folder)})) pictureOrSentence(readFileSync(${JSON.stringify(folder)} + "/" + name));
    console.log(process.resourceUsage().maxRSS - before);`;
  const more = Number(execFileSync("node", ["--input-type=module", "-e", script], { encoding: "utf8" })) / 1024;
  rmSync(folder, { recursive: true });
  assert.ok(more < 200, `${more} MB`);
  console.log(`# ${Math.round(more)} MB`);
});
