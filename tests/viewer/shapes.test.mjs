/** The table of shapes that stages draw: each polygon lies on its shape and faces outwards. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { load } from "./typescript.mjs";

const { FORMS, isWithin } = await load("state/shapes.ts", "state/placing.ts");
const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const minus = (a, b) => a.map((v, k) => v - b[k]);
const dot = (a, b) => a.reduce((sum, v, k) => sum + v * b[k], 0);
const cross = ([a, b, c], [d, e, f]) => [b * f - c * e, c * d - a * f, a * e - b * d];
const SOLIDS = [{ type: "box" }, { type: "cylinder" }, { type: "cylinder", tip: 0.4 }, { type: "cylinder", tip: 0 }];
const TURNED = SOLIDS.filter(({ type }) => type === "cylinder");
const width = ({ tip = 1 }, z) => tip + ((1 - tip) * (1 + z)) / 2;

for (const solid of SOLIDS) {
  const name = JSON.stringify(solid);
  test(`${name}: polygons close, are flat, and face away from the middle`, () => {
    const edges = new Map();
    for (const points of FORMS[solid.type].faces(solid, {})) {
      const normal = cross(minus(points[1], points[0]), minus(points[2], points[0]));
      assert.ok(dot(normal, points[0]) > 0, `${points}`);
      for (const [k, from] of points.entries()) {
        assert.ok(Math.abs(dot(normal, minus(from, points[0]))) < 1e-12);
        const to = points[(k + 1) % points.length];
        if (Math.hypot(...minus(to, from)) < 1e-12) continue; // a tip's ring is a point
        const [there, back] = [[from, to], [to, from]].map((way) => way.flat().map((v) => (v + 0).toFixed(9).replace("-0.000000000", "0.000000000")).join());
        if (!edges.delete(back)) edges.set(there, 1);
      }
    }
    assert.equal(edges.size, 0); // each edge was walked both ways
  });
}

test("corners of what is turned lie on its ends, and a point is within by its radius at that height (seed 5)", () => {
  let seed = 5;
  const random = () => ((seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0) / 2 ** 31) - 1;
  for (const solid of TURNED) {
    for (const [x, y, z] of FORMS.cylinder.faces(solid, {}).flat()) assert.ok(Math.abs(Math.hypot(x, y) - width(solid, z)) < 1e-12);
    for (let k = 0; k < 300; k++) {
      const p = [1.3 * random(), 1.3 * random(), 1.3 * random()];
      const inside = Math.abs(p[2]) < 1 && Math.hypot(p[0], p[1]) < width(solid, p[2]);
      assert.equal(isWithin({ ...solid, transform: IDENTITY }, p), inside);
    }
  }
});

test("an open one has no caps and is seen from both sides", () => {
  const [closed, open] = [false, true].map((open) => FORMS.cylinder.faces({ type: "cylinder", tip: 0.5, open }, {}));
  assert.equal(closed.length - open.length, 2);
  assert.equal(FORMS.cylinder.isOpen({ open: true }), true);
  assert.equal(FORMS.cylinder.isOpen({}), false);
});
