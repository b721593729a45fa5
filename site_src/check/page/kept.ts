/**
 * The picture that was checked last, kept in the browser's tab and nowhere else: who comes back from a mistake's page or from a
 * scene finds the report again, where they left it.
 */
import { gunzipSync, gzipSync } from "fflate";

export interface Kept {
  name: string; // of its file
  bytes: Uint8Array;
  scrolled: number; // px
}

const [NAME, BYTES, SCROLLED] = ["raywalk.checked.name", "raywalk.checked.bytes", "raywalk.checked.scrolled"];
/** A tab keeps about 5 million characters, and four of base64 hold three bytes. */
const MOST = 3_600_000;
const PORTION = 0x8000; // of arguments to one call
const isPacked = (bytes: Uint8Array) => bytes[0] === 0x1f && bytes[1] === 0x8b; // no picture that is read begins so

/** Storage may be refused, or full: then nothing is kept. */
function attempt<T>(act: () => T): T | null {
  try {
    return act();
  } catch {
    return null;
  }
}

export const forget = () => attempt(() => [NAME, BYTES, SCROLLED].forEach((key) => sessionStorage.removeItem(key)));

export function keep({ name, bytes, scrolled }: Kept): void {
  forget();
  const packed = bytes.length > MOST ? gzipSync(bytes, { level: 1 }) : bytes;
  if (packed.length > MOST) return;
  let text = "";
  for (let at = 0; at < packed.length; at += PORTION) text += String.fromCharCode(...packed.subarray(at, at + PORTION));
  attempt(() => {
    sessionStorage.setItem(BYTES, btoa(text));
    sessionStorage.setItem(NAME, name);
    sessionStorage.setItem(SCROLLED, String(Math.round(scrolled)));
    return true;
  }) ?? forget();
}

export function kept(): Kept | null {
  return attempt(() => {
    const [name, text] = [NAME, BYTES].map((key) => sessionStorage.getItem(key));
    if (name === null || text === null) return null;
    const bytes = Uint8Array.from(atob(text), (each) => each.charCodeAt(0));
    return { name, bytes: isPacked(bytes) ? gunzipSync(bytes) : bytes, scrolled: Number(sessionStorage.getItem(SCROLLED)) };
  });
}
