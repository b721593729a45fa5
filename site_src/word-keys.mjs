/**
 * node site_src/word-keys.mjs: viewer/word-keys.d.ts out of words/en.json, each sentence's key with the slots it
 * has, so that the compiler refuses an unknown key and a missing slot. Runs before every type check.
 */
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const place = (path) => fileURLToPath(new URL(path, import.meta.url));

/** [[key, entry], ...]: an entry is a text, or the forms of a plural. */
export const entriesOf = (tree, before = "") =>
  Object.entries(tree).flatMap(([name, value]) => {
    const key = before + name;
    return typeof value === "string" || "other" in value ? [[key, value]] : entriesOf(value, `${key}.`);
  });

/** The names of an entry's slots, sorted. */
export const slotsOf = (entry) => {
  const isPlural = typeof entry !== "string";
  const text = isPlural ? Object.values(entry).join(" ") : entry;
  const names = [...text.matchAll(/\{(\w+)\}/g)].map((match) => match[1]);
  return [...new Set(isPlural ? ["count", ...names] : names)].sort();
};

function main() {
  const words = JSON.parse(readFileSync(place("./words/en.json"), "utf8"));
  const lines = entriesOf(words).map(([key, entry]) => `  "${key}": ${slotsOf(entry).map((name) => `"${name}"`).join(" | ") || "never"};`);
  writeFileSync(place("./viewer/word-keys.d.ts"), ["/** Made from words/en.json by word-keys.mjs: not to be edited. */", "export interface WordKeys {", ...lines, "}", ""].join("\n"));
}

if (process.argv[1] === fileURLToPath(import.meta.url)) main();
