/** The viewer holds no formula of intersection, reflection, refraction or lighting: students are set those. */
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { richScene } from "./browser.mjs";
import { readTrace } from "./scene-files.mjs";
import { load, VIEWER } from "./typescript.mjs";

const { eventsOf } = await load("state/events.ts");
const { linesOf } = await load("state/lines.ts");
const { rayRows } = await load("state/ray-rows.ts");

const sources = readdirSync(VIEWER, { recursive: true }).filter((file) => file.endsWith(".ts") && !file.endsWith(".d.ts"));
const code = (file) => readFileSync(join(VIEWER, file), "utf8").replace(/\/\*[\s\S]*?\*\/|\/\/[^\n]*/g, "");

/** What such formulas look like when they are written down, in TypeScript and in a shader. */
const FORMULAS = {
  "a function that intersects, reflects, refracts or lights": /\b(?:function|const|let)\s+(?:\w*[iI]ntersect\w*|reflect|refract|fresnel\w*|schlick\w*|snell\w*|lambert\w*|phong\w*|\w*halfVector\w*|\w*[dD]iscriminant\w*)\s*[=(<]/,
  "a call of a shader's own reflect or refract": /\b(?:reflect|refract)\s*\(/,
  "the discriminant of a quadratic": /\b(\w+)\s*\*\s*\1\s*-\s*(?:4(?:\.0)?\s*\*\s*)?\w+\s*\*\s*\w+/,
  "a direction mirrored at a normal": /\b2(?:\.0)?\s*\*\s*dot\s*\(/,
  "a highlight's power": /(?:Math\.pow|\bpow)\s*\([^;]*(?:dot|shininess)/,
  "Fresnel's or Snell's terms": /\b(?:n1|eta|cosT|sinT|cos_t)\b\s*[*/]/,
};
/** A formula's look that is something else here, with why. */
const NOT_ONE = [
  ["state/section.ts", "the discriminant of a quadratic"], // how far a point lies beside the drawn plane: Pythagoras
];

test("no source looks like a formula of the assignment", () => {
  for (const file of sources)
    for (const [name, look] of Object.entries(FORMULAS))
      if (!NOT_ONE.some(([where, what]) => where === file && what === name)) assert.doesNotMatch(code(file), look, `${file}: ${name}`);
});

test("the looks find what they look for", () => {
  const written = ["function intersectSphere(", "r = reflect(d, n)", "b * b - 4 * a * c", "sub(d, scale(n, 2 * dot(d, n)))", "Math.pow(dot(n, h), shininess)", "eta * cosI"];
  for (const [k, look] of Object.values(FORMULAS).entries()) assert.match(written[k], look);
});

test("a trace that is absurd is shown as it is: nothing is worked out anew (seed 7)", async () => {
  const { scene, trace } = await readTrace(richScene().id, 15);
  let seed = 7;
  const random = () => (seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0) / 2 ** 32;
  const scrambled = (values, by) => Float64Array.from(values, () => random() * by);
  const absurd = { ...trace, point: scrambled(trace.point, 9), normal: scrambled(trace.normal, 1), t: scrambled(trace.t, 50), colour: scrambled(trace.colour, 1), diffuse: scrambled(trace.diffuse, 1), specular: scrambled(trace.specular, 1) };
  for (let pixel = 0; pixel < 225; pixel++) {
    for (const { ray, light, to, leaves } of linesOf(absurd, scene, pixel)) if (light < 0 && !leaves) assert.deepEqual([...to], [...absurd.point.slice(3 * ray, 3 * ray + 3)]);
    for (const row of rayRows(absurd, scene, pixel)) {
      const three = (values) => [...values.slice(3 * row.ray, 3 * row.ray + 3)];
      assert.deepEqual([row.t, row.point, row.normal, row.colour].map(String), [absurd.t[row.ray], three(absurd.point), three(absurd.normal), three(absurd.colour)].map(String));
      for (const light of row.lights) assert.equal(light.diffuse, absurd.diffuse[row.ray * trace.lights + light.light]);
    }
    for (const event of eventsOf(absurd, scene, pixel)) if (event.what === "meets") assert.equal(event.t, absurd.t[event.ray]);
  }
});
