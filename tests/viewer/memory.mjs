/** What a page holds: JS heap after a collection, DOM nodes and listeners, and what the graphics card keeps for it. */

/** Before the page's scripts: counts what is made and deleted, whoever does it. */
export function countGpu() {
  const { prototype } = WebGL2RenderingContext;
  const held = (window.gpuHeld = {});
  for (const kind of ["Buffer", "Texture", "Framebuffer", "Renderbuffer", "Program", "Shader", "VertexArray"]) {
    held[kind] = 0;
    const [make, drop] = [prototype[`create${kind}`], prototype[`delete${kind}`]];
    prototype[`create${kind}`] = function (...args) {
      held[kind]++;
      return make.apply(this, args);
    };
    prototype[`delete${kind}`] = function (which) {
      if (which) held[kind]--;
      return drop.call(this, which);
    };
  }
}

/** measure: { heap (bytes), buffers (bytes of typed arrays, which are beside it), nodes, listeners, documents }; snapshot: all that is on the heap, as text for objectsIn. */
export async function memoryOf(page) {
  const inside = await page.context().newCDPSession(page);
  await inside.send("HeapProfiler.enable");
  return {
    async measure() {
      for (let k = 0; k < 2; k++) await inside.send("HeapProfiler.collectGarbage"); // the first frees what waits for its finalizer
      const { usedSize: heap, backingStorageSize: buffers } = await inside.send("Runtime.getHeapUsage");
      const { nodes, jsEventListeners: listeners, documents } = await inside.send("Memory.getDOMCounters");
      return { heap, buffers, nodes, listeners, documents };
    },
    async snapshot() {
      const chunks = [];
      const keep = ({ chunk }) => chunks.push(chunk);
      inside.on("HeapProfiler.addHeapSnapshotChunk", keep);
      await inside.send("HeapProfiler.takeHeapSnapshot", { reportProgress: false });
      inside.off("HeapProfiler.addHeapSnapshotChunk", keep);
      return chunks.join("");
    },
  };
}

// The engine's compiled code grows as it learns what runs often, until all has been compiled; native is not on the JS heap.
const NO_OBJECTS = new Set(["code", "native", "synthetic", "hidden"]);

/** Of a snapshot: bytes of the page's own objects (closures, arrays, numbers too), of strings and of code, and what each
 *  constructor's objects take. */
export function objectsIn(snapshot) {
  const { snapshot: { meta }, nodes, strings } = JSON.parse(snapshot);
  const types = meta.node_types[0];
  const [type, name, size] = ["type", "name", "self_size"].map((field) => meta.node_fields.indexOf(field));
  const found = { objects: 0, strings: 0, code: 0, of: new Map() };
  for (let at = 0; at < nodes.length; at += meta.node_fields.length) {
    const kind = types[nodes[at + type]];
    if (kind === "code") found.code += nodes[at + size];
    if (NO_OBJECTS.has(kind)) continue;
    const isText = kind.endsWith("string");
    found[isText ? "strings" : "objects"] += nodes[at + size];
    if (isText) continue;
    const what = kind === "number" ? kind : `${kind} ${strings[nodes[at + name]]}`;
    found.of.set(what, (found.of.get(what) ?? 0) + nodes[at + size]);
  }
  return found;
}

/** What has grown most between two such, to be shown where a bound breaks. */
export function grown(before, after, count = 6) {
  const by = [...after.of].map(([what, bytes]) => [bytes - (before.of.get(what) ?? 0), what]).sort(([a], [b]) => b - a);
  return by.slice(0, count).map(([bytes, what]) => `${what} ${bytes}`).join(", ");
}
