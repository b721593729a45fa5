/** Where lines of the world are on the screen. A projection makes straight lines of straight ones. */

const AT_LEAST = 1e-3; // depth: what is nearer than that is taken for behind the observer

const between = (from, to, share) => from.map((v, k) => v + share * (to[k] - v));

/** Is any of the line from one point to another seen within the box? project: a point's { x, y, depth }. */
export function seenWithin({ from, to }, { left, top, right, bottom }, project) {
  let [a, b] = [project(from), project(to)];
  if (a.depth < AT_LEAST && b.depth < AT_LEAST) return false;
  // The part before the observer: depth grows evenly along a line.
  const at = between(from, to, (AT_LEAST - a.depth) / (b.depth - a.depth));
  if (a.depth < AT_LEAST) a = project(at);
  if (b.depth < AT_LEAST) b = project(at);
  let [first, last] = [0, 1];
  for (const [start, run, low, high] of [[a.x, b.x - a.x, left, right], [a.y, b.y - a.y, top, bottom]]) {
    if (run === 0 && (start <= low || start >= high)) return false;
    if (run === 0) continue;
    const [enters, leaves] = [(low - start) / run, (high - start) / run].sort((one, other) => one - other);
    [first, last] = [Math.max(first, enters), Math.min(last, leaves)];
  }
  return first < last;
}
