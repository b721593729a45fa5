/** The viewer reads trace files, and refuses what it must not show. glass-7.json.gz is a glass
 *  scene at 7 x 7, written by tests/trace_file's tiny tracer. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { loadDecoder } from "./bundle.mjs";

const { begin, decode, decodeWithRests, unpack, TraceError } = await loadDecoder();
const packed = readFileSync(new URL("./glass-7.json.gz", import.meta.url)).toString("base64");
const json = () => unpack(packed);
const refused = (code) => (error) => error instanceof TraceError && error.code === code;

test("a trace has its camera rays first, in raster order, and children after their parents", async () => {
  const trace = decode(await json());
  assert.equal(trace.n, 7);
  for (let k = 0; k < 49; k++) assert.deepEqual([trace.pixel[k], trace.parent[k], trace.kind[k]], [k, -1, 0]);
  for (let k = 49; k < trace.count; k++) {
    assert.ok(trace.parent[k] >= 0 && trace.parent[k] < k);
    assert.equal(trace.pixel[k], trace.pixel[trace.parent[k]]);
    assert.equal(trace.depth[k], trace.depth[trace.parent[k]] + 1);
  }
});

test("lengths, normals and weights are what they say", async () => {
  const trace = decode(await json());
  for (let k = 0; k < trace.count; k++) {
    const normal = [0, 1, 2].map((c) => trace.normal[3 * k + c]);
    if (trace.object[k] < 0) assert.equal(trace.t[k], Infinity);
    else assert.ok(Math.abs(Math.hypot(...normal) - 1) < 1e-12); // some roundings
    if (trace.parent[k] < 0) continue;
    const way = [0, 1, 2].map((c) => trace.point[3 * k + c] - trace.point[3 * trace.parent[k] + c]);
    if (trace.object[k] >= 0) assert.ok(Math.abs(Math.hypot(...way) - trace.t[k]) < 1e-12 * trace.t[k]);
    assert.ok(trace.weight[k] > 0 && trace.weight[k] <= 1);
  }
});

test("tiles are the rounded sums of their ray trees", async () => {
  const trace = decode(await json());
  for (let k = 0; k < 3 * 49; k++) {
    const sum = 255 * Math.min(1, Math.max(0, trace.colour[k]));
    assert.ok(Math.abs(trace.tiles[k] - sum) <= 0.5 + 0.1); // the colour's own error is 0.1 of 255
  }
});

test("tiles are there before the lights, and levels that are decoded by turns do not disturb each other", async () => {
  const whole = decode(await json());
  const [one, other] = [begin(await json()), begin(await json())];
  assert.deepEqual(one.tiles, whole.tiles);
  const [first, second] = [one.light(), other.light()];
  for (let l = 0; l < whole.lights; l++) for (const lights of [first, second]) assert.equal(lights.next().done, false);
  for (const lights of [second, first]) assert.deepEqual(lights.next(), { done: true, value: whole });
});

test("rests between the parts change nothing", async () => {
  let rests = 0;
  assert.deepEqual(await decodeWithRests(await json(), {}, async () => void rests++), decode(await json()));
  assert.ok(rests > 1);
});

test("what is left for later is known to be undamaged before", async () => {
  const good = await json();
  const columns = { ...good.columns, visibility1: `${good.columns.visibility1.slice(0, -1)}!` };
  assert.throws(() => begin({ ...good, columns }), refused("damaged"));
});

test("hits along a camera ray begin with what it met, and never go back", async () => {
  const trace = decode(await json());
  for (let k = 0; k < 49; k++) {
    const [start, end] = [trace.hitsStart[k], trace.hitsStart[k + 1]];
    if (trace.object[k] < 0) assert.equal(start, end);
    else assert.deepEqual([trace.hitsObject[start], trace.hitsT[start]], [trace.object[k], trace.t[k]]);
    for (let h = start + 1; h < end; h++) assert.ok(trace.hitsT[h] >= trace.hitsT[h - 1]);
  }
});

test("another version, scene, resolution or kind of file is refused with its code", async () => {
  const good = await json();
  assert.throws(() => decode({ ...good, version: 2 }), refused("version"));
  assert.throws(() => decode(good, { scene: "01-shading" }), refused("scene"));
  assert.throws(() => decode(good, { n: 5 }), refused("scene"));
  for (const other of [null, 7, [], {}, { format: "else" }]) {
    assert.throws(() => decode(other), refused("not-a-trace"));
  }
  assert.equal(decode(good, { scene: "90-test", n: 7 }).scene, "90-test");
});

test("a changed column and a header without a part are damaged", async () => {
  const good = await json();
  const columns = { ...good.columns, numbersa: `!${good.columns.numbersa.slice(1)}` };
  assert.throws(() => decode({ ...good, columns }), refused("damaged"));
  assert.throws(() => decode({ ...good, rays: good.rays + 1 }), refused("damaged"));
  assert.throws(() => decode({ ...good, rays: 1e300 }), refused("damaged"));
  for (const part of ["tables", "patches", "images", "materials", "steps", "camera", "columns"]) {
    assert.throws(() => decode({ ...good, [part]: undefined }), refused("damaged"), part);
  }
});

test("text that is cut, or no base64, or no gzip, is damaged", async () => {
  for (const text of [packed.slice(0, 400), "%%%", btoa("no gzip"), ""]) {
    await assert.rejects(unpack(text), refused("damaged"));
  }
});
