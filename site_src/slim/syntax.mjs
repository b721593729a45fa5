/** A script's syntax tree, what can be said of its parts, and cutting in its text. */
import { parse } from "acorn";

export const treeOf = (source) => parse(source, { ecmaVersion: "latest", sourceType: "module" });

export function childrenOf(node) {
  const found = [];
  for (const key in node) {
    const value = node[key];
    if (!value || typeof value !== "object") continue;
    if (Array.isArray(value)) {
      for (const each of value) if (each && typeof each.type === "string") found.push(each);
    } else if (typeof value.type === "string") found.push(value);
  }
  return found;
}

/** Every node below, each with its parent, before its children. */
export function walk(node, visit, parent = null) {
  visit(node, parent);
  for (const child of childrenOf(node)) walk(child, visit, node);
}

/** The plain name of a member, property or key; null where it is worked out. */
export const nameOf = (node) => {
  const key = node.type === "MemberExpression" ? node.property : node.key;
  if (node.computed || key.type === "PrivateIdentifier") return null;
  return key.type === "Identifier" ? key.name : String(key.value);
};

/** Working it out changes nothing but what it is assigned to. */
export function isPure(node) {
  if (!node) return true;
  switch (node.type) {
    case "FunctionExpression":
    case "ArrowFunctionExpression":
    case "Identifier":
    case "Literal":
      return true;
    case "UnaryExpression":
      return node.operator !== "delete" && isPure(node.argument);
    case "MemberExpression":
      return !node.computed && isPure(node.object);
    case "ArrayExpression":
      return node.elements.every(isPure);
    case "ObjectExpression":
      return node.properties.every((each) => each.type === "Property" && !each.computed && isPure(each.value));
    default:
      return false;
  }
}

/** null, false, 0, "", undefined, and !1 and void 0 as minified code writes them. */
export function isFalsy(node) {
  if (node.type === "Literal") return !node.value && !node.regex && node.bigint === undefined;
  if (node.type === "Identifier") return node.name === "undefined";
  if (node.type !== "UnaryExpression" || node.argument.type !== "Literal") return false;
  return node.operator === "void" || (node.operator === "!" && !isFalsy(node.argument)) || (node.operator === "-" && node.argument.value === 0);
}

/** The text after changes [{ start, end, text }]; one within another gives way to the outer one. */
export function changed(source, changes) {
  const sorted = [...changes].sort((a, b) => a.start - b.start || b.end - a.end);
  let [kept, at] = ["", 0];
  for (const { start, end, text = "" } of sorted) {
    if (start < at) continue;
    kept += source.slice(at, start) + text;
    at = end;
  }
  return kept + source.slice(at);
}
