/** The page round the viewer: the header's title, the scene links, and the plain article that is there
 *  without JavaScript and is what gets printed. */
import type { OnDemand } from "../on-demand";
import type { SceneData, Trace } from "../trace/types";

export interface PageParts {
  root: string; // relative path to the site's root
  article: HTMLElement;
  title: HTMLElement;
  links: readonly HTMLAnchorElement[]; // data-scene names each one's scene
}

export function createPage({ root, article, title, links }: PageParts, onDemand: OnDemand) {
  const writing = onDemand.one("told", (part) => part);
  let written = article.dataset.scene; // the pipeline wrote the article for this scene, with more figures than we know

  return {
    show(scene: SceneData, trace: Trace | null) {
      if (written !== scene.id) {
        written = scene.id;
        const slides = links.find((link) => link.dataset.scene === scene.id)?.dataset.slides;
        writing.use(({ writeArticle }) => written === scene.id && writeArticle(article, root, scene, trace, slides));
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
