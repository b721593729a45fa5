/** The page check/: a picture comes, is compared with the right one, and what is found is shown. Nothing leaves the device. */
import { say } from "../../viewer/words";
import { check, wantsTiles } from "../check";
import { pictureOf, type Picture } from "../formats/picture";
import { pictureOrSentence } from "../formats/read";
import { otherScene, toldApartFromAfar, type AllScenes } from "../other-scene";
import type { Recognised } from "../recognise";
import { refused } from "../report";
import { isRefusal, nearestSize, sourceFor, squareOf, taken } from "../square";
import { addressOf, readAddress } from "./address";
import { choose, chosenScene, listenToAsked, showSizes, titles } from "./asked";
import { createFiles } from "./files";
import { showFound, type Found } from "./found";
import { forget, keep, kept } from "./kept";

const { root = "" } = document.body.dataset;
const files = createFiles(root);
const [says, found] = ["says", "found"].map((id) => document.getElementById(id)!);
let last: { name: string; bytes: Uint8Array; picture: Picture } | null = null;
/** A mistake that explains more of what is wrong speaks for the chosen scene. */
const OF_THIS_SCENE = 0.8;
let turn = 0; // of several pictures in a row the last one is shown

function tell(sentence: string) {
  says.textContent = sentence;
  says.hidden = !sentence;
}

/** What is said now is drawn before work begins that takes long. */
const drawn = () => new Promise((done) => requestAnimationFrame(() => setTimeout(done)));

async function checkLast() {
  if (!last) return;
  const { name, picture } = last;
  const own = ++turn;
  const { width, height } = picture;
  found.hidden = true;
  const square = squareOf(picture);
  if (isRefusal(square)) return tell(refused(square));
  tell(say("check.working"));
  await drawn();
  const chosen = chosenScene();
  const scene = await files.scene(chosen.id).catch(() => null);
  const size = square.picture.width;
  const source = scene && sourceFor(size, scene.about);
  const whole = source && (await files.right(chosen.id, source.from).catch(() => null));
  if (own !== turn) return;
  if (!whole) return tell(say("check.missing"));
  const right = taken(whole, size);
  const tiles = wantsTiles(size, scene.about) ? await files.tiles(chosen.id).catch(() => undefined) : undefined;
  const checked = check(square, right, source.isExact, scene, tiles);
  const all = checked.isRight ? null : await files.scenes().catch(() => null);
  if (own !== turn) return;
  tell("");
  const { leftOut } = scene.about;
  showFound(found, {
    file: { name, width, height }, chosen, square, right, source, checked, leftOut, nearest: nearestSize(size, scene.about), again,
    looked: (mistake) => scene.recogniser?.pictureOf(mistake) ?? null,
    other: otherThan(chosen.id, square.picture, checked, all),
    apartIn: (a, b) => all && toldApartFromAfar(a, b, all),
  });
  history.replaceState(null, "", addressOf(chosen.id, true));
}

/** Another scene that the picture shows, and what compares it with that. */
function otherThan(id: string, picture: Picture, { answers: [best] }: Recognised, all: AllScenes | null): Found["other"] {
  const other = all && otherScene(picture, id, best?.agreement > OF_THIS_SCENE, all);
  return other ? { title: titles()[other], compare: () => (choose(other), chosenAnew()) } : null;
}

function again() {
  [last, found.hidden] = [null, true];
  forget();
  history.replaceState(null, "", addressOf(chosenScene().id, false));
  document.getElementById("file")!.focus();
  document.getElementById("drop")!.scrollIntoView({ block: "center" });
}

const failing = (error: unknown) => {
  tell(say("check.failed"));
  throw error;
};

async function given(name: string, bytes: Uint8Array) {
  last = null;
  found.hidden = true;
  const read = pictureOrSentence(bytes);
  if ("sentence" in read) return tell(read.sentence);
  last = { name, bytes, picture: read.picture };
  await checkLast();
}

const idle = () => new Promise((done) => (window.requestIdleCallback ?? setTimeout)(done));
/** ms; who gives a file as soon as the page is there does not wait for the engine to be through. */
const PAUSE = 1000;
let isUsed = false;
/** Loading and preparing takes longer than a check: it is done while a person looks for the file, or reads. The engine has been through
 *  all that recognises then, which takes it twice as long the first time. What fails is told when it is wanted. */
async function prepare(pause: number) {
  const { about, recogniser } = await files.scene(chosenScene().id);
  await new Promise((done) => setTimeout(done, pause));
  const [wrong, right] = isUsed || turn ? [] : [recogniser?.pictureOf(about.mistakes[0]?.name), recogniser?.right];
  if (!recogniser || !wrong || !right) return;
  isUsed = true;
  const of = (values: Uint8Array) => pictureOf(about.grid, about.grid, values);
  recogniser.recognise(of(wrong), of(right));
}
const prepared = (pause = 0) => void prepare(pause).catch(() => {});

/** The report that one comes back to, where it was left. */
async function shownAgain() {
  const before = kept();
  if (!before) return history.replaceState(null, "", addressOf(chosenScene().id, false));
  await given(before.name, before.bytes);
  window.scrollTo({ top: before.scrolled, behavior: "instant" });
}

/** #scene=02-shadows, as a scene's page links here. */
const followAddress = () => choose(readAddress(location.hash).scene);
followAddress();
/** Who pays by the byte has a scene's data when a file is looked for. */
const mayLoad = () => !(navigator as { connection?: { saveData?: boolean } }).connection?.saveData;
const sizes = () => void showSizes(files, chosenScene().id).then(idle).then(() => mayLoad() && prepared(PAUSE)).catch(() => tell(say("check.missing")));
sizes();
function chosenAnew() {
  history.replaceState(null, "", addressOf(chosenScene().id, false));
  sizes();
  void checkLast().catch(failing);
}
listenToAsked((file) => void file.arrayBuffer().then((bytes) => given(file.name, new Uint8Array(bytes))).catch(failing), chosenAnew, () => prepared());
window.addEventListener("hashchange", () => {
  followAddress();
  sizes();
});
window.addEventListener("pagehide", () => last && !found.hidden && keep({ ...last, scrolled: window.scrollY }));
if (readAddress(location.hash).isReport) void shownAgain().catch(failing);
