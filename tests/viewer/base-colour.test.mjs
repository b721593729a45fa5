/** Base colours in the viewer: shown with every hit, kept by every switch; it is given colours, no picture to look them up in. */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { gunzipSync } from "node:zlib";
import { load } from "./typescript.mjs";

const { createWhatIf } = await load("state/what-if.ts");
const { writeSwitches } = await load("state/switches.ts");
const { decode } = await load("trace/decode.ts");
const { eventsOf } = await load("state/events.ts");
const { rayRows } = await load("state/ray-rows.ts");
const { captionOf } = await load("event-words.ts");
const { treeTable, treeText } = await load("panels/copies.ts");
const PYTHON = [process.env.RAYWALK_PYTHON, ".venv/bin/python"].find((path) => path && existsSync(path));

const folder = mkdtempSync(join(tmpdir(), "based-"));
after(() => rmSync(folder, { recursive: true }));
const built = JSON.parse(execFileSync(PYTHON, ["tests/viewer/based_scene.py", folder], { maxBuffer: 1 << 26 }));
const read = (name) => JSON.parse(gunzipSync(Buffer.from(readFileSync(join(folder, `${name}.js`), "utf8").split('"')[3], "base64")));
const scene = read("scene");
const header = read(built.n);
const trace = decode(header, { scene: built.scene, n: built.n });
const pixels = Array.from({ length: built.n ** 2 }, (_, k) => k);
const first = (name) => pixels.find((pixel) => scene.objects[trace.object[pixel]]?.name === name);

test("of three objects with base colours many rays have one of their own, all others 1; no picture is shipped", () => {
  assert.deepEqual(scene.objects.filter(({ base }) => base).map(({ name }) => name), ["ball", "floor", "tetra"]);
  const found = new Set();
  for (let ray = 0; ray < trace.count; ray++) {
    const base = [...trace.base.subarray(3 * ray, 3 * ray + 3)];
    if (scene.objects[trace.object[ray]]?.base) found.add(base.join());
    else assert.deepEqual(base, [1, 1, 1]);
  }
  assert.ok(found.size > 150, `${found.size} different`);
  assert.ok(!JSON.stringify(scene).includes("noise"));
});

test("every colour is the sum of its ray's terms with the base colour in ambient and diffuse", () => {
  for (const pixel of pixels)
    for (const row of rayRows(trace, scene, pixel)) {
      if (!row.lights.length) continue;
      const sum = [0, 1, 2].map((c) => row.ambient[c] + row.lights.reduce((all, { gives }) => all + gives[c], 0));
      assert.ok(sum.every((value, c) => Math.abs(value - row.local[c]) < 1e-12));
      const own = scene.materials[trace.material[row.ray]];
      assert.deepEqual(row.ambient, own.ambient.map((value, c) => value * (row.base?.[c] ?? 1)));
    }
});

test("card, copies and the player tell the base colour where there is one", () => {
  const rows = rayRows(trace, scene, first("tetra"));
  const words = /base colour \S/;
  assert.match(treeText("", rows), words);
  assert.match(treeTable(rows).split("\r\n")[0], /,base_r,base_g,base_b,ambient_r/);
  const local = (pixel) => eventsOf(trace, scene, pixel).filter(({ what }) => what === "local").map((event) => captionOf(event).numbers);
  assert.match(local(first("tetra"))[0], words);
  assert.doesNotMatch(local(first("plain"))[0], words);
  assert.equal(rayRows(trace, scene, first("plain"))[0].base, null);
});

test(`the tiles with any of ${built.fresh.length} settings of switches are what a fresh trace gives, within 1 of 255`, () => {
  const whatIf = createWhatIf();
  for (const { switches, tiles } of built.fresh) {
    const expected = Buffer.from(tiles, "base64");
    const got = whatIf.of(trace, scene, switches).trace.tiles;
    const most = got.reduce((worst, value, k) => Math.max(worst, Math.abs(value - expected[k])), 0);
    assert.ok(most <= 1, `${writeSwitches(switches)}: ${most} of 255 off`);
  }
});
