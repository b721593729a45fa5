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

/** Parts that may go wait under their name; what reads the name brings them in. */
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
    return Object.values(this.waiting).flatMap((parts) => [...parts.values()].flat());
  }

  /** inside: what is needed with it. list: the comma-separated parts it is one of, and all of them. */
  mayGo(space, name, node, inside, list = null) {
    if (this.read[space].has(name)) return void this.todo.push(...inside);
    const parts = this.waiting[space];
    if (!parts.has(name)) parts.set(name, []);
    parts.get(name).push({ node, inside, list });
  }

  reads(space, name) {
    if (name === null || this.read[space].has(name)) return;
    this.read[space].add(name);
    for (const part of this.waiting[space].get(name) ?? []) this.todo.push(...part.inside);
    this.waiting[space].delete(name);
  }

  visit(node) {
    if (!this[node.type]?.(node)) for (const child of childrenOf(node)) this.visit(child);
  }

  ClassBody({ body }) {
    for (const member of body) {
      const name = member.type === "MethodDefinition" ? nameOf(member) : null;
      if (name === null || name === "constructor") this.visit(member);
      else this.mayGo("member", name, member, [member.value]);
    }
    return true;
  }

  /** `this.name = function` and the like, alone or several with commas between. */
  ExpressionStatement(node) {
    const { expression } = node;
    if (expression.type === "SequenceExpression") return this.sequence(expression, expression.expressions.length, node);
    return this.ownSetting(expression, node, null);
  }

  SequenceExpression(node) {
    return this.sequence(node, node.expressions.length - 1, null); // the last one is its value
  }

  sequence({ expressions }, count, whole) {
    const list = { parts: expressions, whole };
    expressions.forEach((each, at) => {
      if (at >= count || !this.ownSetting(each, each, list)) this.visit(each);
    });
    return true;
  }

  ownSetting({ type, operator, left, right }, node, list) {
    const isOwn = type === "AssignmentExpression" && operator === "=" && left.type === "MemberExpression" && left.object.type === "ThisExpression";
    if (!isOwn || left.computed || !isPure(right)) return false;
    this.mayGo("member", left.property.name, node, [right], list);
    return true;
  }

  /** What a maker of an object hands out: `return { setMask: setMask, ... }`. */
  ReturnStatement({ argument }) {
    if (argument?.type !== "ObjectExpression") return false;
    const list = { parts: argument.properties, whole: null };
    for (const each of argument.properties) {
      const name = each.type === "Property" ? nameOf(each) : null;
      if (name === null || !isPure(each.value)) this.visit(each);
      else this.mayGo("member", name, each, [each.value], list);
    }
    return true;
  }

  BlockStatement({ body }) {
    for (const each of body) each.isInner = true;
    return false;
  }

  FunctionDeclaration(node) {
    if (!node.isInner) return false;
    this.mayGo("local", node.id.name, node, [...node.params, node.body]);
    return true;
  }

  VariableDeclaration(node) {
    if (!node.isInner) return false;
    const list = { parts: node.declarations, whole: node };
    for (const each of node.declarations) {
      if (each.id.type !== "Identifier" || !isPure(each.init)) this.visit(each);
      else this.mayGo("local", each.id.name, each, each.init ? [each.init] : [], list);
    }
    return true;
  }

  MemberExpression(node) {
    this.reads("member", nameOf(node));
    this.visit(node.object);
    if (node.computed) this.visit(node.property);
    return true;
  }

  Property(node) {
    this.reads("member", nameOf(node));
    return this.withoutKey(node);
  }

  MethodDefinition(node) {
    return this.withoutKey(node);
  }

  PropertyDefinition(node) {
    return this.withoutKey(node);
  }

  withoutKey(node) {
    if (node.computed) this.visit(node.key);
    if (node.value) this.visit(node.value);
    return true;
  }

  Identifier({ name }) {
    this.reads("local", name);
    return true;
  }

  Literal({ value }) {
    if (typeof value === "string") this.reads("member", value);
    return true;
  }
}

/** Where to cut: a part alone; of a list also the commas; all of a list with what holds it. */
function cutsOf(gone) {
  const cuts = gone.filter(({ list }) => !list).map(({ node }) => ({ start: node.start, end: node.end }));
  const lists = new Map();
  for (const { node, list } of gone) if (list) lists.set(list, (lists.get(list) ?? new Set()).add(node));
  for (const [{ parts, whole }, those] of lists) {
    if (whole && those.size === parts.length) cuts.push({ start: whole.start, end: whole.end });
    else
      parts.forEach((part, at) => {
        if (!those.has(part)) return;
        const next = parts.slice(at + 1).find((each) => !those.has(each));
        const before = parts.slice(0, at).findLast((each) => !those.has(each));
        cuts.push(next || !before ? { start: part.start, end: parts[at + 1]?.start ?? part.end } : { start: before.end, end: part.end });
      });
  }
  return cuts;
}

/** The script without members and inner functions that neither it nor `members` names. */
export const withoutUnnamed = (source, members) => changed(source, cutsOf(new Shaker(members).unnamed(treeOf(source))));
