/**
 * A mistake's page that a report leads to (#scene=08-glass): it shows what the mistake makes of the scene that was checked, and leads back.
 * Without this script, or without a scene, the page shows the scene that shows the mistake best.
 */
import { element, named } from "../../viewer/element";
import { addressOf, readAddress } from "./address";
import { canvasWith, imageOf } from "./canvas";
import { createFiles } from "./files";

/** What the page was written with: the mistake, the scene it shows ("": none), titles of scenes, and sentences with {scene} and {own}. */
const { root, home, mistake, own, titles, back, ...said } = document.currentScript!.dataset as Record<string, string>;
const titleOf: Record<string, string> = JSON.parse(titles);
const pictures = document.querySelector(".pair");

const tell = (sentence: string, scene: string) =>
  sentence.replace(/\{(\w+)\}/g, (_, key: string) => ({ scene: titleOf[scene], own: titleOf[own] })[key] ?? "");

/** Above the title, and from one mistake to the next. */
function leadBack(scene: string) {
  const link = element("a", "", `← ${back}`);
  link.href = `${root}${home}check/index.html${addressOf(scene, true)}`;
  document.querySelector(".page-head > .family")!.before(element("p", "to-report", link));
  for (const each of document.querySelectorAll<HTMLAnchorElement>(".beside a")) each.hash = addressOf(scene, false);
}

async function showIn(pictures: Element, scene: string) {
  const say = (sentence: string) => pictures.before(element("p", "of-scene", tell(sentence, scene)));
  if (scene === own) return say(said.checkedOwn);
  const files = createFiles(root);
  const about = await files.about(scene);
  if (!about.mistakes.some(({ name }) => name === mistake)) return say(said.notThere);
  const { size, right, mistakes } = await files.atlas(scene);
  const [wrong] = mistakes.find(({ name }) => name === mistake)!.pictures;
  say(said.checked);
  [right, wrong].forEach((values, k) => pictures.querySelectorAll("img, canvas")[k].replaceWith(named(canvasWith(imageOf(values, size)), tell([said.altRight, said.altWrong][k], scene), "img")));
}

const { scene } = readAddress(location.hash);
if (scene && scene in titleOf) {
  leadBack(scene);
  if (pictures) showIn(pictures, scene).catch(() => {}); // it cannot be had: the page shows what it came with
}
