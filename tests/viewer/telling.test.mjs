/** The player and `raywalk inspect --events` tell the same: every event's sentence and numbers, character by character. */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { after, before, test } from "node:test";
import { DIST, follow, launch, newPage, ON_DISK, open, press, scenesOfSite, state, stats } from "./browser.mjs";
import { readTrace } from "./scene-files.mjs";
import { load } from "./typescript.mjs";

const { eventsOf } = await load("state/events.ts");
const { tell, sentence } = await load("event-words.ts");

/** Key of a scene, pixel of its 15 x 15 grid, what must happen there. */
const PIXELS = [
  ["1", [0, 0], ["background"]],
  ["2", [8, 8], ["blocked"]],
  ["3", [7, 7], ["blocked"]],
  ["4", [9, 7], ["reflected", "stops"]], // the most bounces are reached
  ["5", [9, 7], ["reflected", "gather"]],
  ["6", [8, 3], ["away"]],
  ["7", [6, 10], ["blocked"]],
  ["8", [2, 11], ["refracted", "total", "gather"]],
  ["9", [11, 10], ["refracted", "total", "stops", "blocked"]],
  ["0", [7, 11], ["refracted", "reflected", "blocked"]],
];
const scenes = new Map(scenesOfSite().map((scene) => [scene.key, scene]));
const isWholeSite = PIXELS.every(([key]) => scenes.has(key));
const PAGE = "\f"; // between one command's output and the next: one process is ten times as quick as ten
const commands = PIXELS.filter(([key]) => scenes.has(key)).map(([key, pixel]) => ["inspect", `${DIST}/scenes/${scenes.get(key).id}/15.js`, "--pixel", pixel.join(","), "--events"]);
const python = (script, ...words) => execFileSync(".venv/bin/python", ["-c", script, ...words], { encoding: "utf8", maxBuffer: 2 ** 28 });
const outputs = python(`import json, sys
from raywalk.__main__ import main
for command in json.loads(sys.argv[1]):
    assert main(command) == 0
    print("\\f", end="", flush=True)`, JSON.stringify(commands)).split(PAGE);
const printed = (key) =>
  outputs[PIXELS.filter(([each]) => scenes.has(each)).findIndex(([each]) => each === key)]
    .trimEnd()
    .split(/^ *\d+ {2}/m)
    .slice(1)
    .map((text) => text.trimEnd().split("\n     "));

let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser, { viewport: { width: 800, height: 500 } }); // small: drawn in less time
});
after(() => browser.close());

for (const [key, pixel, happens] of PIXELS) {
  if (!scenes.has(key)) continue;
  const { id, path } = scenes.get(key);
  test(`${id}, pixel ${pixel}: what the player shows, step by step, is what inspect prints`, async () => {
    const lines = printed(key);
    await open(page, ON_DISK, path, `still=1&slice=row&gl=none&n=15&p=${pixel}`); // sentences are the same beside a flat drawing, which takes no time
    const { events } = await stats(page);
    assert.deepEqual(happens.filter((what) => !events.some((event) => event.what === what)), []);
    assert.equal(lines.length, events.length);
    for (const [k, [says, numbers = ""]] of lines.entries()) {
      await press(page, ".");
      assert.equal((await state(page)).event, k);
      const shown = await page.evaluate(() => [".event-says", ".event-numbers"].map((each) => document.querySelector(`.lesson-text ${each}`)?.textContent ?? ""));
      assert.deepEqual(shown, [says, numbers], `event ${k + 1}`);
    }
  });
}

test("the ten pixels are over all scenes of the site", () => assert.deepEqual([...scenes.keys()].filter((key) => key && isWholeSite && !PIXELS.some(([of]) => of === key)), []));

const GRID = 7; // 49 pixels of each scene, of the picture's middle and of its edges
test(`of every scene, events, sentences and numbers of all pixels of a ${GRID} x ${GRID} grid are the same in Python`, () => {
  const ids = [...scenes.values()].map(({ id }) => id);
  const script = `import json, sys
from pathlib import Path
from raywalk.telling import events_of, scene_beside, tell
from raywalk.trace_file import read_trace
from raywalk.words import read_words
words, n = read_words(), int(sys.argv[1])
def told(event):
    each = tell(event, words)
    return [event.what, event.ray, event.light, event.line, each.sentence, each.numbers, [list(p) for p in each.says]]
def of(path):
    trace, scene = read_trace(path), scene_beside(path)
    return [[told(e) for e in events_of(trace, scene, (p % n, p // n))] for p in range(n * n)]
print(json.dumps([of(Path(each)) for each in sys.argv[2:]]))`;
  const theirs = JSON.parse(python(script, String(GRID), ...ids.map((id) => `${DIST}/scenes/${id}/${GRID}.js`)));
  const phrase = (each) => (typeof each === "string" ? [each, null] : [...each]);
  for (const [k, id] of ids.entries()) {
    const { scene, trace } = readTrace(id, GRID);
    for (let pixel = 0; pixel < GRID * GRID; pixel++) {
      const ours = eventsOf(trace, scene, pixel).map((event) => {
        const { says, numbers } = tell(event);
        return [event.what, event.ray, event.light, event.line, sentence(event), numbers, says.map(phrase)];
      });
      assert.deepEqual(theirs[k][pixel], ours, `${id}, pixel ${pixel}`);
    }
  }
});

test("nothing was said in the console", () => assert.deepEqual(page.faults, []));
