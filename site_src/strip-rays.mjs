/**
 * Takes three's ray code out of what we ship. Writing intersection code is the
 * students' homework, and three carries a full set of it in every Mesh; the viewer
 * never calls it, but bundlers cannot drop methods of a class that is used.
 */
import { parse } from "acorn";

/** `intersectsObject`, `intersectsBox`, ...: yes/no questions the renderer asks before it
 *  draws. "Yes" is always safe: at worst something out of sight is drawn. */
const ASKS = /^intersects/;
const GONE = /^(raycast|intersect|_computeIntersections$)/;

function* nodes(node) {
  if (Array.isArray(node)) for (const child of node) yield* nodes(child);
  else if (node && typeof node.type === "string") {
    yield node;
    for (const key of Object.keys(node)) if (typeof node[key] === "object") yield* nodes(node[key]);
  }
}

const nameOf = (method) => method.key.name ?? method.key.value;
const isReturnTrue = (body) => /^\{\s*return\s*(true|!0);?\s*\}$/.test(body);

/** Methods that hold ray code: { name, start, end, body: [start, end], inRay }. */
function rayMethods(source) {
  const found = [];
  for (const node of nodes(parse(source, { ecmaVersion: "latest", sourceType: "module" }))) {
    const members = node.type === "ClassBody" ? node.body : node.type === "ObjectExpression" ? node.properties : null;
    if (!members) continue;
    const names = members.map((member) => (member.key ? nameOf(member) : ""));
    // Recognised by its methods: minifying renames the class but not these.
    const inRay = names.includes("recast") || names.includes("distanceSqToSegment");
    members.forEach((member, at) => {
      const value = member.value;
      if (!value || value.type !== "FunctionExpression" || names[at] === "constructor") return;
      const name = names[at];
      if (GONE.test(name) || (inRay && name !== "set" && name !== "copy"))
        found.push({ name, start: member.start, end: member.end, body: [value.body.start, value.body.end] });
    });
  }
  return found;
}

/** three's source without its ray methods; those the renderer asks answer "yes". */
export function withoutRays(source) {
  const cuts = rayMethods(source).sort((a, b) => b.start - a.start);
  let kept = source;
  for (const { name, start, end, body } of cuts)
    kept = ASKS.test(name)
      ? kept.slice(0, body[0]) + "{ return true; }" + kept.slice(body[1])
      : kept.slice(0, start) + kept.slice(end);
  return kept;
}

/** Names of ray methods a bundle still holds; empty when it is clean. */
export function raysLeftIn(bundle) {
  return rayMethods(bundle)
    .filter(({ name, body }) => !(ASKS.test(name) && isReturnTrue(bundle.slice(...body))))
    .map(({ name }) => name);
}
