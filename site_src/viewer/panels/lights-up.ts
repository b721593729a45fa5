/** Calls `light` while it is pointed at or has the focus. */
export function lightsUp(row: Element, light: (on: boolean) => void) {
  for (const on of ["pointerenter", "focus"]) row.addEventListener(on, () => light(true));
  for (const off of ["pointerleave", "blur"]) row.addEventListener(off, () => light(false));
}
