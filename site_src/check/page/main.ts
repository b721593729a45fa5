/** The page check/: a picture comes, is compared with the right one, and what is found is shown. Nothing leaves the device. */
import { say } from "../../viewer/words";
import { check } from "../check";
import type { Picture } from "../formats/picture";
import { pictureOrSentence } from "../formats/read";
import { refused } from "../report";
import { isRefusal, nearestSize, sourceFor, squareOf, taken } from "../square";
import { chosenScene, followAddress, listenToAsked, showSizes } from "./asked";
import { createFiles } from "./files";
import { showFound } from "./found";

const { root = "" } = document.body.dataset;
const files = createFiles(root);
const [says, found] = ["says", "found"].map((id) => document.getElementById(id)!);
let last: { name: string; picture: Picture } | null = null;
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
  const checked = check(square, right, source.isExact, scene);
  tell("");
  showFound(found, { file: { name, width, height }, chosen, square, right, source, checked, leftOut: scene.about.leftOut, nearest: nearestSize(size, scene.about), again });
}

function again() {
  [last, found.hidden] = [null, true];
  document.getElementById("file")!.focus();
  document.getElementById("drop")!.scrollIntoView({ block: "center" });
}

const failing = (error: unknown) => {
  tell(say("check.failed"));
  throw error;
};

async function given(file: File) {
  last = null;
  found.hidden = true;
  const read = pictureOrSentence(new Uint8Array(await file.arrayBuffer()));
  if ("sentence" in read) return tell(read.sentence);
  last = { name: file.name, picture: read.picture };
  await checkLast();
}

followAddress();
const sizes = () => void showSizes(files, chosenScene().id).catch(() => tell(say("check.missing")));
sizes();
listenToAsked(
  (file) => void given(file).catch(failing),
  () => {
    sizes();
    void checkLast().catch(failing);
  },
  // Loading and preparing takes longer than a check: it is done while a person looks for the file. What fails is told when it is wanted.
  () => void files.scene(chosenScene().id).catch(() => {}),
);
window.addEventListener("hashchange", () => {
  followAddress();
  sizes();
});
