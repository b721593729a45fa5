/** Writes the view into the address bar: from a server each scene has its page's address, from a disk the page stays. */
import type { Session } from "./session";
import { writeAddress } from "./state/address";

const AFTER = 200; // ms of quiet: browsers refuse an address that changes too often

/** home: the scene the page is for. links: data-scene names each one's scene. */
export function createAddressBar(session: Session, page: { home: string; onDisk: boolean; links: readonly HTMLAnchorElement[] }) {
  const { home, onDisk, links } = page;
  const isKiosk = !!window.raywalkKiosk;
  let timer = 0;

  const embedded = new URLSearchParams(location.hash.slice(1)).has("embed") && "embed=1";

  /** What all of a kiosk's addresses carry comes first: it is what the next page asks for first. */
  const withMode = (hash: string) => [window.raywalkKiosk?.part, embedded, hash].filter(Boolean).join("&");

  /** The address of what is shown; as long as nothing is, the one that is there. */
  function address(): string {
    const { state, scene } = session;
    if (!state || !scene) return location.href;
    const hash = withMode(writeAddress(state, scene, onDisk && state.scene !== home));
    const to = new URL(onDisk ? location.href : links.find((link) => link.dataset.scene === state.scene)!.href);
    to.hash = hash;
    if (!onDisk) to.search = location.search;
    return hash ? to.href : to.href.replace(/#$/, "");
  }

  function write(how: "replace" | "push") {
    clearTimeout(timer);
    const to = address();
    if (to === location.href) return;
    try {
      history[how === "push" && !isKiosk ? "pushState" : "replaceState"](null, "", to);
    } catch {
      // Refused: too many in a short time, or a page in a frame. The next one may be written.
    }
  }

  window.addEventListener("pagehide", () => write("replace"));
  return {
    write,
    /** When the state rests. */
    writeSoon() {
      clearTimeout(timer);
      timer = window.setTimeout(() => write("replace"), AFTER);
    },
    /** The view's address, which is written now. */
    now: () => (write("replace"), address()),
  };
}

export type AddressBar = ReturnType<typeof createAddressBar>;
