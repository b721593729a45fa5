/** What a kiosk's address holds besides the view: kiosk=1&idle=90&warn=10&attract-pace=7&home=de */

import { ADDRESS_KEYS } from "./address-keys";

export const KIOSK_KEYS: readonly string[] = ["kiosk", "idle", "warn", "attract-pace", "home", "visitor", "strikes"];

/** Least, most, and what it is when the address does not say. Seconds, but strikes. */
const NUMBERS = {
  idle: [1, 3600, 90], // without an input, until all is reset
  warn: [0.2, 60, 10], // of these, with a warning
  "attract-pace": [0.02, 600, 7], // a stop of a lesson is shown
  strikes: [0, 999, 0], // how often the page has recovered from a fault, where the browser keeps nothing
} as const;
type NumberKey = keyof typeof NUMBERS;

export interface KioskSettings {
  idle: number;
  warn: number;
  pace: number;
  home: string; // language of the start
  visitor: boolean; // somebody has begun
  strikes: number;
}

function readNumber(fields: ReadonlyMap<string, string>, key: NumberKey): number {
  const [least, most, usual] = NUMBERS[key];
  const text = fields.get(key);
  const value = text?.trim() ? Number(text) : Number.NaN;
  return Number.isNaN(value) ? usual : Math.min(most, Math.max(least, value));
}

export function readKiosk(fields: ReadonlyMap<string, string>): KioskSettings {
  const idle = readNumber(fields, "idle");
  return {
    idle,
    warn: Math.min(readNumber(fields, "warn"), idle / 2),
    pace: readNumber(fields, "attract-pace"),
    home: fields.get("home") ?? "",
    visitor: fields.get("visitor") === "1",
    strikes: Math.floor(readNumber(fields, "strikes")),
  };
}

/** What of an address is no key, or a setting that is no number in its range; such are clamped. */
export const kioskDamages = (fields: ReadonlyMap<string, string>): string[] => [
  ...[...fields.keys()].filter((key) => !ADDRESS_KEYS.includes(key) && !KIOSK_KEYS.includes(key)),
  ...Object.keys(NUMBERS).filter((key) => fields.has(key) && fields.get(key) !== String(readNumber(fields, key as NumberKey))),
];

/** As it stands in every address of the kiosk; what is as usual is left out. */
export function writeKiosk({ idle, warn, pace, home, visitor, strikes }: KioskSettings): string {
  const numbers = Object.entries({ idle, warn, "attract-pace": pace, strikes }).filter(([key, value]) => value !== NUMBERS[key as NumberKey][2]);
  const fields = [["kiosk", 1], ...numbers, ["home", encodeURIComponent(home)], ...(visitor ? [["visitor", 1]] : [])];
  return fields.map(([key, value]) => `${key}=${value}`).join("&");
}
