/** What is shipped holds no ray code, and no source outgrows its reader. */
import assert from "node:assert/strict";
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { raysLeftIn, withoutRays } from "../../site_src/strip-rays.mjs";
import { DIST } from "./browser.mjs";
import { VIEWER } from "./typescript.mjs";
import { readScene } from "./scene-files.mjs";

const sources = readdirSync(VIEWER, { recursive: true }).filter((file) => file.endsWith(".ts"));
const text = (file) => readFileSync(join(VIEWER, file), "utf8");

test("three's ray methods are taken out, and its yes/no questions answer yes", () => {
  const stripped = withoutRays(
    "class Mesh { raycast(a) { return a.hit; } draw() { return 1; } }\nclass Box { intersectsSphere(s) { return s.r > 1; } intersect(b) { return b; } }\nclass Ray { recast(t) { return t; } at(t) { return t; } copy() { return this; } }",
  );
  assert.doesNotMatch(stripped, /raycast|recast|hit|at\(t\)/);
  assert.match(stripped, /draw\(\) \{ return 1; \}/);
  assert.match(stripped, /intersectsSphere\(s\) \{ return true; \}/);
  assert.deepEqual(raysLeftIn(stripped), []);
  assert.deepEqual(raysLeftIn("class M { raycast(a) { return a.b; } }"), ["raycast"]);
});

test("no shipped script holds any of it", () => {
  for (const name of readdirSync(`${DIST}/assets`).filter((each) => each.endsWith(".js") && !each.startsWith("words-"))) {
    const bundle = readFileSync(`${DIST}/assets/${name}`, "utf8");
    assert.deepEqual(raysLeftIn(bundle), [], name);
    assert.doesNotMatch(bundle, /\braycast\b|intersectTriangle|intersectSphere\b/, name);
  }
});

test("the pages hold no inline script, no inline style, and a strict policy", () => {
  for (const file of readdirSync(DIST, { recursive: true }).filter((each) => /^(index|scenes\/[^/]+\/index)\.html$/.test(each))) {
    const page = readFileSync(join(DIST, file), "utf8");
    const own = page.replace(/<(?:link rel="canonical"|meta property="og:)[^>]*>/g, ""); // absolute, where the site knows its address
    assert.doesNotMatch(own, /<script(?![^>]*\bsrc=)|<style|\sstyle=|\son\w+=|https?:\/\//, file);
    assert.match(page, /default-src 'none'; script-src 'self'; style-src 'self'/, file);
  }
});

test("no file outgrows 350 lines", () => {
  for (const file of sources.filter((each) => !each.endsWith(".d.ts"))) assert.ok(text(file).split("\n").length <= 350, file); // those are made
});

test("every scene has its page, picture, data and grids", () => {
  for (const id of readdirSync(`${DIST}/scenes`)) for (const file of ["index.html", "scene.js", ...(readScene(id).of === id ? ["picture.png"] : [])]) assert.ok(existsSync(`${DIST}/scenes/${id}/${file}`), `${id}/${file}`);
});
