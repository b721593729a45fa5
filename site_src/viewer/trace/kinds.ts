/** The table of ray kinds, which the pipeline reads too: trace/kinds.py there says what its columns mean. */
import { lines, rays } from "../../../build/raywalk/trace/ray_kinds.json";

export type RayKind = keyof typeof rays;
export type SentKind = Exclude<RayKind, "camera">; // by a hit
export type LineKind = keyof typeof lines; // shadow rays too

interface Drawn {
  dash: readonly [drawn: number, gap: number];
  wide: number;
  dark: string;
  light: string;
}
/** A ray as its hit sends it on. */
interface Sent {
  code: number;
  branch: number;
  outline: string;
  part?: string;
}

export const RAYS: Readonly<Record<RayKind, Sent>> = rays;
export const LINES = lines as unknown as Readonly<Record<LineKind, Drawn>>; // JSON has no pairs
export const RAY_KINDS = Object.keys(rays) as RayKind[]; // by code
export const LINE_KINDS = Object.keys(LINES) as LineKind[]; // in the order of the legend
export const KIND = Object.fromEntries(RAY_KINDS.map((kind) => [kind, rays[kind].code])) as Readonly<Record<RayKind, number>>;

const sent = RAY_KINDS.filter((kind) => KIND[kind] > 0);
export const BRANCH_OF = Uint8Array.from(RAY_KINDS, (kind) => rays[kind].branch); // by code
export const BRANCHES = Math.max(...BRANCH_OF) + 1; // a hit sends on at most one ray of each
export const CHILDREN = 1 << sent.length; // sets of kinds that a hit may send on

/** In a hit's `children`: that it sends such a ray on. */
export const bitOf = (kind: RayKind): number => 1 << (KIND[kind] - 1);

/** Of each branch and set of kinds, the code of the kind that is sent on, 0 if none; of two the later stands. */
export const SENT = Array.from({ length: BRANCHES }, (_, branch) =>
  Uint8Array.from({ length: CHILDREN }, (_, bits) => Math.max(0, ...sent.filter((kind) => rays[kind].branch === branch && bits & bitOf(kind)).map((kind) => KIND[kind]))),
);
