/** Formulas as MathML. Colours stand as columns, greys as one number. */
import { number } from "../words";
import type { Vec3 } from "../trace/types";

const MATHML = "http://www.w3.org/1998/Math/MathML";
type Part = Node | string;

export function math(tag: string, ...parts: Part[]): MathMLElement {
  const made = document.createElementNS(MATHML, tag) as MathMLElement;
  made.append(...parts);
  return made;
}

/** Infix also where a line of the formula begins with it. */
export function operator(sign: string) {
  const made = math("mo", sign);
  made.setAttribute("form", "infix");
  return made;
}
export const times = () => operator("\u00d7");
export const figure = (value: number) => math("mn", number(value));
export const indexed = (name: string, index: number) => math("msub", math("mi", name), math("mn", String(index)));

/** Words under a term. */
export const under = (term: Part, words: string) => math("munder", term, math("mtext", words));

export const isGrey = (v: Vec3) => v.every((each) => number(each) === number(v[0]));

/** Three numbers, one over the other. */
export function column(values: readonly string[]): MathMLElement {
  const table = math("mtable", ...values.map((value) => math("mtr", math("mtd", math("mn", value)))));
  table.setAttribute("class", "column");
  return table;
}

/** A piece of a formula that may go to the next line as a whole. */
export const piece = (...parts: Part[]) => math("math", math("mrow", ...parts));
