/**
 * Takes three's ray code out of what we ship. Writing intersection code is the
 * students' homework, and three carries a full set of it in every Mesh; the viewer
 * never calls it, but bundlers cannot drop methods of a class that is used.
 */
import { changed, nameOf, treeOf, walk } from "./slim/syntax.mjs";

/** `intersectsObject`, `intersectsBox`, ...: yes/no questions the renderer asks before it
 *  draws. "Yes" is always safe: at worst something out of sight is drawn. */
const ASKS = /^intersects/;
const GONE = /^(raycast|intersect|_computeIntersections$)/;

const isReturnTrue = (body) => /^\{\s*return\s*(true|!0);?\s*\}$/.test(body);

/** Methods that hold ray code: { name, start, end, body: [start, end] }. */
function rayMethods(source) {
  const found = [];
  walk(treeOf(source), (node) => {
    const members = node.type === "ClassBody" ? node.body : node.type === "ObjectExpression" ? node.properties : [];
    const named = members.map((member) => [member, member.key ? nameOf(member) : ""]);
    // A ray is recognised by its methods: minifying renames the class but not these.
    const inRay = named.some(([, name]) => name === "recast" || name === "distanceSqToSegment");
    for (const [{ start, end, value }, name] of named)
      if (value?.type === "FunctionExpression" && name !== "constructor" && (GONE.test(name) || (inRay && name !== "set" && name !== "copy")))
        found.push({ name, start, end, body: [value.body.start, value.body.end] });
  });
  return found;
}

/** three's source without its ray methods; those the renderer asks answer "yes". */
export const withoutRays = (source) =>
  changed(source, rayMethods(source).map(({ name, start, end, body }) => (ASKS.test(name) ? { start: body[0], end: body[1], text: "{ return true; }" } : { start, end })));

/** Names of ray methods a bundle still holds; empty when it is clean. */
export function raysLeftIn(bundle) {
  return rayMethods(bundle)
    .filter(({ name, body }) => !(ASKS.test(name) && isReturnTrue(bundle.slice(...body))))
    .map(({ name }) => name);
}
