/** The plain article of a scene that the page was not written for: it is what gets printed. */
import { KIND, RAY_KINDS, type RayKind } from "../trace/kinds";
import type { SceneData, Trace } from "../trace/types";
import { grouped, list, percent, say } from "../words";
import { element } from "../element";

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

/** root: relative path to the site's root. */
export function writeArticle(article: HTMLElement, root: string, scene: SceneData, trace: Trace | null) {
  const picture = element("img", "plain-picture");
  picture.src = `${root}scenes/${scene.id}/${scene.picture}`;
  picture.alt = say("picture.alt", { title: scene.title });
  const lesson = element("ol", "plain-lesson");
  for (const { html, answer } of scene.lesson) {
    const item = element("li");
    item.innerHTML = html; // sanitised by the pipeline
    if (answer) {
      const folded = element("details", "", element("summary", "", say("lesson.answer")));
      folded.insertAdjacentHTML("beforeend", answer.html);
      item.append(folded);
    }
    lesson.append(item);
  }
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
