/** A finger that comes down on a slider may mean the page: the slider keeps still until the finger goes along it, or leaves where it came. */
const SLIDER = "input[type=range]";
const STILL = 6; // CSS pixels that a resting finger may move

export function listenToFingers(home: HTMLElement) {
  let down: { x: number; y: number; slider: HTMLInputElement; value: string; wanted: string } | null = null; // while nobody knows what it means

  home.addEventListener("pointerdown", ({ pointerType, target, clientX: x, clientY: y }) => {
    down = pointerType === "touch" && target instanceof HTMLInputElement && target.matches(SLIDER) ? { x, y, slider: target, value: target.value, wanted: target.value } : null;
  });
  home.addEventListener("pointermove", ({ clientX, clientY }) => {
    const along = Math.abs(clientX - (down?.x ?? clientX));
    if (down && along > STILL && along > Math.abs(clientY - down.y)) down = null;
  });
  home.addEventListener("pointerup", () => {
    if (!down) return;
    const { slider, wanted } = down;
    down = null;
    slider.value = wanted; // what is drawn meanwhile puts it back
    slider.dispatchEvent(new Event("input", { bubbles: true }));
  });
  home.addEventListener("pointercancel", () => {
    if (down) down.slider.value = down.value; // the page scrolls
    down = null;
  });
  home.addEventListener(
    "input",
    (event) => {
      if (!down || down.slider !== event.target) return;
      down.wanted = down.slider.value;
      event.stopPropagation();
    },
    true,
  );
}
