/** The ray tree as text and as a table for spreadsheets. */
import { isGiving } from "../state/events";
import type { LightRow, RayRow } from "../state/ray-rows";
import type { Vec3 } from "../trace/types";
import { list, number, percent, plain, say, tone, vector } from "../words";
import { copy } from "./clipboard";
import { lightWords, rayWords } from "./ray-words";

const colour = (v: Vec3) => list(v.map(number));

function lightText(light: LightRow): string {
  const gives = [say("card.light", { diffuse: number(light.diffuse), specular: number(light.specular) }), `${say("card.gives")} ${tone(light.gives)}`];
  return [plain(lightWords(light)), ...(isGiving(light) ? gives : [])].join("; ");
}

function rayText(row: RayRow): string[] {
  const parts = [
    `${row.number}  ${plain(rayWords(row))}${row.material && row.material !== row.object ? ` (${row.material})` : ""}`,
    ...(row.object ? [say("card.t", { t: number(row.t) }), vector(row.point), say("card.normal", { normal: vector(row.normal) })] : []),
    say("card.tests", { count: row.tests }),
    ...(row.of ? [say("card.share", { share: percent(row.weight), ray: row.of })] : []),
    ...(row.base ? [say("card.base", { colour: tone(row.base) })] : []),
    ...(row.lights.length ? [say("card.ambient", { colour: tone(row.ambient) })] : []),
    `${say("card.brings")} ${colour(row.colour)}`,
  ];
  const hits = row.hits.length > 1 ? [`   ${row.hits.map(({ name, t }) => `${name} ${number(t)}`).join("; ")}`] : [];
  const indent = "   ".repeat(row.depth);
  return [parts.join("; "), ...hits, ...row.lights.map((light) => `   ${lightText(light)}`)].map((line) => indent + line);
}

export const treeText = (title: string, rows: readonly RayRow[]): string => [title, ...rows.flatMap(rayText)].join("\n") + "\n";

/** Column names are for programs: they are the same in every language, and numbers have a point. */
export function treeTable(rows: readonly RayRow[]): string {
  const digits = (v: number) => (Number.isFinite(v) ? String(Number(v.toPrecision(8))) : "");
  const quoted = (text: string) => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  const three = (name: string, of: (row: RayRow) => Vec3, letters = "xyz") => [...letters].map((letter, k) => [`${name}_${letter}`, (row: RayRow) => digits(of(row)[k])] as const);
  const lights = Math.max(0, ...rows.map((row) => row.lights.length));
  const ofLight = (k: number, name: string, of: (light: LightRow) => string) => [`light${k + 1}_${name}`, (row: RayRow) => (row.lights[k] ? of(row.lights[k]) : "")] as const;
  const columns: (readonly [string, (row: RayRow) => string])[] = [
    ["ray", (row) => String(row.number)],
    ["from_ray", (row) => (row.of ? String(row.of) : "")],
    ["kind", (row) => row.kind],
    ["object", (row) => row.object],
    ["material", (row) => row.material],
    ["t", (row) => digits(row.t)],
    ...three("point", (row) => row.point),
    ...three("normal", (row) => row.normal),
    ["tests", (row) => String(row.tests)],
    ["weight", (row) => digits(row.weight)],
    ["share_of_pixel", (row) => digits(row.share)],
    ["local_weight", (row) => digits(row.keeps)],
    ...(rows.some(({ base }) => base) ? three("base", (row) => row.base ?? [1, 1, 1], "rgb") : []),
    ...three("ambient", (row) => row.ambient, "rgb"),
    ...three("colour", (row) => row.colour, "rgb"),
    ...Array.from({ length: lights }, (_, k) => [
      ofLight(k, "name", ({ name }) => name),
      ofLight(k, "seen", ({ seen }) => seen),
      ofLight(k, "blocked_by", ({ by }) => by),
      ofLight(k, "diffuse", ({ diffuse }) => digits(diffuse)),
      ofLight(k, "specular", ({ specular }) => digits(specular)),
      ...[..."rgb"].map((letter, c) => ofLight(k, `gives_${letter}`, ({ gives }) => digits(gives[c]))),
    ]).flat(),
  ];
  return [columns.map(([name]) => name), ...rows.map((row) => columns.map(([, of]) => quoted(of(row))))].map((line) => `${line.join(",")}\r\n`).join("");
}

/** title: of the text. done: the clipboard has it. */
export const copyRays = (what: "text" | "table", title: string, rows: readonly RayRow[], done: () => void) => void copy(what === "text" ? treeText(title, rows) : treeTable(rows), done);
