/** Writes the view into the address bar: from a server each scene has its page's address, from a disk the page stays. */
import { writeAddress } from "./state/address";
import type { ViewState } from "./state/view-state";
import type { SceneData } from "./trace/types";

export function createAddressBar(page: { home: string; onDisk: boolean; links: readonly HTMLAnchorElement[] }) {
  const { home, onDisk, links } = page;

  /** What a kiosk's addresses carry on, first: it is what the next page asks for first. */
  const withKiosk = (hash: string) => [window.raywalkKiosk?.part, hash].filter(Boolean).join("&");

  function addressOf(now: ViewState, of: SceneData): string {
    const hash = withKiosk(writeAddress(now, of, onDisk && now.scene !== home));
    const to = new URL(onDisk ? location.href : links.find((link) => link.dataset.scene === now.scene)!.href);
    to.hash = hash;
    if (!onDisk) to.search = location.search;
    return hash ? to.href : to.href.replace(/#$/, "");
  }

  const isKiosk = !!window.raywalkKiosk;
  return {
    write(how: "replace" | "push", now: ViewState, of: SceneData) {
      const address = addressOf(now, of);
      if (address === location.href) return;
      try {
        history[how === "push" && !isKiosk ? "pushState" : "replaceState"](null, "", address);
      } catch {
        // Refused: too many in a short time, or a page in a frame. The next one may be written.
      }
    },
    addressOf,
  };
}
