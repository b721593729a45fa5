/**
 * Writes in what can only have one value, so that the bundler drops what hangs on it. By names, for
 * all the script at once:
 * - a flag such as `isSkinnedMesh` that nothing sets is undefined;
 * - a property of a material, a texture ... that is never set to anything but null, false or 0 is
 *   false wherever it is asked for as a condition;
 * - a variable that nothing assigns again has its first value.
 */
import { changed, isFalsy, nameOf, treeOf, walk } from "./syntax.mjs";

const FLAG = /^is[A-Z]/;
/** Names three gives to its own objects: what these hold was put in by the script itself. */
const OWN_THING = /^_?(material|capabilities|parameters|object|texture|geometry|camera|light|scene|renderTarget|group|envMap|_currentRenderTarget|depthTexture|shaderAttribute|attribute|parent)$/;

const isOwnThing = (node) => node.type === "Identifier" && OWN_THING.test(node.name);

/** All that sets a property: [name, value or null where it is not plain to see]. */
function settingsIn(tree) {
  const found = [];
  const set = (name, value) => name !== null && found.push([name, value]);
  walk(tree, (node, parent) => {
    if (node.type === "AssignmentExpression" && node.left.type === "MemberExpression") set(nameOf(node.left), node.operator === "=" ? node.right : null);
    else if (node.type === "UpdateExpression" && node.argument.type === "MemberExpression") set(nameOf(node.argument), null);
    else if (node.type === "Property" && parent.type === "ObjectExpression") set(nameOf(node), node.value);
    else if (node.type === "PropertyDefinition") set(nameOf(node), node.value ?? NOTHING);
    else if (node.type === "MethodDefinition") set(nameOf(node), null);
    else if (node.type === "Literal" && typeof node.value === "string") set(node.value, null);
  });
  return found;
}
const NOTHING = { type: "Literal", value: null };

/** Names that are set to something, by taking all for never set until a setting says otherwise. */
function namesSet(settings, firstValueOf) {
  const something = new Set();
  const isNothing = (node, name) => {
    if (!node) return false;
    switch (node.type) {
      case "Identifier":
        return firstValueOf.has(node.name) ? isNothing(firstValueOf.get(node.name), name) : isFalsy(node);
      case "MemberExpression": {
        const from = nameOf(node);
        return from !== null && (from === name || isOwnThing(node.object)) && !something.has(from);
      }
      case "UnaryExpression":
        return isFalsy(node) || (node.operator === "!" && node.argument.type === "UnaryExpression" && node.argument.operator === "!" && isNothing(node.argument.argument, name));
      case "BinaryExpression":
        return node.operator === ">" && node.right.value === 0 && isNothing(node.left, name);
      case "LogicalExpression":
        return node.operator === "&&" ? isNothing(node.left, name) || isNothing(node.right, name) : isNothing(node.left, name) && isNothing(node.right, name);
      case "ObjectExpression": // the definition of a uniform
        return node.properties.some((each) => each.type === "Property" && nameOf(each) === "value");
      default:
        return isFalsy(node);
    }
  };
  for (let before = -1; before !== something.size; ) {
    before = something.size;
    for (const [name, value] of settings) if (!something.has(name) && !isNothing(value, name)) something.add(name);
  }
  return something;
}

/** others: scripts that are not changed but may set properties too. */
export function withConstants(source, others) {
  const tree = treeOf(source);
  const variables = firstValues(tree);
  const settings = [...settingsIn(tree), ...others.flatMap((other) => settingsIn(treeOf(other)))];
  const [something, known] = [namesSet(settings, variables), new Set(settings.map(([name]) => name))];
  const above = new Map();
  const changes = [];
  walk(tree, (node, parent) => {
    above.set(node, parent);
    if (node.type !== "MemberExpression" || node.computed || node.optional || parent.type === "CallExpression") return;
    if (parent.type === "AssignmentExpression" && parent.left === node) return;
    const name = nameOf(node);
    const [isOwn, isUnset] = [isOwnThing(node.object), !known.has(name)];
    if (something.has(name) || !(isOwn || (isUnset && FLAG.test(name)))) return;
    const isCompared = parent.type === "BinaryExpression" && parent.operator === ">" && parent.right.value === 0;
    if (isCompared) changes.push({ start: parent.start, end: parent.end, text: "(!1)" });
    else if (isUnset) changes.push({ start: node.start, end: node.end, text: "(void 0)" });
    else if (isAsked(node, above)) changes.push({ start: node.start, end: node.end, text: "(!1)" });
  });
  return changed(source, [...changes, ...inlined(tree, source, variables)]);
}

/** Is it only asked whether this is true? a && b: the left one is, the right one if the whole is. */
function isAsked(node, above) {
  for (let at = node; ; at = above.get(at)) {
    const parent = above.get(at);
    if (parent.test === at || (parent.type === "UnaryExpression" && parent.operator === "!")) return true;
    if (parent.type !== "LogicalExpression" || parent.operator === "??") return false;
    if (parent.operator === "&&" && parent.left === at) return true;
  }
}

/** Variables that are declared once and never assigned again: name -> the node of its value. */
function firstValues(tree) {
  const declared = new Map(); // name -> how often
  const values = new Map();
  const assigned = new Set();
  const note = (pattern, into) => walk(pattern, (each) => each.type === "Identifier" && into(each.name));
  const declare = (name) => declared.set(name, (declared.get(name) ?? 0) + 1);
  walk(tree, (node) => {
    const { type, id, init } = node;
    const declares = /Declarator|Function|Class|Catch/.test(type) ? [id, node.param, ...(node.params ?? [])] : [];
    for (const pattern of declares.filter(Boolean)) note(pattern, declare);
    if (/^(AssignmentExpression|UpdateExpression|For(In|Of)Statement)$/.test(type)) note(node.left ?? node.argument, (name) => assigned.add(name));
    if (type === "VariableDeclarator" && init && id.type === "Identifier") values.set(id.name, init);
  });
  for (const name of values.keys()) if (declared.get(name) !== 1 || assigned.has(name)) values.delete(name);
  return values;
}

/** Reads of variables whose only value is a plain one: that value. */
function inlined(tree, source, values) {
  const changes = [];
  walk(tree, (node, parent) => {
    if (node.type !== "Identifier" || !values.has(node.name) || !isPlain(values.get(node.name))) return;
    if (parent.type === "VariableDeclarator" && parent.id === node) return;
    if ((parent.type === "MemberExpression" && parent.property === node && !parent.computed) || parent.key === node || parent.shorthand || /^Export/.test(parent.type)) return;
    const { start, end } = values.get(node.name);
    changes.push({ start: node.start, end: node.end, text: `(${source.slice(start, end)})` });
  });
  return changes;
}

/** null, a truth value, a small number, undefined. */
const isPlain = (node) => (node.type === "Literal" ? node.value === null || typeof node.value === "boolean" || typeof node.value === "number" : isFalsy(node) || (node.type === "UnaryExpression" && node.operator === "!" && node.argument.type === "Literal"));
