/** Messages to the console as their first word: that something is wrong must be seen, where is enough. */
import { changed, treeOf, walk } from "./syntax.mjs";

const HAS_EFFECT = /^(Assignment|Update|Await)Expression$/;

export function withShortMessages(source) {
  const changes = [];
  walk(treeOf(source), ({ type, callee, arguments: given }) => {
    if (type !== "CallExpression" || !/^(warn|warnOnce|error|log)$/.test(callee.name) || !given.length || given.some((each) => HAS_EFFECT.test(each.type))) return;
    const [start, end] = [given[0].start, given.at(-1).end];
    changes.push({ start, end, text: `"${source.slice(start, end).match(/["'`]([\w.]+)/)?.[1] ?? "three"}"` });
  });
  return changed(source, changes);
}
