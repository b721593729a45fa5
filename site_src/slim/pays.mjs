/**
 * node site_src/slim/pays.mjs: what each pass and rule saves of the viewer's script, gzipped, for its lines of source.
 * What saves less than 1000 bytes in 20 lines does not stay: ends with 1 if there is one. About a minute.
 */
import { readFile } from "node:fs/promises";
import { gzipSync } from "node:zlib";
import { bundleViewer } from "../bundle.mjs";
import { RULES } from "./never.mjs";
import { treeOf, walk } from "./syntax.mjs";
import { PASSES } from "./three.mjs";

const LEAST = 1000 / 20; // bytes a line

const source = (name) => readFile(new URL(`./${name}.mjs`, import.meta.url), "utf8");
const linesIn = (text) => text.trimEnd().split("\n").length;
const size = async (without) => gzipSync((await bundleViewer(() => {}, without)).viewer, { level: 9 }).length;

const never = await source("never");
const linesOf = new Map(); // of what never.mjs declares by its name, of rules by their reason
walk(treeOf(never), ({ type, id, properties, start, end }) => {
  const lines = linesIn(never.slice(start, end));
  if (/^(VariableDeclarator|FunctionDeclaration)$/.test(type)) linesOf.set(id.name, lines);
  const why = type === "ObjectExpression" && properties.find(({ key }) => key?.name === "why")?.value.value;
  if (why) linesOf.set(why, lines);
});
const parts = [
  ...(await Promise.all(Object.keys(PASSES).map(async (name) => [name, linesIn(await source(name))]))),
  ...RULES.map(({ why }) => [why, linesOf.get(why)]),
  ["shader library", linesOf.get("withoutShaders")],
  ["macros", linesOf.get("MACROS")],
];
const whole = await size("");
const row = (...cells) => console.log(cells.map((cell, k) => (k < 3 ? String(cell).padStart(7) : cell)).join("  "));
row("bytes", "lines", "a line", "left out");
for (const [name, lines] of parts) {
  const saved = (await size(name)) - whole;
  row(saved, lines, (saved / lines).toFixed(0), name);
  if (saved < LEAST * lines) process.exitCode = 1;
}
