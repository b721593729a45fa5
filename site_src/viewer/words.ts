/**
 * Sentences and numbers for people, in the page's language. They stand in site_src/words/<language>.json, which
 * Python speaks from too; a script before the viewer's puts them into raywalkWords. Keys and slots are checked by
 * the compiler (word-keys.d.ts is made from en.json).
 */
import type { Vec3 } from "./trace/types";
import type { WordKeys } from "./word-keys";

type Value = string | number;
type Given = Readonly<Record<string, Value>>;
type Entry = string | { other: string; [form: string]: string };
interface Language {
  code: string;
  decimal: string;
  group: string; // between groups of three digits
  between: string; // between numbers of a list: with a decimal comma a comma would be misread
}

declare global {
  var raywalkWords: { language: Language };
}

type Slots<K extends keyof WordKeys> = [WordKeys[K]] extends [never] ? [] : [Record<WordKeys[K], Value>];
/** Plain words, or words with a ray kind's colour; "" for bold. */
export type Phrase = string | readonly [string, string];

const language = () => globalThis.raywalkWords.language;
export const languageCode = (): string => language().code;

function entry(key: string, slots: Given): string {
  const found = key.split(".").reduce<unknown>((at, part) => (at as Record<string, unknown>)[part], globalThis.raywalkWords) as Entry;
  return typeof found === "string" ? found : (found[new Intl.PluralRules(language().code).select(Number(slots.count))] ?? found.other);
}

const fill = (text: string, slots: Given) => text.replace(/\{(\w+)\}/g, (_, name) => String(slots[name]));

export function say<K extends keyof WordKeys>(key: K, ...given: Slots<K>): string {
  const slots: Given = given[0] ?? {};
  return fill(entry(key, slots), slots);
}

/** A sentence with **bold** and [ray kinds](camera); what fills a slot is never read as a mark. */
export function phrases<K extends keyof WordKeys>(key: K, ...given: Slots<K>): Phrase[] {
  const slots: Given = given[0] ?? {};
  // Plain, bold, coloured, its kind, and so on: of a mark's two texts one is left out.
  const parts: (string | undefined)[] = entry(key, slots).split(/\*\*(.+?)\*\*|\[(.+?)\]\((\w+)\)/);
  return parts.flatMap((part, k): Phrase[] => (part && k % 4 < 3 ? [k % 4 ? [fill(part, slots), parts[k | 3] ?? ""] : fill(part, slots)] : []));
}

export const plain = (of: readonly Phrase[]): string => of.map((phrase) => (typeof phrase === "string" ? phrase : phrase[0])).join("");

/** So many decimals; minus signs as wide as plus, and none before zeros. */
export const fixed = (value: number, digits: number): string =>
  value
    .toFixed(digits)
    .replace(/^-(?=[0.]*$)/, "")
    .replace("-", "\u2212")
    .replace(".", language().decimal);
export const number = (value: number): string => fixed(value, 3);
export const list = (values: readonly string[]): string => values.join(language().between);
/** Names in a sentence: a, b and c. In English as in Britain, without a comma before "and". */
export const allOf = (names: readonly string[]): string => new Intl.ListFormat(languageCode().replace(/^en$/, "en-GB")).format(names);
export const vector = (v: Vec3): string => `(${list(v.map(number))})`;
/** A grey as one number, a colour as three. */
export const tone = (v: Vec3): string => (v.every((each) => number(each) === number(v[0])) ? number(v[0]) : vector(v));
/** At most one decimal. */
export const percent = (share: number): string => `${fixed(100 * share, 1).replace(/\D0$/, "")}\u202f%`;
/** Whole numbers as people write them: 11 025. */
export const grouped = (value: number): string => String(value).replace(/\B(?=(\d{3})+$)/g, language().group);
/** \u00bc, \u00bd, 1, 2, ... */
export const fraction = (value: number): string => ({ 0.25: "\u00bc", 0.5: "\u00bd" })[value] ?? String(value);

const eightBit = (v: number) => Math.round(255 * Math.min(1, Math.max(0, v)));
export const bytes = (colour: Vec3): string => colour.map(eightBit).join(", ");
export const hexOf = (colour: Vec3): string => "#" + colour.map((v) => eightBit(v).toString(16).padStart(2, "0")).join("");
