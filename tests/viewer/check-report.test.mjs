/** What is said of a picture, and in which order: the lines that page and command share. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { load, wordsOf } from "./typescript.mjs";

const { refused, reportOf, sentenceAlone, written } = await load("../check/main.ts");
const EN = wordsOf("en").check;

const NAMES = { scene: "Shadows", objects: ["red ball", "mirror A"], mistakes: { near: { title: "Near for far", right: "t > 0", wrong: "t < 0" }, far: { title: "Far for near", right: "near", wrong: "far" } }, scenes: { glass: "Glass" } };
const picture = { width: 105, height: 105, isLossy: false, hadAlpha: false };
const comparison = { within: [0.5, 0.75, 1], mean: 3.14159, largest: 31, fits: null, isTruncated: false };
const wrong = {
  isRight: false, isPair: false, areBeside: false, apart: null, comparison, answers: [{ names: ["near", "far"], agreement: 0.875 }, { names: ["far"], agreement: 0.6 }],
  where: { told: [{ kind: "object", object: 0, ofWrong: 0.9, ofPicture: 0.1 }], objects: [{ object: 0, wrong: 0.8, ofWrong: 0.996 }, { object: 1, wrong: 0.1, ofWrong: 0.004 }] },
  tiles: [{ n: 15, x: 3, y: 4, object: -1, own: [1, 2, 3], right: [4, 5, 6] }],
};
const found = (changes = {}, checked = {}) => ({
  file: { name: "mine.png", width: 105, height: 105 }, square: { picture, isCut: false }, source: { from: 1155, isExact: true }, leftOut: "", nearest: 105, ...changes, checked: { ...wrong, ...checked },
});
const kinds = (lines) => lines.map(({ part, kind }) => `${part} ${kind}`);

test("a wrong picture's lines: how right, where, what it looks like, walk it", () => {
  const lines = reportOf(found(), NAMES);
  const numbers = Array(5).fill("how number");
  const expected = ["verdict verdict", "verdict note", "verdict note", "how head", ...numbers, "where head", "where place", "where columns", "where object", "looks head", "looks says", "looks answer", "looks line", "looks line", "looks alike", "looks answer", "looks line", "walk head", "walk says", "walk tile"];
  assert.deepEqual(kinds(lines), expected, "an object with 0.4 % of the wrong pixels is not told");
});

test("a right one's are its verdict and its numbers", () => {
  const lines = reportOf(found({}, { isRight: true }), NAMES);
  assert.deepEqual(kinds(lines), ["verdict verdict", "verdict note", "verdict note", "how head", ...Array(5).fill("how number")]);
  assert.equal(lines[0].words, EN.verdict.right);
});

test("what looks right at a size without a right picture is not called right", () => {
  const lines = reportOf(found({ source: { from: 1155, isExact: false }, nearest: 128 }, { isRight: true }), NAMES);
  assert.equal(lines[0].words, EN.verdict.nearly);
  assert.ok(lines.some(({ words }) => words.includes("128")) && !lines.some(({ words }) => words === EN.verdict.rightSays));
});

test("under two in a hundred wrong pixels are nearly none", () => {
  const verdict = (share) => reportOf(found({}, { comparison: { ...comparison, within: [1 - share, 1, 1] } }), NAMES)[0].words;
  assert.match(verdict(0.019), /^Nearly right/);
  assert.match(verdict(0.021), /^Not right yet/);
});

test("what is to be known of the picture is said once each", () => {
  const square = { picture: { ...picture, isLossy: true, hadAlpha: true }, isCut: true };
  const lines = reportOf(found({ square }, { comparison: { ...comparison, isTruncated: true } }), NAMES);
  const notes = lines.filter(({ kind }) => kind === "note").map(({ words }) => words);
  assert.equal(notes.length, 6);
  for (const words of [EN.verdict.lossy, EN.verdict.alpha, EN.how.truncated]) assert.ok(notes.includes(words));
});

test("right below the verdict stands what it looks most like, one mistake or two, and which scene it was compared with", () => {
  const notes = (isPair) => reportOf(found({}, { isPair }), NAMES).filter(({ kind }) => kind === "note").map(({ words }) => words);
  const file = "mine.png, 105 × 105 pixels, compared with the scene “Shadows”";
  assert.deepEqual(notes(false), ["It looks most like this mistake: Near for far / Far for near.", file]);
  assert.deepEqual(notes(true), ["It looks most like two mistakes together: Near for far / Far for near, and Far for near.", file]);
});

test("no mistake that is known, and none that is looked for, are two sentences", () => {
  const says = (leftOut) => reportOf(found({ leftOut }, { answers: [] }), NAMES).find(({ part, kind }) => part === "looks" && kind === "says").words;
  assert.deepEqual([says(""), says("meshes")], [EN.looks.none, EN.looks.left.meshes]);
});

test("as text a line is its words and its values; a mistake is named for programs, too", () => {
  const lines = written(reportOf(found(), NAMES));
  assert.ok(lines.includes("  Near for far (near) / Far for near (far): 87.5\u202f% agreement"), lines.join("\n"));
  assert.ok(lines.includes("    The line to look for (far): near, not far"));
  assert.ok(lines.includes("  red ball: 80\u202f%, 99.6\u202f%"));
  assert.ok(lines.includes("  Tile 3, 4 of 15 × 15: background: yours (1, 2, 3), right (4, 5, 6)"));
});

test("of mistakes that look the same it is said which scene tells them apart, if one is known", () => {
  const says = (apartIn) => reportOf(found({ apartIn }), NAMES).find(({ kind }) => kind === "alike").words;
  assert.deepEqual([says(() => "glass"), says(() => null), says()], [EN.looks.alikeBut.replace("{scene}", "Glass"), EN.looks.alike, EN.looks.alike]);
});

test("what tells the second answer from the first stands below it, with what each makes there", () => {
  const place = { kind: "object", object: 0, ofWrong: 1, ofPicture: 0.1 };
  const lines = reportOf(found({}, { apart: { place, x: 7, y: 8, first: [1, 2, 3], second: [4, 5, 6], own: [1, 2, 4] } }), NAMES);
  const at = lines.findIndex(({ kind }) => kind === "apart");
  assert.ok(lines.slice(0, at).filter(({ kind }) => kind === "answer").length === 2 && lines[at + 1].part === "walk");
  assert.equal(lines[at].words, "To tell the first from the second, look on the red ball: at column 7, row 8 the first makes (1, 2, 3), the second (4, 5, 6); yours has (1, 2, 4).");
});

test("where no pixel's centre is a tile's, that is said", () => {
  const says = (areBeside) => reportOf(found({}, { areBeside }), NAMES).filter(({ kind }) => kind === "beside").map(({ words }) => words);
  assert.deepEqual(says(false), []);
  assert.match(says(true)[0], /^None of your 105 × 105 pixels .* 15 × 15 tiles/);
});

test("what cannot be compared is one line", () => {
  const sentence = refused({ word: "tall", figures: { width: 20, height: 30, least: 5 } });
  assert.deepEqual(written(sentenceAlone(sentence)), [sentence]);
  assert.match(sentence, /^The picture is 20 by 30 pixels/);
});
