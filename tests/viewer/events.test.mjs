/** A pixel's events: their order, their number, and every number equal to the trace's. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { scenesOfSite } from "./browser.mjs";
import { readTrace } from "./scene-files.mjs";
import { load } from "./typescript.mjs";

const { eventsOf } = await load("state/events.ts");
const { treeOf, linesOf } = await load("state/lines.ts");
const { timelineOf, linesUpTo } = await load("state/timeline.ts");
const { advancePlay, goToEvent, goToTime, pressPlay, stepEvent, timeOf, NO_EVENT } = await load("state/play.ts");
const { startState, select } = await load("state/view-state.ts");
const { captionOf, sentence, whyDark, whyOf } = await load("event-words.ts");
const { allOf, phrases, plain } = await load("words.ts");

const DEPARTURES = ["camera", "reflected", "refracted", "total"];
const three = (values, k) => [...values.slice(3 * k, 3 * k + 3)];
const distance = (a, b) => Math.hypot(...a.map((v, k) => b[k] - v));
const close = (a, b, tolerance = 1e-12) => assert.ok(a.every((v, k) => Math.abs(v - b[k]) <= tolerance), `${a} is not ${b}`);
const sum = (terms) => terms.reduce((all, { share, colour }) => all.map((v, c) => v + share * colour[c]), [0, 0, 0]);

const walked = scenesOfSite().filter(({ key }) => ["1", "3", "5", "8"].includes(key));
const seen = new Set();
for (const { id } of walked) {
  const { scene, trace } = await readTrace(id, 15);
  const pixels = Array.from({ length: 225 }, (_, k) => k);
  const each = (check) => pixels.forEach((pixel) => check(eventsOf(trace, scene, pixel), treeOf(trace, pixel), pixel));

  test(`${id}: why a pixel is dark or lit does not hang on the order in which its events are given`, () =>
    each((events) => {
      const last = events.find(({ what }) => what === "pixel");
      const { before } = last;
      const turned = [...before].reverse();
      const mixed = before.map((_, k) => before[(7 * k + 3) % before.length]);
      assert.equal(new Set(mixed).size === before.length || before.length % 7 === 0, true);
      for (const order of [turned, ...(before.length % 7 ? [mixed] : [])]) assert.deepEqual(whyOf({ ...last, before: order }), whyOf(last));
    }));

  test(`${id}: every ray sets out and arrives once, and asks each light where it has a colour of its own`, () =>
    each((events, tree) => {
      const count = (...whats) => events.filter(({ what }) => whats.includes(what)).length;
      const own = tree.filter((ray) => trace.object[ray] >= 0 && trace.localWeight[ray] > 0);
      const parents = tree.filter((ray) => trace.parent[ray] >= 0 && tree.some((other) => trace.parent[other] === ray));
      assert.equal(count(...DEPARTURES), tree.length);
      assert.equal(count("meets", "background"), tree.length);
      assert.equal(count("reached", "blocked", "away", "unasked"), own.length * scene.lights.length);
      assert.equal(count("local"), own.length);
      assert.equal(count("gather"), parents.length);
      assert.equal(count("pixel"), 1);
      for (const { what } of events) seen.add(what);
    }));

  test(`${id}: the order is true: a ray sets out, arrives, asks the lights in turn, sends rays on, gathers`, () =>
    each((events, tree) => {
      const at = (ray, ...whats) => events.findIndex((event) => event.ray === ray && whats.includes(event.what));
      assert.equal(events[0].what, "camera");
      assert.equal(events.at(-1).what, "pixel");
      for (const ray of tree) {
        const leaves = at(ray, ...DEPARTURES);
        assert.ok(["meets", "background"].includes(events[leaves + 1].what) && events[leaves + 1].ray === ray);
        const asked = events.filter((event) => event.ray === ray && event.light >= 0);
        assert.deepEqual(asked.map(({ light }) => light), [...asked.keys()]);
        if (asked.length) assert.equal(at(ray, "local"), leaves + 2 + asked.length);
        const parent = trace.parent[ray];
        if (parent < 0) continue;
        assert.ok(leaves > at(parent, "meets") && leaves > at(parent, "local"));
        assert.ok(at(parent, "gather", "pixel") > at(ray, "meets", "background", "gather"));
      }
    }));

  test(`${id}: the numbers are the trace's`, () =>
    each((events, tree, pixel) => {
      for (const event of events) {
        const { ray, light } = event;
        const at = ray * trace.lights + light;
        if (event.what === "camera") assert.deepEqual([...event.pixel], [pixel % 15, Math.floor(pixel / 15)]);
        if (["reflected", "refracted", "total"].includes(event.what)) assert.equal(event.share, trace.weight[ray]);
        if (event.what === "meets") {
          assert.equal(event.t, trace.t[ray]);
          assert.deepEqual(event.point, three(trace.point, ray));
          assert.equal(event.name, scene.objects[trace.object[ray]].name);
          if (trace.parent[ray] < 0) {
            assert.deepEqual(event.hits.map(({ t }) => t), [...trace.hitsT.slice(trace.hitsStart[ray], trace.hitsStart[ray + 1])]);
            assert.ok(event.hits.every(({ t }) => t >= event.hits[0].t), "the nearest comes first");
          }
        }
        if (event.what === "blocked") {
          assert.equal(event.by, scene.objects[trace.blocker[at]].name);
          assert.equal(event.at, distance(three(trace.point, ray), scene.lights[light].position) * trace.blockedAt[at]);
        }
        if (event.what === "local")
          for (const [k, { diffuse, specular }] of event.lights.entries())
            assert.deepEqual([diffuse, specular], [trace.diffuse[ray * trace.lights + k], trace.specular[ray * trace.lights + k]]);
        if (event.what === "gather" || event.what === "pixel") {
          assert.deepEqual(event.colour, three(trace.colour, ray));
          close(sum(event.terms), event.colour); // the same sum, rounded in another order
        }
        if (event.what === "local" && !tree.some((other) => trace.parent[other] === ray)) close(sum([event]), three(trace.colour, ray));
        if (event.what === "pixel") assert.deepEqual(event.bytes, three(trace.tiles, pixel));
        if (event.long > 0) {
          const line = linesOf(trace, scene, pixel).find((each) => each.ray === ray && each.light === light);
          assert.ok(Math.abs(distance(line.from, line.to) - event.long) < 1e-9);
          assert.equal(line.kind, event.line);
        }
      }
    }));

  test(`${id}: the indices it names are those its rays bend by`, () =>
    each((events) => {
      for (const event of events) {
        const sine = (degrees) => Math.sin((degrees * Math.PI) / 180);
        // angles are measured between stored points, which the file rounds: 0.1 degrees, on either side
        if (event.what === "refracted" && event.angle !== null && event.bent !== null) assert.ok(Math.abs(event.from * sine(event.angle) - event.to * sine(event.bent)) < 4e-3, JSON.stringify(event));
        if (event.what === "total" && event.angle !== null) assert.ok(event.from * sine(event.angle) > event.to - 4e-3, JSON.stringify(event));
      }
    }));

  test(`${id}: each event has one sentence, and gone through, all lines of the pixel are there`, () =>
    each((events, tree, pixel) => {
      for (const event of events) {
        assert.match(sentence(event), /^\S.*\.$/);
        assert.doesNotMatch(`${sentence(event)} ${captionOf(event).numbers}`, /undefined|NaN|Infinity|\?/);
      }
      const timeline = timelineOf(trace, scene, pixel);
      const sorted = (lines) => lines.map(({ ray, light, to, growing }) => JSON.stringify([ray, light, to, growing])).sort();
      assert.deepEqual(sorted(linesUpTo(timeline, trace, scene, pixel, events.length - 1, 1)), sorted(linesOf(trace, scene, pixel)));
    }));
}

test("mirrors, glass, shadows, sums: the four scenes hold all that can happen", () => {
  const all = [...DEPARTURES, "meets", "background", "reached", "blocked", "away", "local", "gather", "pixel"];
  if (walked.length === 4) assert.deepEqual(all.filter((what) => !seen.has(what)), []);
});

const { scene, trace } = await readTrace(walked.at(-1).id, 15);
const timeline = timelineOf(trace, scene, 112);
const begun = pressPlay({ ...startState(scene, { speed: 1, still: false, gl: true }), n: 15 }, timeline);

test("of a large lamp's points those that give the same say so once, and all are counted", () => {
  const { scene, trace } = readTrace("15-soft-shadows-64", 15);
  const { numbers } = captionOf(eventsOf(trace, scene, 11 * 15 + 10).find(({ what }) => what === "local"));
  const counts = [...numbers.matchAll(/(\d+) lights, each/g)].map(([, count]) => Number(count));
  const single = [...numbers.matchAll(/lamp \d+\/64/g)].length;
  assert.equal(counts.reduce((sum, count) => sum + count, single), 64, numbers);
  assert.match(numbers, /\d+ lights, each: 0, in shadow/);
  assert.ok(numbers.length < 300, numbers);
});

test("playing, lines grow at one steady speed, the same at 60 and 120 frames a second", () => {
  let [slow, fast] = [begun, begun];
  const speeds = [];
  let before = 0;
  for (let k = 0; k < 600 && slow.playing; k++) {
    slow = advancePlay(slow, timeline, 1 / 60);
    fast = advancePlay(advancePlay(fast, timeline, 1 / 120), timeline, 1 / 120);
    assert.equal(slow.event, fast.event);
    assert.ok(Math.abs(slow.share - fast.share) < 1e-9);
    const growing = linesUpTo(timeline, trace, scene, 112, slow.event, slow.share).find((line) => line.growing);
    const long = growing ? distance(growing.from, growing.to) : 0;
    if (growing && before) speeds.push((long - before) * 60);
    before = long;
  }
  assert.ok(speeds.length > 20);
  for (const speed of speeds) assert.ok(Math.abs(speed - speeds[0]) < 1e-6, `${speed} and ${speeds[0]}`);
});

test("play goes to the end by itself and starts again from there; pause stays", () => {
  let state = advancePlay(begun, timeline, 1e6);
  assert.deepEqual([state.event, state.share, state.playing], [timeline.events.length - 1, 1, false]);
  assert.deepEqual([pressPlay(state, timeline).event, pressPlay(state, timeline).share], [0, 0]);
  state = pressPlay(advancePlay(begun, timeline, 1.234), timeline);
  assert.equal(advancePlay(state, timeline, 5), state);
  assert.ok(Math.abs(timeOf(state, timeline) - 1.234) < 1e-9);
  assert.ok(Math.abs(timeOf(goToTime(state, timeline, 7.5), timeline) - 7.5) < 1e-9);
});

test("stepping goes one by one, back out at the beginning, and stays at the end", () => {
  let state = startState(scene, { speed: 1, still: false, gl: true });
  assert.equal(stepEvent(state, timeline, -1), state);
  for (let k = 0; k < timeline.events.length + 2; k++) {
    state = stepEvent(state, timeline, 1);
    assert.equal(state.event, Math.min(k, timeline.events.length - 1));
  }
  assert.equal(stepEvent(goToEvent(state, timeline, 0), timeline, -1).event, null);
  const { event, share, playing } = select(state, state.pixel[0] + 1, 0);
  assert.deepEqual({ event, share, playing }, NO_EVENT);
});

test("a pixel that is dark or in shadow says why, through glass and mirrors too, and a lit one what lights it", () => {
  const said = { "02-shadows": [[[10, 8], "Dark because: the blue sphere blocks light 1."], [[8, 14], "Dark because: the red sphere faces away from light 1: no light can come from there."], [[4, 3], "Lit: light comes from light 1."]],
    "04-one-bounce": [[[10, 7], "Dark because: by mirror B: mirror A (100\u202f% of the pixel); there no bounce is left to send a ray on."]],
    "14-soft-shadows-16": [[[10, 11], "Shadow: the ball blocks 6 of 16 lights; light comes from 10 of 16 lights."]],
    "08-glass": [[[9, 10], "Dark because: through the glass sphere: the left wall (88\u202f% of the pixel); the orange sphere blocks the ceiling light; little comes from the front light."], [[12, 8], "Lit: through the glass slab, by the mirror sphere: the right wall (91.7\u202f% of the pixel); light comes from the front light and the ceiling light."]] };
  for (const [id, pixels] of Object.entries(said).filter(([id]) => scenesOfSite().some((scene) => scene.id === id))) {
    const { scene, trace } = readTrace(id, 15);
    for (const [[column, row], says] of pixels) {
      assert.equal(plain(whyDark(whyOf(eventsOf(trace, scene, row * 15 + column).at(-1)))), says, `${id}, pixel ${column}, ${row}`);
    }
  }
});

test("a refracted ray that keeps its angle goes straight on, whatever its indices; one that is bent is said to be", () => {
  const straight = plain(phrases("event.refracted.outStraight", { name: "the ball" }));
  const leaves = (angle, bent) => plain(captionOf({ what: "refracted", name: "ball", enters: false, from: 1.52, to: 1, share: 0.9, angle, bent }).says);
  assert.equal(leaves(25.71, 25.73), straight);
  for (const [angle, bent] of [[25.7, 41.1], [0, 0], [0.01, 0.02], [null, null]]) assert.notEqual(leaves(angle, bent), straight, `${angle} to ${bent}`);
});

test("lamps in a sentence are joined as a language joins them", () => {
  assert.deepEqual([["a"], ["a", "b"], ["a", "b", "c"]].map((names) => allOf(names)), ["a", "a and b", "a, b and c"]);
});
