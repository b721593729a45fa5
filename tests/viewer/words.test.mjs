/** Numbers and sentences: the compiler knows each key and its slots, and numbers are written as Python writes them. */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { tmpdir } from "node:os";
import { test } from "node:test";
import { load, VIEWER } from "./typescript.mjs";

const { fixed, number, vector, tone, percent, grouped, say, phrases, plain } = await load("words.ts");

test("Python writes every number as the viewer does, halves and signs too", () => {
  const values = [0, -0, 0.0005, -0.0005, 0.0625, -0.0625, 1.0005, 2.5, 12.3456, -1e-9, 1e-9, 0.99951, 1155, 123456.7891, 1 / 3, -2 / 3, 0.125, 0.005, 1.005, 8.345];
  let seed = 20261122; // a small generator: the same values every time
  for (let k = 0; k < 2000; k++) values.push((((seed = (Math.imul(seed, 1664525) + 1013904223) | 0) / 2 ** 31) * 10 ** (k % 7)) / 1000);
  const ours = values.flatMap((v) => [number(v), fixed(v, 1), fixed(v, 2), percent(v), vector([v, -v, 0]), tone([v, v, v]), grouped(Math.abs(Math.round(v)))]);
  const script = `import json,sys
from raywalk.words import read_words
n = read_words().numbers
out = []
for v in json.load(sys.stdin):
    out += [n.number(v), n.fixed(v, 1), n.fixed(v, 2), n.percent(v), n.vector([v, -v, 0]), n.tone([v, v, v]), n.grouped(abs(int(v // 1 + (v % 1 >= 0.5))))]
print(json.dumps(out))`;
  const theirs = JSON.parse(execFileSync(".venv/bin/python", ["-c", script], { input: JSON.stringify(values) }));
  assert.deepEqual(theirs, ours);
});

test("the compiler refuses an unknown key, a missing slot and one too many", () => {
  const folder = mkdtempSync(join(tmpdir(), "words-"));
  const lines = ['say("card.none");', 'say("card.t", { t: 1 });', 'say("no.such");', 'say("card.t");', 'say("card.t", { u: 1 });', 'say("card.none", { t: 1 });', 'phrases("event.away.says");'];
  writeFileSync(join(folder, "tries.ts"), `import { phrases, say } from "${resolve(VIEWER, "words")}";\n${lines.join("\n")}\n`);
  const config = { extends: resolve(VIEWER, "tsconfig.json"), include: [join(folder, "tries.ts")] };
  writeFileSync(join(folder, "tsconfig.json"), JSON.stringify(config));
  execFileSync("node", ["site_src/word-keys.mjs"]);
  let said = "";
  try {
    execFileSync("node_modules/.bin/tsc", ["--noEmit", "-p", folder], { encoding: "utf8" });
  } catch (error) {
    said = error.stdout;
  }
  const refused = [...said.matchAll(/tries\.ts\((\d+),/g)].map((match) => Number(match[1]));
  assert.deepEqual([...new Set(refused)], [4, 5, 6, 7, 8], said);
});

test("plurals choose by the count, marks by the sentence and never by what fills a slot", () => {
  assert.deepEqual([1, 2].map((count) => say("card.more", { count })), ["and 1 more ray", "and 2 more rays"]);
  const made = phrases("event.meets.says", { name: "**{t}** [x](camera)" });
  assert.deepEqual(made, ["It meets ", ["**{t}** [x](camera)", ""], "."]);
  assert.equal(plain(made), "It meets **{t}** [x](camera).");
});

