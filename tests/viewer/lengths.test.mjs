/** How long the viewer's functions are. Asked of the compiler that checks the types: esbuild and acorn would tell lines of
 *  another text, without types and comments. Its programming interface is called unstable; package.json pins the version. */
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { API } from "typescript/unstable/sync";
import { SyntaxKind } from "typescript/unstable/ast";
import { VIEWER } from "./typescript.mjs";

const FUNCTIONS = new Set(["FunctionDeclaration", "FunctionExpression", "ArrowFunction", "MethodDeclaration", "Constructor", "GetAccessor", "SetAccessor"].map((kind) => SyntaxKind[kind]));
const NINE_IN_TEN = 30; // lines
const LONGEST = 80;

const compiler = new API();
after(() => compiler.close());
const { program } = compiler.updateSnapshot({ openProject: `${VIEWER}tsconfig.json` }).getProjects()[0];

/** Functions that are in no other: who reads one reads what is inside of it. */
function outermost(file) {
  const source = program.getSourceFile(file);
  const lines = (from, to) => source.text.slice(from, to).split("\n").length;
  const found = [];
  const look = (node) => {
    if (!FUNCTIONS.has(node.kind)) return void node.forEachChild(look);
    const name = node.name?.text ?? node.parent.name?.text ?? "a function";
    found.push({ name: `${file.slice(VIEWER.length)} ${name}`, length: lines(node.getStart(source), node.end) });
  };
  look(source);
  return found;
}
const functions = program.getSourceFileNames().filter((file) => file.startsWith(VIEWER)).flatMap(outermost).sort((a, b) => b.length - a.length);
const listed = (some) => some.map(({ name, length }) => `${length} lines: ${name}`).join("\n");

test("all of the viewer is measured", () => {
  assert.ok(functions.length > 400, `only ${functions.length} functions were found`);
  assert.ok(functions.some(({ name, length }) => name === "stage/stage.ts createStage" && length > 10));
});

test(`no function of the viewer is longer than ${LONGEST} lines`, () => {
  const long = functions.filter(({ length }) => length > LONGEST);
  assert.equal(long.length, 0, listed(long));
});

test(`nine in ten have at most ${NINE_IN_TEN} lines`, () => {
  const tenth = Math.floor(functions.length / 10);
  assert.ok(functions[tenth].length <= NINE_IN_TEN, `${functions.filter(({ length }) => length > NINE_IN_TEN).length} of ${functions.length} have more:\n${listed(functions.slice(0, tenth + 1))}`);
});
