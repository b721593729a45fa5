/** The window onto a drawn tree: as large as is legible, or whole; it scrolls, is dragged, and shows where there is more. */
import { say } from "../words";
import { button, element, setWord } from "../element";

const LEGIBLE = 0.92; // smaller than this a tree is drawn on request only
const DESK = 13; // px: the type in a node, unscaled
const GROWS = 18; // px, at most, by which a node becomes wider and higher while it is lit: its outline, its marks of lights

/** shown: the tree is now drawn in another size, and what was looked at is to be seen again. */
export function createTreeWindow(drawing: SVGElement, shown: () => void) {
  const root = element("div", "tree-window", drawing as unknown as HTMLElement);
  const fit = button(say("tree.fit.word"), say("tree.fit.help"), () => {
    fits = !fits;
    scale();
    shown();
  }, { className: "tree-fit" });
  let size = { width: 0, height: 0 }; // of the drawing, unscaled; 0: there is none yet
  let fits = false; // the whole tree, however small

  function scale() {
    if (!size.width) return;
    const room = Math.min(root.clientWidth / size.width, root.clientHeight / size.height);
    const full = Math.max(1, parseFloat(getComputedStyle(root).fontSize) / DESK); // larger in a lecture
    const legible = LEGIBLE * full;
    const share = room > 0 ? Math.min(full, fits ? room : Math.max(legible, room)) : full;
    for (const side of ["width", "height"] as const) drawing.setAttribute(side, String(Math.floor(size[side] * share)));
    fit.hidden = !fits && (room <= 0 || room >= legible);
    const does = fits ? "large" : "fit";
    setWord(fit, say(`tree.${does}.word`), say(`tree.${does}.help`));
    cue();
  }

  /** Where the drawing goes on, it fades. */
  function cue() {
    const { scrollLeft: x, scrollTop: y, scrollWidth, scrollHeight, clientWidth, clientHeight } = root;
    const more = { left: x > 1, right: x + clientWidth < scrollWidth - 1, top: y > 1, bottom: y + clientHeight < scrollHeight - 1 };
    for (const [side, on] of Object.entries(more)) root.classList.toggle(`more-${side}`, on);
  }

  root.addEventListener("scroll", cue);
  new ResizeObserver(() => {
    scale();
    if (size.width) shown(); // what is below the tree may have become higher meanwhile
  }).observe(root);
  root.addEventListener("pointermove", (event) => {
    if (event.pointerType === "mouse" && event.buttons === 1) root.scrollBy(-event.movementX, -event.movementY);
  });

  return {
    element: root,
    fit,
    resize(width: number, height: number) {
      size = { width, height };
      drawing.setAttribute("viewBox", `0 0 ${width} ${height}`);
      scale();
    },
    toTop: () => (root.scrollTop = 0),
    /** Scrolls the drawing alone. */
    showNode(node: SVGElement, middle: boolean) {
      const [of, at] = [root.getBoundingClientRect(), node.getBoundingClientRect()];
      if (middle || at.left < of.left + GROWS || at.right > of.right - GROWS) root.scrollLeft += (at.left + at.right - of.left - of.right) / 2;
      if (at.top < of.top + GROWS || at.bottom > of.bottom - GROWS) root.scrollTop += (at.top + at.bottom - of.top - of.bottom) / 2;
    },
  };
}
