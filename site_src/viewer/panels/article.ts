/** What the pipeline writes into a scene's page, for a scene that the page was not written for: the plain article,
 *  which is what gets printed, and the links to what can be taken away. */
import { KIND, RAY_KINDS, type RayKind } from "../trace/kinds";
import type { ChoiceData, SceneData, Trace } from "../trace/types";
import { grouped, hexOf, list, percent, say } from "../words";
import { element, swatch } from "../element";

function figuresOf(scene: SceneData, trace: Trace | null): [string, string][] {
  const figures: [string, string][] = [
    [say("figures.size"), say("figures.sizeIs", { size: scene.size })],
    [say("figures.levels"), list(scene.levels.map(String))],
    [say("figures.depth"), String(scene.depth)],
    [say("figures.shadows"), say(scene.shadows ? "figures.yes" : "figures.no")],
  ];
  if (!trace) return figures;
  const of = (kind: RayKind) => trace.kind.reduce((sum, code) => sum + (code === KIND[kind] ? 1 : 0), 0);
  const kinds = RAY_KINDS.map((kind) => [kind, of(kind)] as const).filter(([, rays]) => rays > 0);
  return [...figures, [say("figures.rays", { n: trace.n }), list(kinds.map(([kind, rays]) => `${grouped(rays)} ${say(`line.${kind}`)}`))]];
}

/** What tracing did not have to do, as lines of label and value with a note. */
export function savingsOf({ savings }: SceneData): HTMLElement[] {
  const stages = savings.notRun.map((stage) => say(`savings.stages.${stage}`)).join(", ");
  const counts = savings.counts.map(([key, part, whole]): [string, string] => [
    say(`savings.${key}`),
    whole ? say("savings.of", { part: grouped(part), whole: grouped(whole), share: percent(part / whole) }) : grouped(part),
  ]);
  const lines = stages ? [[say("savings.notRun"), stages], ...counts] : counts;
  const figures = element("dl", "figures", ...lines.map(([label, value]) => element("div", "", element("dt", "", label), element("dd", "numbers", value))));
  return [figures, element("p", "savings-note", say("savings.note"))];
}

/** Links and sizes of the downloads. */
function writeSlides(root: string, id: string, folder: string, sizes: readonly string[]) {
  for (const [k, link] of document.querySelectorAll<HTMLAnchorElement>("#take [data-after]").entries()) {
    link.href = `${root}${folder}${id}${link.dataset.after}`;
    link.parentElement!.hidden = !(parseFloat(sizes[k]) > 0);
    link.lastElementChild!.textContent = sizes[k];
  }
  const more = document.querySelector<HTMLAnchorElement>(".take-more");
  if (more) more.hash = id;
}

/** A question's choices, or with the answer the reason of each. html: sanitised by the pipeline. */
function choicesOf({ objects }: SceneData, choices: readonly ChoiceData[], told: boolean): HTMLElement {
  const items = choices.map(({ html, because, right, pixel, object, colour }) => {
    const label = element("b");
    label.innerHTML = html;
    if (pixel) label.textContent = say("card.pixel", { column: pixel[0], row: pixel[1] });
    if (object !== undefined) label.textContent = objects[object].name;
    const item = element("li", told && right ? "is-right" : "", ...(colour ? [swatch(hexOf(colour))] : []), label);
    if (told) {
      item.append(" ", element("i", "", say(right ? "choices.right" : "choices.wrong")), " ");
      item.insertAdjacentHTML("beforeend", because);
    }
    return item;
  });
  return element("ol", told ? "plain-reasons" : "plain-choices", ...items);
}

/** The lesson as a list; on paper each step and each answer has its figure, which are numbered in this order.
 *  figures: what their addresses begin with; "" where there are none. */
function lessonOf(scene: SceneData, figures: string): HTMLElement {
  const lesson = element("ol", "plain-lesson");
  let count = 0;
  /** html: sanitised by the pipeline. */
  const written = (into: HTMLElement, html: string) => {
    into.insertAdjacentHTML("beforeend", html);
    if (!figures) return into;
    const image = Object.assign(element("img", "step-figure"), { alt: "", loading: "lazy", src: `${figures}${String(++count).padStart(2, "0")}.svg` });
    into.insertBefore(image, into.querySelector(":scope > :not(summary)"));
    return into;
  };
  for (const { html, answer, choices } of scene.lesson) {
    const item = written(element("li"), html);
    if (choices) item.append(choicesOf(scene, choices, false));
    if (answer) item.append(written(element("details", "", element("summary", "", say("lesson.answer"))), answer.html));
    if (choices) item.lastElementChild!.append(choicesOf(scene, choices, true));
    lesson.append(item);
  }
  return lesson;
}

/** root: relative path to the site's root. slides: where they are, and their sizes. */
export function writeArticle(article: HTMLElement, root: string, scene: SceneData, trace: Trace | null, slides = "") {
  const [folder, ...sizes] = slides.split("|");
  writeSlides(root, scene.id, folder, sizes);
  const picture = element("img", "plain-picture");
  picture.src = `${root}scenes/${scene.of}/${scene.picture}`;
  picture.alt = say("picture.alt", { title: scene.title });
  const lesson = lessonOf(scene, folder && `${root}${folder}${scene.id}-figure-`);
  const figures = element("dl", "figures");
  for (const [name, value] of figuresOf(scene, trace))
    figures.append(element("div", "", element("dt", "", name), element("dd", "numbers", value)));
  const savings = scene.savings.counts.length ? [element("h2", "", say("savings.title")), ...savingsOf(scene)] : [];
  article.replaceChildren(
    element("h1", "", scene.title),
    element("p", "teaches", scene.teaches),
    element("div", "plain-columns", picture, element("div", "plain-words", lesson, element("h2", "", say("figures.title")), figures, ...savings)),
  );
}
