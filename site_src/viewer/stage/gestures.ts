/** What fingers, a mouse or a wheel do on the stage, in the stage's terms. Where the page scrolls it is the page's that one finger
 *  goes up or down (touch-action in the style sheet), unless it has rested on the stage; the browser then takes the finger away
 *  (pointercancel), so until it moves here nothing is done. */
export interface GestureActs {
  /** May this point be selected? Then dragging from it selects on; elsewhere it turns the view. */
  isOnTiles: (x: number, y: number) => boolean;
  pick: (x: number, y: number) => void;
  hover: (x: number, y: number) => void;
  leave: () => void;
  orbit: (dx: number, dy: number) => void;
  pan: (dx: number, dy: number) => void;
  zoom: (factor: number) => void;
  /** A finger was taken for scrolling. */
  scrolled: () => void;
}

const WHEEL_PER_PIXEL = 0.0016;
const WHEEL_LINE = 16; // pixels, for mice that count lines
const RESTED = 350; // ms until a finger that rests turns the view, wherever it goes then
const STEADY = 8; // pixels that a resting finger may move

interface Touch {
  x: number;
  y: number;
}

function listenToWheel(element: HTMLElement, zoom: (factor: number) => void) {
  function wheel(event: WheelEvent) {
    if (window.parent !== window && !document.hasFocus()) return; // the page around this one scrolls
    event.preventDefault();
    const pixels = event.deltaY * (event.deltaMode === 1 ? WHEEL_LINE : 1) * (event.ctrlKey ? 6 : 1); // ctrl: a pinch on a trackpad
    zoom(Math.exp(pixels * WHEEL_PER_PIXEL));
  }
  element.addEventListener("wheel", wheel, { passive: false });
}

export function listenToGestures(element: HTMLElement, acts: GestureActs) {
  const down = new Map<number, Touch>();
  let doing: "pick" | "orbit" | "pan" | "two" | null = null;
  let waits: Touch | null = null; // where a finger came down of which it is not known yet what it does
  let rest = 0;
  const at = (event: PointerEvent): Touch => {
    const box = element.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };
  const spread = () => {
    const [a, b] = [...down.values()];
    return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, apart: Math.max(1, Math.hypot(a.x - b.x, a.y - b.y)) };
  };

  function press(event: PointerEvent) {
    if (event.button > 2) return;
    const here = at(event);
    element.setPointerCapture(event.pointerId);
    down.set(event.pointerId, here);
    settle(null);
    if (down.size >= 2) doing = "two";
    else if (event.pointerType === "touch") {
      waits = here;
      rest = window.setTimeout(() => settle("orbit"), RESTED);
    } else if (event.shiftKey || event.button === 1) doing = "pan";
    else begin(event.button, here);
  }
  const begin = (button: number, { x, y }: Touch) => {
    settle(button === 0 && acts.isOnTiles(x, y) ? "pick" : "orbit");
    if (doing === "pick") acts.pick(x, y);
  };
  /** What the hand does is known. */
  function settle(what: typeof doing) {
    clearTimeout(rest);
    waits = null;
    doing = what;
  }

  function drag(event: PointerEvent) {
    const here = at(event);
    const before = down.get(event.pointerId);
    if (!before) return acts.hover(here.x, here.y);
    if (waits) {
      const [across, along] = [Math.abs(here.x - waits.x), Math.abs(here.y - waits.y)];
      if (across + along < STEADY || (along > across && getComputedStyle(element).touchAction === "pan-y")) return;
      begin(0, waits);
    }
    if (doing === "two" && down.size >= 2) {
      const was = spread();
      down.set(event.pointerId, here);
      const is = spread();
      acts.pan(is.x - was.x, is.y - was.y);
      return acts.zoom(was.apart / is.apart);
    }
    down.set(event.pointerId, here);
    if (doing === "pick") acts.pick(here.x, here.y);
    if (doing === "orbit") acts.orbit(here.x - before.x, here.y - before.y);
    if (doing === "pan") acts.pan(here.x - before.x, here.y - before.y);
  }

  function release(event: PointerEvent) {
    down.delete(event.pointerId);
    if (waits && event.type === "pointercancel") acts.scrolled();
    else if (waits && acts.isOnTiles(waits.x, waits.y)) acts.pick(waits.x, waits.y); // a tap
    if (down.size === 0) settle(null);
  }

  element.addEventListener("pointerdown", press);
  element.addEventListener("pointermove", drag);
  element.addEventListener("pointerup", release);
  element.addEventListener("pointercancel", release);
  element.addEventListener("pointerleave", acts.leave);
  listenToWheel(element, acts.zoom);
  element.addEventListener("touchmove", (event) => doing && event.cancelable && event.preventDefault(), { passive: false }); // it is not the page's
  element.addEventListener("contextmenu", (event) => event.preventDefault());
}
