/** What has more in it than it shows can be scrolled by keyboard too: then, and only then, it takes the focus. Returns
 *  what to call when its content has changed. */
export function reachable(element: HTMLElement): () => void {
  const hasMore = () => element.scrollHeight > element.clientHeight + 1 || element.scrollWidth > element.clientWidth + 1;
  const update = () => void (hasMore() ? (element.tabIndex = 0) : element.removeAttribute("tabindex"));
  new ResizeObserver(update).observe(element); // goes with the element
  return update;
}

const NARROW = "(max-width: 760px)";

/** On a phone, where the page scrolls below its stage: right under that. */
export function bringUp(part: Element, behavior: ScrollBehavior) {
  if (matchMedia(NARROW).matches) part.scrollIntoView({ behavior: matchMedia("(prefers-reduced-motion: reduce)").matches ? "auto" : behavior });
}
