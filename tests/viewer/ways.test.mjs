/** The way from the eye to what a pixel shows: mirrors and glass by name, in both languages. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { load, wordsOf } from "./typescript.mjs";

const { wayWords } = await load("way-words.ts");
const by = (name) => ({ what: "reflected", name, enters: true });
const into = (name) => ({ what: "refracted", name, enters: true });
const outOf = (name) => ({ what: "refracted", name, enters: false });
const inside = (what, name) => ({ what, name, enters: false });

test("mirrors are named one after the other", () => {
  assert.equal(wayWords([]), "");
  assert.equal(wayWords([by("left mirror"), by("ball")]), "by the left mirror, by the ball");
});

test("into glass and straight out again is through it; what is mirrored within it says so", () => {
  assert.equal(wayWords([into("glass ball"), outOf("glass ball")]), "through the glass ball");
  for (const what of ["reflected", "total"]) assert.equal(wayWords([into("glass ball"), inside(what, "glass ball"), outOf("glass ball")]), "into the glass ball, mirrored inside, out of the glass ball");
  assert.equal(wayWords([into("glass ball"), into("drop"), outOf("drop"), outOf("glass ball")]), "into the glass ball, through the drop, out of the glass ball");
});

test("of a long way the first surfaces and the last are named, and how many more there are", () => {
  const long = ["mirror A", "mirror B", "mirror A", "mirror B", "mirror A", "mirror B"].map(by);
  assert.equal(wayWords(long.slice(0, 4)), "by mirror A, by mirror B, by mirror A, by mirror B");
  assert.equal(wayWords(long), "by mirror A, by mirror B, 3 more, by mirror B");
});

test("German names them too", () => {
  globalThis.raywalkWords = wordsOf("de");
  assert.equal(wayWords([by("Spiegel A"), into("Glaskugel"), outOf("Glaskugel")]), "über „Spiegel A“; durch „Glaskugel“");
});
