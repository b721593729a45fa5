/**
 * three's shader texts without comments, without what hangs on a macro that nothing defines, without
 * functions that nothing calls, and only those that are used. By names, as members.mjs does.
 */
import { changed, nameOf, treeOf, walk } from "./syntax.mjs";

/** Comments and spaces out; lines stay where the preprocessor needs them, and "void main() {" for those
 *  who put something before or after it. */
export function tight(shader) {
  const bare = shader.replace(/\/\*[\s\S]*?\*\//g, " ").replace(/\/\/.*$/gm, "");
  const lines = bare.split("\n").map((line) => line.trim()).filter(Boolean);
  return lines.map((line) => (line.startsWith("#") ? `\n${line.replace(/\s+/g, " ")}\n` : squeezed(line))).join(" ").replace(/ ?\n+ ?/g, "\n").replace(/([;{},]) /g, "$1").replace("void main(){", "void main() {").trim();
}

const squeezed = (line) => line.replace(/\s+/g, " ").replace(/ ?([-=+*/<>!&|?:;,(){}[\]]) ?/g, "$1");

/** Top-level texts: { name, text, start, end }. */
function textsOf(tree) {
  const found = [];
  for (const { type, declarations } of tree.body) {
    if (type !== "VariableDeclaration") continue;
    for (const { id, init } of declarations) {
      const text = init?.type === "TemplateLiteral" && !init.expressions.length ? init.quasis[0].value.cooked : init?.type === "Literal" ? init.value : null;
      if (typeof text === "string" && /[;{#]/.test(text)) found.push({ name: id.name, text, start: init.start, end: init.end });
    }
  }
  return found;
}

/** One condition of the preprocessor: true, false or null where it depends. */
function truth(condition, isOff) {
  const tokens = condition.match(/defined ?\( ?\w+ ?\)|&&|\|\||[()!]|[^()!&|]+/g).map((t) => t.trim()).filter(Boolean);
  let at = 0;
  const either = () => {
    let value = both();
    while (tokens[at] === "||") { at++; const next = both(); value = value === true || next === true ? true : value === false && next === false ? false : null; }
    return value;
  };
  const both = () => {
    let value = one();
    while (tokens[at] === "&&") { at++; const next = one(); value = value === false || next === false ? false : value === true && next === true ? true : null; }
    return value;
  };
  const one = () => {
    const token = tokens[at++];
    if (token === "!") { const value = one(); return value === null ? null : !value; }
    if (token === "(") { const value = either(); at++; return value; }
    const defined = token.match(/^defined ?\( ?(\w+) ?\)$/)?.[1];
    if (defined) return isOff(defined) ? false : null;
    const above = token.match(/^(\w+) ?> ?0$/)?.[1];
    return above && isOff(above) ? false : null;
  };
  return either();
}

/** The text as the preprocessor leaves it, as far as it can be told beforehand. */
export function preprocessed(text, isOff) {
  const out = [];
  const open = []; // { keeps: is this branch kept, taken: a branch before was, shown: its #if is written }
  const isKept = () => open.every((each) => each.keeps);
  for (const line of text.split("\n")) {
    const [, word, rest = ""] = line.match(/^#\s*(if|ifdef|ifndef|elif|else|endif)\b\s*(.*)$/) ?? [];
    if (!word) {
      if (isKept()) out.push(line);
    } else if (word.startsWith("if")) {
      const holds = word === "if" ? truth(rest, isOff) : isOff(rest.trim()) ? word === "ifndef" : null;
      if (isKept() && holds === null) out.push(line);
      open.push({ keeps: holds !== false, shown: holds === null, done: holds === true });
    } else if (word === "endif") {
      const { shown } = open.pop();
      if (isKept() && shown) out.push("#endif");
    } else {
      const top = open.at(-1);
      const holds = word === "else" ? true : truth(rest, isOff);
      top.keeps = true;
      const outer = isKept();
      if (top.done) top.keeps = false;
      else if (holds === false) top.keeps = false;
      else if (top.shown) {
        if (outer) out.push(word === "else" || holds === true ? "#else" : line);
        top.done = holds === true;
      } else if (holds === true) top.done = true;
      else {
        if (outer) out.push(`#if ${rest}`);
        top.shown = true;
      }
    }
  }
  return out.join("\n");
}

const WORD = /[A-Za-z_]\w*/g;
const FUNCTION = /(?:^|[;}\n])((?:(?:highp|mediump|lowp) )?(?:void|bool|int|float|vec[234]|mat[234]|[A-Z]\w+) (\w+)\([^()]*\)\{)/g;

/** Functions whose name occurs only where they are declared. */
function withoutUncalled(text, counts) {
  const cuts = [];
  for (const match of text.matchAll(FUNCTION)) {
    if ((counts.get(match[2]) ?? 0) > 1) continue;
    const start = match.index + match[0].length - match[1].length;
    let [at, depth] = [start + match[1].length, 1];
    while (depth && at < text.length) depth += { "{": 1, "}": -1 }[text[at++]] ?? 0;
    const inside = text.slice(start, at);
    const isWhole = inside.split("\n#if").length === inside.split("\n#endif").length;
    if (!depth && isWhole) cuts.push({ start, end: at });
  }
  return changed(text, cuts);
}

function counted(texts) {
  const counts = new Map();
  for (const text of texts) for (const [word] of text.matchAll(WORD)) counts.set(word, (counts.get(word) ?? 0) + 1);
  return counts;
}

/** The script with lean shaders. own: what else may name chunks and macros. isNever: macros known to be 0. */
export function withLeanShaders(source, own, isNever) {
  const tree = treeOf(source);
  const texts = textsOf(tree);
  const code = changed(source, texts.map(({ start, end }) => ({ start, end, text: '""' }))) + own;
  const inCode = counted([code]);
  let now = texts.map(({ text }) => tight(text));
  const defined = () => new Set(now.flatMap((text) => [...text.matchAll(/#\s*define (\w+)/g)].map((match) => match[1])));
  const at = new Map(texts.map(({ name }, k) => [name, k]));
  const chunkOf = new Map(chunksIn(tree)?.properties.map((each) => [nameOf(each), at.get(each.value.name)]));
  const isEmpty = (chunk) => chunkOf.has(chunk) && !now[chunkOf.get(chunk)];
  for (let before = ""; before !== now.join(); ) {
    before = now.join();
    const there = defined();
    const isOff = (macro) => isNever(macro) || !(inCode.has(macro) || there.has(macro) || /^(GL_|__)/.test(macro));
    now = now.map((text) => preprocessed(text, isOff));
    const counts = counted([...now, code]);
    now = now.map((text) => withoutUncalled(text, counts).replace(/^#include <(\w+)>\n?/gm, (line, chunk) => (isEmpty(chunk) ? "" : line)));
  }
  const lean = changed(source, texts.map(({ start, end }, k) => ({ start, end, text: JSON.stringify(now[k]) })));
  return withoutUnusedChunks(lean, own);
}

/** The table of chunks by name. */
function chunksIn(tree) {
  let table = null;
  walk(tree, (node) => {
    if (node.type === "VariableDeclarator" && node.id.name === "ShaderChunk") table = node.init;
  });
  return table;
}

/** ShaderChunk with those that something includes or names. */
function withoutUnusedChunks(source, own) {
  const tree = treeOf(source);
  const texts = new Map(textsOf(tree).map(({ name, text }) => [name, text]));
  const table = chunksIn(tree);
  const used = new Set();
  walk(tree, (node) => {
    if (node.type === "MemberExpression" && !node.computed && node.object.name === "ShaderChunk") used.add(nameOf(node));
  });
  if (!table) return source;
  const textOf = new Map(table.properties.map((each) => [nameOf(each), texts.get(each.value.name) ?? ""]));
  const includesOf = (text) => [...text.matchAll(/#include <(\w+)>/g)].map((match) => match[1]);
  const inTable = new Set(table.properties.map((each) => each.value.name));
  const loose = [...texts].filter(([name]) => !inTable.has(name)).map(([, text]) => text); // shaders outside of the table
  const todo = [...used, ...[own, ...loose].flatMap(includesOf)];
  const kept = new Set();
  for (let name; (name = todo.pop()); ) {
    if (kept.has(name)) continue;
    kept.add(name);
    todo.push(...includesOf(textOf.get(name) ?? ""));
  }
  const properties = table.properties.filter((each) => kept.has(nameOf(each))).map((each) => source.slice(each.start, each.end));
  return changed(source, [{ start: table.start, end: table.end, text: `{ ${properties.join(", ")} }` }]);
}
