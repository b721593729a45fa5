/**
 * node site_src/check.mjs: answers requests, a line of JSON each, until its input ends. What is wrong with a picture is known by
 * check/ alone, in pages as here.
 *
 *   {do: "check", picture, data, names, language}   all that the page check/ tells: Checked (check/check.ts) without the heat map,
 *                                              {width, height, square: {size, isCut, isLossy, hadAlpha}, source, nearest, leftOut}; or
 *                                              {refusal}, or {fault: sentence} of what is no picture; and the report of each, {lines: Line[],
 *                                              written: [text]} (check/report.ts)
 *   {do: "recognise", picture, right, atlas}   which mistakes it looks like: Recognised (check/recognise.ts)
 *
 * picture and right name files of any format that check/formats reads. names is what objects and mistakes are called in the language
 * (Names of check/report.ts: of mistakes their titles and lines to look for). data is a folder of a scene's scripts
 * (build/raywalk/check/write.py), atlas one with about.json and atlas.gz. An answer is {answer}, or {fault: sentence}, in the
 * language if one is named.
 */
import { readFileSync } from "node:fs";
import { basename, join } from "node:path";
import { createInterface } from "node:readline";
import { modulesOf } from "./modules.mjs";

const { aboutOf, atlasOf, check, isRefusal, nearestSize, pictureOrSentence, recogniserOf, refused, reportOf, rightOf, sceneOf, sentenceAlone, sourceFor, squareOf, stripsOf, taken, wantsTiles, written } = await modulesOf("./check/main.ts");

function speak(language = "en") {
  if (globalThis.raywalkWords?.language.code !== language) globalThis.raywalkWords = JSON.parse(readFileSync(new URL(`./words/${language}.json`, import.meta.url), "utf8"));
}

function pictureIn(file) {
  const { picture, sentence } = pictureOrSentence(readFileSync(file));
  if (!picture) throw new Error(`${file}: ${sentence}`);
  return picture;
}

/** Of the folder that was asked for last: what is made of it takes longer than a picture. */
function keeping(make) {
  let [kept, made] = ["", null];
  return (folder) => {
    if (kept !== folder) [made, kept] = [make(folder), folder];
    return made;
  };
}
const recogniserIn = keeping(async (folder) => recogniserOf(atlasOf(JSON.parse(readFileSync(join(folder, "about.json"), "utf8")), await stripsOf(readFileSync(join(folder, "atlas.gz"))))));
const scriptIn = (folder, name) => new Uint8Array(Buffer.from(readFileSync(join(folder, `${name}.js`), "latin1").split('"')[3], "base64"));
const sceneIn = keeping((folder) => {
  const about = aboutOf(scriptIn(folder, "about"));
  return sceneOf(about, scriptIn(folder, "places"), about.leftOut ? null : scriptIn(folder, "atlas"));
});

const told = (found, lines) => ({ ...found, lines, written: written(lines) });

async function checked({ picture: file, data, names }) {
  const { picture, sentence } = pictureOrSentence(readFileSync(file));
  if (!picture) return told({ fault: sentence }, sentenceAlone(sentence));
  const { width, height, isLossy, hadAlpha } = picture;
  const square = squareOf(picture);
  if (isRefusal(square)) return told({ width, height, refusal: square }, sentenceAlone(refused(square)));
  const scene = await sceneIn(data);
  const size = square.picture.width;
  const source = sourceFor(size, scene.about);
  const nearest = nearestSize(size, scene.about);
  const { leftOut } = scene.about;
  const whole = () => rightOf(scriptIn(data, scene.about.own.at(-1))); // has each tile's middle
  const found = check(square, taken(await rightOf(scriptIn(data, source.from)), size), source.isExact, scene, wantsTiles(size, scene.about) ? await whole() : undefined);
  const lines = reportOf({ file: { name: basename(file), width, height }, square, source, checked: found, leftOut, nearest }, names);
  const { heat, ...comparison } = found.comparison;
  return told({ ...found, comparison, width, height, square: { size, isCut: square.isCut, isLossy, hadAlpha }, source, nearest, leftOut }, lines);
}

const DOES = { check: checked, recognise: async ({ picture, right, atlas }) => (await recogniserIn(atlas)).recognise(pictureIn(picture), pictureIn(right)) };

for await (const line of createInterface({ input: process.stdin })) {
  let reply;
  try {
    const request = JSON.parse(line);
    speak(request.language);
    reply = { answer: await DOES[request.do](request) };
  } catch (error) {
    reply = { fault: error.message };
  }
  process.stdout.write(`${JSON.stringify(reply)}\n`);
}
