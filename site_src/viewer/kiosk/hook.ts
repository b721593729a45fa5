/** Where the page (site_src/page/kiosk.js), the viewer and the kiosk's own script meet: window.raywalkKiosk. */
import type { Actions } from "../actions";
import type { Session } from "../session";

/** What a kiosk may do with the viewer. */
export interface KioskViewer {
  session: Session;
  acts: Actions;
  /** A scene's lesson from its start; false if the scene cannot be had. */
  begin: (id: string) => Promise<boolean>;
  /** Done when what the address asked for is shown, or cannot be. */
  ready: () => Promise<void>;
  ids: readonly string[]; // of all scenes, in order
  notify: (sentence: string) => void;
}

export interface KioskHook {
  part: string; // of every address: kiosk=1&...
  start: string; // the first scene's page, below a language's folder; "" where there is none
  root: string; // relative path to the site's root
  faults: string[]; // uncaught so far
  viewer: KioskViewer | null;
  arrived: (viewer: KioskViewer) => void;
  attach: (viewer: KioskViewer) => void;
  /** For tests. */
  status: () => object | null;
}

declare global {
  interface Window {
    raywalkKiosk?: KioskHook; // only with #kiosk=1
  }
}
