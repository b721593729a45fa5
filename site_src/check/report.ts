/**
 * What is said of a picture, line by line, in the order of its questions: how right, where, what it looks like, walk it. The page
 * check/ lays these lines out, what is copied there and `raywalk compare` write them down.
 */
import { the } from "../viewer/articles";
import { fixed, list, percent, say } from "../viewer/words";
import type { About } from "./atlas";
import type { Checked } from "./check";
import { WITHIN } from "./compare";
import type { Told } from "./places";
import type { Answer, Recognised } from "./recognise";
import type { Refusal, Source, Square } from "./square";
import type { Apart } from "./telling-apart";
import type { Tile } from "./tiles";

export type Part = "verdict" | "how" | "where" | "looks" | "walk";

export type Line = { part: Part; words: string } & (
  | { kind: "verdict" | "note" | "head" | "fit" | "place" | "says" | "alike" | "apart" | "beside" }
  | { kind: "number" | "columns" | "object"; values: string[] } // columns: what stands above the objects' values
  | { kind: "answer"; values: string[]; names: string[]; titles: string[] } // names: of mistakes.json
  | { kind: "line"; values: [string, string]; name: string } // of a named mistake, the line to look for: right, wrong
  | { kind: "tile"; values: string[]; tile: Tile }
);

export interface Found {
  file: { name: string; width: number; height: number };
  square: Square;
  source: Source;
  checked: Checked;
  leftOut: About["leftOut"];
  nearest: number; // size that can be checked exactly
  /** Id of a scene that tells two mistakes apart which look the same in this one; null: none is known. */
  apartIn?: (a: string, b: string) => string | null;
}

/** What things are called in the language. */
export interface Names {
  scene: string;
  objects: string[];
  mistakes: Record<string, Named>; // by the names of mistakes.json
  scenes?: Record<string, string>; // titles of all, by id
}

/** What is said of a mistake: its title, and the line to look for in a program. */
export interface Named {
  title: string;
  right: string;
  wrong: string;
}

/** Fewer wrong pixels are nearly none. */
const CLOSE = 0.02;
/** Of the table of objects: rows, and the least share of the wrong pixels. */
const [ROWS, LEAST] = [6, 0.005];

export function reportOf(found: Found, names: Names): Line[] {
  const { isRight } = found.checked;
  const rest = isRight ? [] : [...where(found, names), ...looks(found, names), ...walk(found, names)];
  return [...verdict(found, names), ...howRight(found), ...rest];
}

/** Of what is no picture, or none that can be compared. */
export const sentenceAlone = (words: string): Line[] => [{ part: "verdict", kind: "verdict", words }];
export const refused = ({ word, figures }: Refusal): string => say(`check.verdict.${word}`, figures);

/** Without a page: a line is its words and what stands beside them; what follows a head stands in. */
export const written = (lines: Line[]): string[] => lines.map((line) => {
  const words = line.kind === "answer" ? line.titles.map((title, k) => `${title} (${line.names[k]})`).join(" / ") : line.words;
  if (line.kind === "line") return `    ${words} (${line.name}): ${say("check.looks.both", { right: line.values[0], wrong: line.values[1] })}`;
  const indent = line.part === "verdict" || line.kind === "head" ? "" : "  ";
  return `${indent}${words}${"values" in line ? `: ${list(line.values)}` : ""}`;
});

function headline({ checked: { isRight, comparison }, source }: Found): string {
  if (isRight) return say(source.isExact ? "check.verdict.right" : "check.verdict.nearly");
  const wrong = 1 - comparison.within[0];
  return say(wrong < CLOSE ? "check.verdict.close" : "check.verdict.wrong", { share: percent(wrong) });
}

/** What is most to know comes first: of one mistake or of two together. */
function mostLike({ answers: [first, second], isPair }: Recognised, { mistakes }: Names): string {
  const titles = ({ names }: Answer) => names.map((name) => mistakes[name].title).join(" / ");
  return isPair ? say("check.verdict.looksTwo", { first: titles(first), second: titles(second) }) : say("check.verdict.looks", { title: titles(first) });
}

function verdict(found: Found, names: Names): Line[] {
  const { file, checked, square: { picture, isCut }, source, nearest } = found;
  const size = picture.width;
  const notes: [boolean, string][] = [
    [true, say("check.verdict.file", { ...file, scene: names.scene })],
    [checked.isRight && source.isExact, say("check.verdict.rightSays")],
    [isCut, say("check.verdict.cut", { size })],
    [!source.isExact, say("check.verdict.sampled", { size, from: source.from, nearest })],
    [picture.isLossy, say("check.verdict.lossy")],
    [picture.hadAlpha, say("check.verdict.alpha")],
    [checked.comparison.isTruncated, say("check.how.truncated")],
  ];
  const told = [...(!checked.isRight && checked.answers.length ? [mostLike(checked, names)] : []), ...notes.filter(([holds]) => holds).map(([, words]) => words)];
  return [...sentenceAlone(headline(found)), ...told.map((words): Line => ({ part: "verdict", kind: "note", words }))];
}

