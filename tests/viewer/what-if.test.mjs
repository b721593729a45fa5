/** What-if switches against the tracer: the viewer recombines stored terms, the pipeline traces anew. */
import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { existsSync } from "node:fs";
import { test } from "node:test";
import { promisify } from "node:util";
import { keyedScenes, scenesOfSite } from "./browser.mjs";
import { read, readScene, readTrace } from "./scene-files.mjs";
import { load } from "./typescript.mjs";

const { createWhatIf, decode, sceneAt, wholeAgain } = await load("state/what-if.ts", "trace/decode.ts", "state/swept.ts", "trace/whole.ts");
const { AS_TRACED, lampsOf, partsOf, readSwitches, setLamp, stepBounces, switchesFrom, turnPart, turnShadows, writeSwitches } = await load("state/switches.ts", "state/switching.ts", "state/switchable.ts");
const PYTHON = [process.env.RAYWALK_PYTHON, ".venv/bin/python"].find((path) => path && existsSync(path));
// Both round to 8 bits: a term stored a fifth of half a step off may tip a value over the edge.
const APART = 1;

const keyed = keyedScenes().map(({ id }) => id);
const moving = scenesOfSite().map(({ id }) => id).filter((id) => {
  const scene = readScene(id);
  // A lamp of many points is switched as one: fresh_traces.py knows points alone.
  return scene.of === id && scene.sweeps && lampsOf(scene).length === scene.lights.length;
});
const fresh = await promisify(execFile)(PYTHON, ["tests/viewer/fresh_traces.py", ...new Set([...keyed, ...moving])], { maxBuffer: 1 << 28 }).then(({ stdout }) => stdout.trim().split("\n").map((line) => JSON.parse(line)));

const LEVELS = [5, 7, 11, 15, 21, 33, 105];
/** The tiles of a grid, out of a finer one that it divides by an odd number: they are the middle pixels of its blocks. */
function coarser(tiles, from, to) {
  const [step, out] = [from / to, new Uint8Array(3 * to * to)];
  for (let k = 0; k < to * to; k++) {
    const at = ((Math.floor(k / to) + 0.5) * step - 0.5) * from + ((k % to) + 0.5) * step - 0.5;
    out.set(tiles.subarray(3 * at, 3 * at + 3), 3 * k);
  }
  return out;
}

for (const id of moving)
  test(`${id}: at a stop, too, the tiles with any switch set are what a fresh trace of the scene there gives`, () => {
    const ofStops = fresh.filter(({ scene, at }) => scene === id && at);
    assert.ok(ofStops.length > 10, "fresh traces are there");
    const scene = readScene(id);
    const whatIf = createWhatIf();
    const known = new Map();
    for (const { at, n, switches, tiles } of ofStops) {
      const [sweep, stop] = at.split(":");
      const there = known.get(at) ?? sceneAt(scene, read(`${id}/${sweep}/stops`).stops[stop - 1], sweep, stop);
      const trace = known.get(`${at} ${n}`) ?? decode(wholeAgain(read(`${id}/${sweep}/${n}`).stops)[stop - 1], { scene: id, n });
      known.set(at, there).set(`${at} ${n}`, trace);
      const expected = Buffer.from(tiles, "base64");
      whatIf.of(trace, there, switches).trace.tiles.forEach((value, k) => assert.ok(Math.abs(value - expected[k]) <= APART, `${at}, ${writeSwitches(switches)}: tile ${Math.floor(k / 3)} is ${value}, not ${expected[k]}`));
    }
  });

for (const id of keyed)
  test(`${id}: the tiles with any switch set are what a fresh trace of the scene altered so gives, at every level`, () => {
    const ofScene = fresh.filter(({ scene, at }) => scene === id && !at);
    assert.ok(ofScene.length > 10, "fresh traces are there");
    const traced = [...new Set(ofScene.map(({ n }) => n))];
    let [worst, compared] = [0, []];
    for (const n of LEVELS) {
      const source = traced.find((from) => from % n === 0 && (from / n) % 2 === 1);
      if (!source || !readScene(id).levels.includes(n)) continue;
      compared.push(n);
      const { scene, trace } = readTrace(id, n);
      const whatIf = createWhatIf();
      for (const { switches, tiles } of ofScene.filter((each) => each.n === source)) {
        const expected = coarser(Buffer.from(tiles, "base64"), source, n);
        const got = whatIf.of(trace, scene, switches).trace.tiles;
        const off = got.map((value, k) => Math.abs(value - expected[k]));
        const most = off.reduce((a, b) => Math.max(a, b), 0);
        worst = Math.max(worst, most);
        assert.ok(most <= APART, `${n} x ${n}, ${writeSwitches(switches)}: tile ${Math.floor(off.indexOf(most) / 3)} is ${most} of 255 off`);
      }
    }
    assert.ok(compared.length >= 6, `levels ${compared}`);
    console.log(`# ${id}: ${ofScene.length} fresh traces, levels ${compared.join(", ")}, at most ${worst} of 255 apart`);
  });
