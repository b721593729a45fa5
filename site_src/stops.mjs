/**
 * node site_src/stops.mjs: answers requests, a line of JSON each, until its input ends. What a pixel says, which lines
 * show, what a switch does, how an observer projects is known by the viewer's modules; the pipeline asks them here.
 *
 *   {do: "ask", scene, traces, size}                                     what the tracer is asked: Asked (viewer/stops/asked.ts)
 *   {do: "lesson", scene, traces, size, asked, sights, words, spoken, worked}   what slides and sheets show: Lesson (lesson.ts)
 *   {do: "events", scene, trace, pixel, words}                           one pixel's events in words (worded.ts)
 *   {do: "beside", scene, programs, words, spoken}                       events of rays that are in no file: EventBeside[][] (beside.ts)
 *   {do: "columns", trace, id, n}                                        a trace's header and columns; id and n: of which it must be
 *
 * scene, trace, asked, sights name files, traces a folder of <n>.json.gz; words is a
 * language's sentences, spoken the scene's words in it or null; worked is the file of what the lesson works out, if it does; sweeps
 * are by their ids the folders of what is published of them. Of a
 * lesson on another scene base names that one's file. An answer is {answer}, or {fault: sentence}.
 */
import { existsSync, readFileSync } from "node:fs";
import { createInterface } from "node:readline";
import { gunzipSync } from "node:zlib";
import { modulesOf } from "./modules.mjs";

const { ask, boxesFrom, decode, eventsBeside, inWords, lessonOf, listEvents, sceneAt, stopIn, wholeAgain } = await modulesOf("./viewer/stops/main.ts");

const json = (file) => JSON.parse(readFileSync(file, "utf8"));

/** Of <name>.json.gz, or of <name>.js as pages load it. */
function unpacked(file) {
  const bytes = readFileSync(file);
  try {
    return JSON.parse(gunzipSync(file.endsWith(".js") ? Buffer.from(bytes.toString("latin1").split('"')[3] ?? "", "base64") : bytes));
  } catch (error) {
    throw new Error(`no .json.gz or .js file of a trace, or a damaged one (${error.message})`);
  }
}

/** What stands beside a trace's columns; and these as the names of their types, with base64 of their bytes. */
function columnsOf(json, expected) {
  const columns = Object.entries(decode(json, expected)).filter(([, column]) => ArrayBuffer.isView(column));
  const bytes = columns.map(([name, column]) => [name, [column.constructor.name, Buffer.from(column.buffer, column.byteOffset, column.byteLength).toString("base64")]]);
  return { header: { ...json, columns: {} }, columns: Object.fromEntries(bytes) };
}

let read = { folder: "", grids: new Map() }; // of the scene that was asked for last

/** A scene's grids, each decoded once. */
function tracesIn(folder, scene) {
  if (read.folder !== folder) read = { folder, grids: new Map() };
  const { grids } = read;
  return (n) => grids.get(n) ?? grids.set(n, decode(unpacked(`${folder}/${n}.json.gz`), { scene: scene.of, n })).get(n);
}

/** The scene and its grids at the stops of its sweeps, as a page shows them; sweeps: their folders. */
function placesOf(scene, traces, sweeps = {}) {
  const own = { scene, traces };
  const known = new Map([["", own]]);
  const at = (text) => {
    const { sweep, stop } = stopIn(scene, text);
    if (stop === sweep.own) return own;
    const stops = (name) => unpacked(`${sweeps[sweep.id]}/${name}.js`);
    const there = sceneAt(scene, stops("stops").stops[stop - 1], sweep.id, stop);
    const grids = new Map();
    const grid = (n) => ({ ...decode(wholeAgain(stops(n).stops)[stop - 1], { scene: scene.of, n }), scene: there.of });
    return { scene: there, traces: (n) => grids.get(n) ?? grids.set(n, grid(n)).get(n) };
  };
  return (text) => known.get(text) ?? known.set(text, at(text)).get(text);
}

/** What can be drawn of a scene's meshes; a lesson about their tree has it worked out. */
function drawableOf({ traces, worked }, scene) {
  const file = `${traces}/boxes.js`;
  return { boxes: existsSync(file) ? boxesFrom(unpacked(file), scene.of) : null, tree: (worked && unpacked(worked).tree) || null };
}

function answer({ do: what, size, pixel, words, spoken, programs, id, n, ...files }) {
  if (what === "columns") return columnsOf(unpacked(files.trace), { scene: id, n });
  const base = files.base && unpacked(files.base);
  const scene = { ...base, ...unpacked(files.scene), ...(base && { files: base.files }) };
  globalThis.raywalkWords = words;
  if (what === "events") return listEvents(scene, decode(unpacked(files.trace), { scene: scene.of }), pixel);
  if (what === "beside") return eventsBeside(spoken ? inWords(scene, spoken) : scene, programs);
  const traces = tracesIn(files.traces, scene);
  const places = placesOf(spoken ? inWords(scene, spoken) : scene, traces, files.sweeps);
  if (what === "ask") return ask(places, size);
  return lessonOf(places, size, json(files.asked), json(files.sights), drawableOf(files, scene));
}

for await (const line of createInterface({ input: process.stdin })) {
  let reply;
  try {
    reply = { answer: answer(JSON.parse(line)) };
  } catch (error) {
    reply = { fault: error.code === "damaged" ? `damaged: ${error.message}` : error.message };
  }
  process.stdout.write(`${JSON.stringify(reply)}\n`);
}
