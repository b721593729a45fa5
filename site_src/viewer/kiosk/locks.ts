/** What a visitor must not get at: menus, selections, other pages, the browser's shortcuts and its zoom (the style sheet's touch-action). */
import type { Places } from "./places";

const NEVER = ["contextmenu", "selectstart", "dragstart", "drop", "dragover", "auxclick", "gesturestart", "gesturechange"];
const BROWSERS_KEYS = /^(F\d+|Browser\w*|ContextMenu|Print\w*|Backspace|['/])$/; // ' and / open Firefox's find bar
const MOUSE = ["mousedown", "mouseup", "pointerdown", "pointerup"];
const BACK = 3; // the mouse's button for going back; forward comes after it

/** A link that leads out of the kiosk is words only. */
function withoutWaysOut(part: ParentNode, { isOwn }: Places) {
  for (const link of part.querySelectorAll<HTMLAnchorElement>("a[href]")) {
    if (isOwn(link)) continue;
    for (const name of ["href", "download", "target"]) link.removeAttribute(name);
    link.classList.add("kiosk-words");
  }
}

/** Links to other pages of the kiosk take along that it is one; those within the page leave the address alone. */
function follow(event: Event, places: Places) {
  const link = event.target instanceof Element ? event.target.closest<HTMLAnchorElement>("a[href]") : null;
  if (!link) return;
  if (!places.isOwn(link)) return event.preventDefault();
  const isHere = link.href.split("#")[0] === location.href.split("#")[0];
  if (isHere && link.hash && !link.dataset.scene) {
    event.preventDefault();
    const target = document.getElementById(link.hash.slice(1));
    target?.scrollIntoView();
    if (target) (target.tabIndex = -1), target.focus();
  } else if (!link.classList.contains("language")) link.hash = places.part();
}

export function lockPage(places: Places) {
  const stop = (event: Event) => event.preventDefault();
  for (const what of NEVER) document.addEventListener(what, stop, { capture: true });
  document.addEventListener("wheel", (event) => (event.ctrlKey || event.metaKey) && event.preventDefault(), { capture: true, passive: false });
  document.addEventListener("keydown", (event) => (event.ctrlKey || event.metaKey || event.altKey || BROWSERS_KEYS.test(event.key)) && event.preventDefault(), { capture: true });
  for (const what of MOUSE) document.addEventListener(what, (event) => (event as MouseEvent).button >= BACK && event.preventDefault(), { capture: true });
  document.addEventListener("click", (event) => follow(event, places), { capture: true });
  withoutWaysOut(document, places);
  new MutationObserver((changes) => {
    for (const { addedNodes } of changes) for (const node of addedNodes) if (node instanceof Element && node.querySelector("a[href]")) withoutWaysOut(node.parentElement ?? document, places);
  }).observe(document.body, { childList: true, subtree: true });
}
