/** Links to scenes change the scene in place; with Ctrl, Shift or the middle button they are plain links. */
export function listenToLinks(links: Iterable<HTMLAnchorElement>, acts: { open: (id: string) => void; turn: (by: 1 | -1) => void }) {
  for (const link of links)
    link.addEventListener("click", (event) => {
      if (event.ctrlKey || event.metaKey || event.shiftKey || event.altKey || event.button !== 0) return;
      event.preventDefault();
      if (link.dataset.scene) acts.open(link.dataset.scene);
      else acts.turn(link.rel === "prev" ? -1 : 1);
      link.closest<HTMLElement>("[popover]")?.hidePopover?.();
      if (event.detail > 0) link.blur();
    });
}

/** A button pressed by mouse gives the keys back; one pressed by keyboard keeps the focus. */
export function giveKeysBack(body: HTMLElement) {
  body.addEventListener("click", (event) => {
    const pressed = event.target instanceof Element ? event.target.closest<HTMLElement>("#viewer button, .lecture") : null;
    if (pressed && event.detail > 0) pressed.blur();
  });
}
