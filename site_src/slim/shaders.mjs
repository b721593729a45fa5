/**
 * three's shader texts without comments, without what hangs on a macro that nothing defines, and only those that
 * are used. By names, as members.mjs does.
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

const TERM = /(! ?)?(?:defined ?\( ?(\w+) ?\)|(\w+) > 0|\w[^()!&|]*)/g;

/** One condition of the preprocessor, with what is not known beforehand as true and as false: null where they differ. */
function truth(condition, isOff) {
  const value = (unknown) => Function(`return ${condition.replace(TERM, (_, not, defined, positive) => (isOff(defined ?? positive ?? "") ? !!not : unknown))}`)();
  return value(true) ? value(false) || null : false;
}

/** The text as the preprocessor leaves it, as far as that is known beforehand. */
export function preprocessed(text, isOff) {
  const out = [];
  const open = []; // { keeps: is this branch kept, isDone: one that is surely taken came, isShown: its #if is written }
  const isKept = () => open.every((each) => each.keeps);
  for (const line of text.split("\n")) {
    const [, word, macro = "", rest = ""] = line.match(/^# ?(if|elif|else|endif)(n?def)?\b ?(.*)$/) ?? [];
    if (word === "if") open.push({ keeps: true, isDone: false, isShown: false });
    const top = open.at(-1);
    if (!word) {
      if (isKept()) out.push(line);
    } else if (word === "endif") {
      open.pop();
      if (isKept() && top.isShown) out.push("#endif");
    } else {
      const holds = !top.isDone && (word === "else" || truth(macro ? `${macro === "ndef" ? "!" : ""}defined(${rest})` : rest, isOff));
      top.keeps = holds !== false;
      top.isDone ||= holds === true;
      if (!isKept()) continue;
      if (holds === null) out.push(top.isShown || word === "if" ? line : `#if ${rest}`);
      else if (top.isShown) out.push("#else");
      top.isShown ||= holds === null;
    }
  }
  return out.join("\n");
}

const includesIn = (text) => [...text.matchAll(/#include <(\w+)>/g)].map((match) => match[1]);

/** The script with lean shaders. own: what else may name chunks and macros. isNever: macros known to be 0. */
export function withLeanShaders(source, own, isNever) {
  const tree = treeOf(source);
  const texts = textsOf(tree);
  const code = changed(source, texts.map(({ start, end }) => ({ start, end, text: '""' }))) + own;
  const named = new Set(code.match(/[A-Za-z_]\w*/g));
  const table = chunksIn(tree);
  const placeOf = new Map(table?.properties.map((each) => [nameOf(each), texts.findIndex(({ name }) => name === each.value.name)]));
  let now = texts.map(({ text }) => tight(text));
  for (let before = ""; before !== now.join(); ) {
    before = now.join();
    const defined = new Set(before.match(/(?<=#define )\w+/g));
    const isOff = (macro) => macro !== "" && (isNever(macro) || !(named.has(macro) || defined.has(macro) || /^(GL_|__)/.test(macro)));
    const isEmpty = (chunk) => now[placeOf.get(chunk)] === "";
    now = now.map((text) => preprocessed(text, isOff).replace(/^#include <(\w+)>\n?/gm, (line, chunk) => (isEmpty(chunk) ? "" : line)));
  }
  const changes = texts.map(({ start, end }, k) => ({ start, end, text: JSON.stringify(now[k]) }));
  if (table) changes.push(withUsedChunks(table, source, code, now, placeOf));
  return changed(source, changes);
}

/** The table of chunks by name. */
function chunksIn(tree) {
  let table = null;
  walk(tree, (node) => {
    if (node.type === "VariableDeclarator" && node.id.name === "ShaderChunk") table = node.init;
  });
  return table;
}

/** The table with those that something includes or names. */
function withUsedChunks({ start, end, properties }, source, code, texts, placeOf) {
  const inTable = new Set(placeOf.values());
  const shaders = texts.filter((_, place) => !inTable.has(place));
  const used = new Set([...[...code.matchAll(/ShaderChunk\.(\w+)/g)].map((match) => match[1]), ...[code, ...shaders].flatMap(includesIn)]);
  for (const chunk of used) for (const each of includesIn(texts[placeOf.get(chunk)] ?? "")) used.add(each);
  const kept = properties.filter((each) => used.has(nameOf(each))).map((each) => source.slice(each.start, each.end));
  return { start, end, text: `{ ${kept.join(", ")} }` };
}
