/**
 * What a student's own program gave for a pixel, beside the right colour: ?yours=n,x,y,r,g,b, as the page check/ links here. It is
 * asked for before the #, so that the view's address stays as it is. What is not six numbers in their bounds is as if it were not there.
 */
import { element, swatch } from "../element";
import type { ViewState } from "../state/types";
import { say } from "../words";

const KEY = "yours";
const NUMBERS = /^\d{1,4}(,\d{1,4}){2}(,\d{1,3}){3}$/;

/** null: none is asked for. */
export function readYours(query: string): { n: number; pixel: [number, number]; bytes: number[] } | null {
  const text = new URLSearchParams(query).get(KEY) ?? "";
  const [n, x, y, ...bytes] = text.split(",").map(Number);
  const isMeant = NUMBERS.test(text) && x < n && y < n && Math.max(...bytes) <= 255;
  return isMeant ? { n, pixel: [x, y], bytes } : null;
}

/** null: there is nothing to show. */
export function createYours(home: HTMLElement) {
  const given = readYours(location.search);
  if (!given) return null;
  const colour = given.bytes.join(", ");
  const root = element("p", "yours numbers", swatch(`rgb(${colour})`), say("card.yours", { yours: colour }), ...toReport());
  home.querySelector(".card-head > .pixel")!.after(root);
  const scene = document.body.dataset.scene;
  return {
    /** At its pixel alone; of another scene the address forgets it. isCovered: the right colour is not shown either. */
    show(state: ViewState, isCovered: boolean) {
      root.hidden = isCovered || state.scene !== scene || state.n !== given.n || state.pixel.join() !== given.pixel.join();
      if (state.scene !== scene) forget();
    },
  };
}

/** None where the page leads to no check. */
function toReport(): HTMLElement[] {
  const check = document.querySelector<HTMLAnchorElement>(".to-check");
  if (!check) return [];
  const link = element("a", "", say("card.toReport"));
  link.href = `${check.href}&report=1`;
  return [link];
}

function forget() {
  const to = new URL(location.href);
  if (!to.searchParams.has(KEY)) return;
  to.searchParams.delete(KEY);
  history.replaceState(null, "", to);
}
