/**
 * node site_src/check.mjs: answers requests, a line of JSON each, until its input ends. What is wrong with a picture is known by
 * check/ alone, in pages as here.
 *
 *   {do: "recognise", picture, right, atlas}   which mistakes it looks like: Recognised (check/recognise.ts)
 *   {do: "compare", picture, right}            how right it is: Comparison (check/compare.ts), without the heat map
 *
 * picture and right name files of any format that check/formats reads, atlas a JSON file: an AtlasFile (check/atlas.ts) whose
 * images are files beside it. An answer is {answer}, or {fault: sentence}.
 */
import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { createInterface } from "node:readline";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const ENTRY = fileURLToPath(new URL("./check/main.ts", import.meta.url));
const { outputFiles } = await build({ entryPoints: [ENTRY], bundle: true, write: false, format: "esm", logLevel: "silent" });
const { atlasOf, compare, faultOfSize, pictureOrSentence, recogniserOf } = await import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].contents).toString("base64")}`);

function pictureIn(file) {
  const { picture, sentence } = pictureOrSentence(readFileSync(file));
  if (!picture) throw new Error(`${file}: ${sentence}`);
  return picture;
}

let ready = { atlas: "", recogniser: null }; // of the scene that was asked for last

function recogniserFor(atlas) {
  if (ready.atlas !== atlas) ready = { atlas, recogniser: recogniserOf(atlasOf(JSON.parse(readFileSync(atlas, "utf8")), (image) => pictureIn(join(dirname(atlas), image)))) };
  return ready.recogniser;
}

function answer({ do: what, picture, right, atlas }) {
  const [student, expected] = [pictureIn(picture), pictureIn(right)];
  const fault = faultOfSize(student, [expected.width]);
  if (fault) throw new Error(`${picture}: ${fault}`);
  if (what === "recognise") return recogniserFor(atlas).recognise(student, expected);
  const { heat, ...comparison } = compare(student, expected);
  return comparison;
}

for await (const line of createInterface({ input: process.stdin })) {
  let reply;
  try {
    reply = { answer: answer(JSON.parse(line)) };
  } catch (error) {
    reply = { fault: error.message };
  }
  process.stdout.write(`${JSON.stringify(reply)}\n`);
}
