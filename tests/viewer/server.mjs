/** A static server as small as a test needs: one folder, under any path. */
import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { extname, join, normalize } from "node:path";

const TYPES = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".png": "image/png", ".webp": "image/webp", ".json": "application/json", ".gz": "application/gzip" };

/** Serves `folder` below `prefix` ("/" or "/course/rays/"). instead: what some of its files hold here, by their path. */
export async function serve(folder, prefix = "/", instead = {}) {
  const server = createServer(async (request, response) => {
    const path = decodeURIComponent(new URL(request.url, "http://here").pathname);
    if (!path.startsWith(prefix)) return response.writeHead(404).end();
    const inside = normalize(path.slice(prefix.length)) || "index.html";
    try {
      const body = instead[inside] ?? await readFile(join(folder, inside.endsWith("/") ? `${inside}index.html` : inside === "." ? "index.html" : inside));
      response.writeHead(200, { "content-type": TYPES[extname(inside)] ?? "text/html" }).end(body);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((listening) => server.listen(0, "127.0.0.1", listening));
  return { url: `http://127.0.0.1:${server.address().port}${prefix}`, close: () => server.close() };
}
