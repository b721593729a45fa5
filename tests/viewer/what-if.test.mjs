/** What-if switches against the tracer: the viewer recombines stored terms, the pipeline traces anew. */
import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { existsSync } from "node:fs";
import { test } from "node:test";
import { promisify } from "node:util";
import { scenesOfSite } from "./browser.mjs";
import { readTrace } from "./scene-files.mjs";
import { load } from "./typescript.mjs";

const { createWhatIf } = await load("state/what-if.ts");
const { AS_TRACED, lampsOf, partsOf, readSwitches, setLamp, stepBounces, switchesFrom, turnPart, turnShadows, writeSwitches } = await load("state/switches.ts");
const PYTHON = [process.env.RAYWALK_PYTHON, ".venv/bin/python"].find((path) => path && existsSync(path));
// Both round to 8 bits: a term stored a fifth of half a step off may tip a value over the edge.
const APART = 1;

const ids = scenesOfSite().map(({ id }) => id);
const fresh = await promisify(execFile)(PYTHON, ["tests/viewer/fresh_traces.py", ...ids], { maxBuffer: 1 << 28 }).then(({ stdout }) => stdout.trim().split("\n").map((line) => JSON.parse(line)));

for (const id of ids)
  test(`${id}: the tiles with any switch set are what a fresh trace of the scene altered so gives`, () => {
    const ofScene = fresh.filter(({ scene }) => scene === id);
    assert.ok(ofScene.length > 10, "fresh traces are there");
    let worst = 0;
    for (const n of new Set(ofScene.map((each) => each.n))) {
      const { scene, trace } = readTrace(id, n);
      const whatIf = createWhatIf();
      for (const { switches, tiles } of ofScene.filter((each) => each.n === n)) {
        const expected = Buffer.from(tiles, "base64");
        const got = whatIf.of(trace, scene, switches).trace.tiles;
        const off = got.map((value, k) => Math.abs(value - expected[k]));
        const most = off.reduce((a, b) => Math.max(a, b), 0);
        worst = Math.max(worst, most);
        assert.ok(most <= APART, `${n} x ${n}, ${writeSwitches(switches)}: tile ${Math.floor(off.indexOf(most) / 3)} is ${most} of 255 off`);
      }
    }
    console.log(`# ${id}: ${ofScene.length} fresh traces, at most ${worst} of 255 apart`);
  });
