/** The row of a list that belongs to what is lit up on the stage or to the current event. */

/** follow: and brings it into sight; the list alone is scrolled, the page stays where it is. */
export function markRow(list: HTMLElement, rows: Iterable<HTMLElement>, lit: HTMLElement | null, follow: boolean) {
  for (const row of rows) row.classList.toggle("lit", row === lit);
  if (!lit || !follow) return;
  const [box, at] = [list.getBoundingClientRect(), lit.getBoundingClientRect()];
  if (at.top < box.top) list.scrollTop += at.top - box.top;
  else if (at.bottom > box.bottom) list.scrollTop += Math.min(at.bottom - box.bottom, at.top - box.top);
}