function howRight({ checked: { comparison: { within, mean, largest, fits } } }: Found): Line[] {
  const part = "how";
  const number = (words: string, value: string): Line => ({ part, kind: "number", words, values: [value] });
  const steps = (value: number, digits: number) => say("check.how.steps", { value: fixed(value, digits) });
  return [
    { part, kind: "head", words: say("check.how.head") },
    ...(fits ? [{ part, kind: "fit", words: say(`check.fits.${fits.as}`) } as const] : []),
    ...WITHIN.map((limit, k) => number(say("check.how.within", { steps: limit }), percent(within[k]))),
    number(say("check.how.mean"), steps(mean, 2)),
    number(say("check.how.largest"), steps(largest, 0)),
  ];
}

const nameOf = ({ objects }: Names, object: number) => objects[object] ?? say("check.where.backgroundName");

function where({ checked: { where: { told, objects } } }: Found, names: Names): Line[] {
  const part = "where";
  const rows = objects.filter(({ ofWrong }) => ofWrong >= LEAST).slice(0, ROWS);
  const places = told.length ? told.map((each) => placeOf(each, names)) : [say("check.where.none")];
  return [
    { part, kind: "head", words: say("check.where.head") },
    ...places.map((words): Line => ({ part, kind: "place", words })),
    { part, kind: "columns", words: say("check.where.tableObject"), values: [say("check.where.tableWrong"), say("check.where.tableOf")] },
    ...rows.map(({ object, wrong, ofWrong }): Line => ({ part, kind: "object", words: nameOf(names, object), values: [percent(wrong), percent(ofWrong)] })),
  ];
}

const placeOf = (told: Told, names: Names): string => say("check.where.only", { share: percent(told.ofWrong), place: inWords(told, names), part: percent(told.ofPicture) });

const inWords = ({ kind, object }: Told, names: Names): string => (kind === "object" ? say("check.where.object", { name: the(nameOf(names, object)) }) : say(`check.where.${kind}`));

function looks({ checked: { answers, isPair, apart }, leftOut, apartIn }: Found, names: Names): Line[] {
  const part = "looks";
  const { mistakes } = names;
  const none = leftOut ? say(`check.looks.left.${leftOut}`) : say("check.looks.none");
  const told = say(isPair ? "check.looks.pair" : "check.looks.says");
  return [
    { part, kind: "head", words: say("check.looks.head") },
    { part, kind: "says", words: answers.length ? told : none },
    ...answers.flatMap(({ names: own, agreement }, k): Line[] => {
      const titles = own.map((name) => mistakes[name].title);
      const lines = own.map((name): Line => ({ part, kind: "line", words: say("check.looks.line"), values: [mistakes[name].right, mistakes[name].wrong], name }));
      const answer: Line = { part, kind: "answer", words: titles.join(" / "), values: [say("check.looks.agree", { share: percent(agreement) })], names: own, titles };
      const says = (kind: "alike" | "apart", words: string): Line => ({ part, kind, words });
      return [answer, ...lines, ...(own.length > 1 ? [says("alike", alike(own, apartIn, names))] : []), ...(apart && k === 1 ? [says("apart", tellingApart(apart, names))] : [])];
    }),
  ];
}

/** Of mistakes that look the same in this scene: which other one tells the first two apart. */
function alike([a, b]: string[], apartIn: Found["apartIn"], { scenes }: Names): string {
  const scene = apartIn?.(a, b);
  return scene && scenes?.[scene] ? say("check.looks.alikeBut", { scene: scenes[scene] }) : say("check.looks.alike");
}

function tellingApart({ place, x, y, first, second, own }: Apart, names: Names): string {
  return say("check.looks.apart", { place: inWords(place, names), x, y, first: first.join(", "), second: second.join(", "), yours: own.join(", ") });
}

function walk({ checked: { tiles, areBeside }, square: { picture: { width: size } } }: Found, names: Names): Line[] {
  const part = "walk";
  if (!tiles.length) return [];
  const colours = ({ own, right }: Tile) => say("check.walk.colours", { yours: own.join(", "), right: right.join(", ") });
  return [
    { part, kind: "head", words: say("check.walk.head") },
    { part, kind: "says", words: say("check.walk.says") },
    ...(areBeside ? [{ part, kind: "beside", words: say("check.walk.beside", { n: tiles[0].n, size }) } as const] : []),
    ...tiles.map((tile): Line => ({ part, kind: "tile", words: say("check.walk.pixel", { x: tile.x, y: tile.y, n: tile.n, name: nameOf(names, tile.object) }), values: [colours(tile)], tile })),
  ];
}
