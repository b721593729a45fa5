/** Where a kiosk can go: its start, its own pages, this page anew. */
import { KIOSK_KEYS, writeKiosk, type KioskSettings } from "../state/kiosk-fields";
import type { KioskHook } from "./hook";
import type { Strikes } from "./strikes";

const OURS = "raywalk"; // what the page keeps in the browser begins so
/** Pages that a kiosk's script runs on too, below a language's folder: all others would be dead ends. */
const PAGES = /^(?:index\.html|(?:model|glossary)\/index\.html|scenes\/[^/]+\/index\.html)$/;

const TRIES_EVERY = 5000; // ms

/** From a disk, or kept by the service worker, or the host answers. */
function canLoad(): Promise<boolean> {
  if (location.protocol === "file:" || navigator.serviceWorker?.controller) return Promise.resolve(true);
  const icon = document.querySelector<HTMLLinkElement>("link[rel=icon]")?.href ?? "";
  return new Promise((done) => {
    const image = new Image();
    image.onload = () => done(true);
    image.onerror = () => done(!/^http/.test(icon));
    image.src = `${icon}?${Date.now()}`;
  });
}

/** A newer build that waits until nobody looks: now nobody does. */
async function takeNewest() {
  try {
    const registration = await navigator.serviceWorker?.getRegistration();
    registration?.waiting?.postMessage({ does: "take over" });
  } catch {
    // from a disk there is none
  }
}

export function createPlaces(hook: KioskHook, settings: KioskSettings, strikes: Strikes) {
  const root = new URL(hook.root || "./", location.href);
  root.hash = root.search = "";
  const homes = new Map([...document.querySelectorAll<HTMLLinkElement>("link[rel=alternate][hreflang]")].map((link) => [link.hreflang, link.dataset.home ?? ""]));
  const state = () => hook.viewer?.session.state;

  const part = (visitor = settings.visitor) => writeKiosk({ ...settings, visitor, strikes: strikes.inAddress() ? strikes.count() : 0 });

  /** From scratch, also where only the hash is another one; not before the page can be had: without its network a
   *  browser would show its own page, and stay there. */
  async function go(to: URL) {
    while (!(await canLoad())) await new Promise((done) => setTimeout(done, TRIES_EVERY));
    const isHere = to.href.split("#")[0] === location.href.split("#")[0];
    if (!isHere) return location.replace(to.href);
    history.replaceState(null, "", to.href);
    location.reload();
  }

  const isFlat = () => strikes.isFlat() || state()?.gl === false;

  function start(): URL {
    const to = new URL(`${homes.get(settings.home) ?? ""}${hook.start || "index.html"}`, root);
    to.hash = [part(false), state()?.still && "still=1", isFlat() && "gl=none"].filter(Boolean).join("&");
    return to;
  }

  function forgetVisitor() {
    for (const storage of [() => localStorage, () => sessionStorage])
      try {
        for (const key of Object.keys(storage())) if (key.startsWith(OURS) && key !== strikes.key) storage().removeItem(key);
      } catch {
        // refused: then nothing was kept either
      }
  }

  const places = {
    /** As it was when it was switched on: scene, view, panels, language, and what the browser kept. */
    reset() {
      forgetVisitor();
      void takeNewest();
      void go(start());
    },
    /** After a fault: this view for somebody who is there, else the start. Without WebGL if that was the fourth. */
    recover() {
      if (!settings.visitor || strikes.isHopeless()) return places.reset();
      const to = new URL(location.href);
      const view = to.hash.slice(1).split("&").filter((each) => !KIOSK_KEYS.includes(each.split("=")[0]) && !each.startsWith("gl="));
      to.hash = [part(), ...view, isFlat() && "gl=none"].filter(Boolean).join("&");
      void go(to);
    },
    visited(is: boolean) {
      settings.visitor = is;
      hook.part = part();
      if (!state()) history.replaceState(null, "", `#${hook.part}`);
    },
    /** Is a link's target a page of this kiosk? */
    isOwn(link: HTMLAnchorElement): boolean {
      const path = (url: URL | HTMLAnchorElement) => decodeURIComponent(url.pathname);
      if (link.origin !== location.origin || link.protocol !== location.protocol || !path(link).startsWith(path(root)) || link.target) return false;
      const below = path(link).slice(path(root).length);
      return [...homes.values(), ""].some((home) => below.startsWith(home) && PAGES.test(below.slice(home.length)));
    },
    part: () => hook.part,
  };
  hook.part = part();
  return places;
}

export type Places = ReturnType<typeof createPlaces>;
