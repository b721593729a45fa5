/**
 * Drops what bundlers keep: methods of used classes, functions inside used functions. By names, for
 * all the script at once: a method goes if its name is read nowhere in what stays, be it as a
 * property, a key, a string or part of a pattern. So it errs on the side of keeping.
 */
import { changed, childrenOf, isPure, nameOf, treeOf, walk } from "./syntax.mjs";

/** Called by the language itself, without a name in the source. */
const IMPLICIT = ["constructor", "toString", "valueOf", "then", "next", "return"];

/** Names that code which is not given here reads: its properties, keys, strings. */
export function namesIn(source) {
  const names = new Set();
  walk(treeOf(source), (node) => {
    if (node.type === "Identifier") names.add(node.name);
    if (node.type === "Literal" && typeof node.value === "string") names.add(node.value);
  });
  return names;
}

/** Parts that may go wait under their name; what reads the name brings them in. A method for each type of node: true
 *  if it has visited what is below. */
class Shaker {
  constructor(members) {
    this.read = { member: new Set([...IMPLICIT, ...members]), local: new Set() };
    this.waiting = { member: new Map(), local: new Map() };
    this.todo = [];
  }

  /** The parts of a tree that nothing named. */
  unnamed(tree) {
    for (const node of tree.body) this.visit(node);
    while (this.todo.length) this.visit(this.todo.pop());
    return Object.values(this.waiting).flatMap((parts) => [...parts.values()].flat()).map(({ node }) => node);
  }

  /** inside: what is needed with it. */
  mayGo(space, name, node, inside) {
    if (this.read[space].has(name)) return this.todo.push(...inside);
    const parts = this.waiting[space];
    return parts.set(name, [...(parts.get(name) ?? []), { node, inside }]);
  }

  reads(space, name) {
    if (name === null || this.read[space].has(name)) return;
    this.read[space].add(name);
    for (const part of this.waiting[space].get(name) ?? []) this.todo.push(...part.inside);
    this.waiting[space].delete(name);
  }

  visit(node) {
    if (this[node.type]?.(node)) return;
    for (const child of childrenOf(node)) if (child !== node.key || node.computed) this.visit(child);
  }

  ClassBody({ body }) {
    for (const member of body) {
      const name = member.type === "MethodDefinition" ? nameOf(member) : null;
      if (name === null || name === "constructor") this.visit(member);
      else this.mayGo("member", name, member, [member.value]);
    }
    return true;
  }

  ExpressionStatement({ expression }) {
    expression.isUnused = true;
  }

  SequenceExpression({ expressions, isUnused }) {
    for (const [at, each] of expressions.entries()) each.isUnused = isUnused || at < expressions.length - 1;
  }

  /** `this.name = function` and the like. */
  AssignmentExpression(node) {
    const { isUnused, operator, left, right } = node;
    const isOwn = isUnused && operator === "=" && left.type === "MemberExpression" && left.object.type === "ThisExpression" && !left.computed;
    return isOwn && isPure(right) && this.mayGo("member", left.property.name, node, [right]);
  }

  BlockStatement({ body }) {
    for (const each of body) each.isInner = true;
  }

  FunctionDeclaration(node) {
    return node.isInner && this.mayGo("local", node.id.name, node, [...node.params, node.body]);
  }

  MemberExpression(node) {
    this.reads("member", nameOf(node));
    this.visit(node.object);
    if (node.computed) this.visit(node.property);
    return true;
  }

  Property(node) {
    this.reads("member", nameOf(node));
  }

  Identifier({ name }) {
    this.reads("local", name);
  }

  Literal({ value }) {
    if (typeof value === "string") this.reads("member", value);
  }
}

/** The script without members and inner functions that neither it nor `members` names; of an assignment a 0 is left,
 *  which the bundler drops. */
export const withoutUnnamed = (source, members) =>
  changed(source, new Shaker(members).unnamed(treeOf(source)).map(({ type, start, end }) => ({ start, end, text: type === "AssignmentExpression" ? "0" : "" })));
