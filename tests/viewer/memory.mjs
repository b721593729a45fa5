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

/** A function that measures: { heap (bytes), nodes, listeners, documents, gpu: { Buffer, Texture, ... } }. */
export async function memoryOf(page) {
  const inside = await page.context().newCDPSession(page);
  await inside.send("HeapProfiler.enable");
  return async () => {
    for (let k = 0; k < 2; k++) await inside.send("HeapProfiler.collectGarbage"); // the first frees what waits for its finalizer
    const { usedSize: heap } = await inside.send("Runtime.getHeapUsage");
    const { nodes, jsEventListeners: listeners, documents } = await inside.send("Memory.getDOMCounters");
    return { heap, nodes, listeners, documents, gpu: await page.evaluate(() => ({ ...window.gpuHeld })) };
  };
}
