/** The page round the viewer: the header's title, the scene links, and the plain article that is there
 *  without JavaScript and is what gets printed. */
import { KIND, RAY_KINDS, type RayKind } from "../trace/kinds";
import type { SceneData, Trace } from "../trace/types";
import { grouped, list, say } from "../words";
import { element } from "./element";
import { savingsList } from "./savings";

export interface PageParts {
  root: string; // relative path to the site's root
  article: HTMLElement;
  title: HTMLElement;
  links: readonly HTMLAnchorElement[]; // data-scene names each one's scene
}

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

/** Links and sizes of what can be taken away, for another scene than the one the pipeline wrote them for. */
function writeSlides(root: string, { id }: SceneData, told: string | undefined) {
  const [folder, ...sizes] = told?.split("|") ?? [];
  for (const [k, link] of document.querySelectorAll<HTMLAnchorElement>("#take [data-after]").entries()) {
    link.href = `${root}${folder}${id}${link.dataset.after}`;
    link.parentElement!.hidden = !(parseFloat(sizes[k]) > 0);
    link.lastElementChild!.textContent = sizes[k];
  }
  const more = document.querySelector<HTMLAnchorElement>(".take-more");
  if (more) more.hash = id;
}

export function createPage({ root, article, title, links }: PageParts) {
  // Opened, the panel takes the focus. Written in the page, the word would ask for it at once, which frames may not.
  document.querySelector("#take")?.setAttribute("autofocus", "");
  let written = article.dataset.scene; // the pipeline wrote the article for this scene, with more figures than we know

  function write(scene: SceneData, trace: Trace | null) {
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
    const savings = scene.savings.counts.length ? [element("h2", "", say("savings.title")), savingsList(scene), element("p", "savings-note", say("savings.note"))] : [];
    article.replaceChildren(
      element("h1", "", scene.title),
      element("p", "teaches", scene.teaches),
      element("div", "plain-columns", picture, element("div", "plain-words", lesson, element("h2", "", say("figures.title")), figures, ...savings)),
    );
  }

  return {
    show(scene: SceneData, trace: Trace | null) {
      if (written !== scene.id) {
        written = scene.id;
        writeSlides(root, scene, links.find((link) => link.dataset.scene === scene.id)?.dataset.slides);
        write(scene, trace);
      }
      const heading = [scene.key, scene.title].filter(Boolean).join(" \u00b7 ");
      if (title.textContent !== heading) {
        title.textContent = heading;
        document.title = `${scene.title} \u00b7 Raywalk`;
      }
      for (const link of links)
        if (link.dataset.scene === scene.id) link.setAttribute("aria-current", "page");
        else link.removeAttribute("aria-current");
    },
  };
}
