/* Raywalk without a network. The build puts BUILD before this: its version, all its files as path -> [hash, bytes], which
   of them come first, and where each language's pages are. A file is kept only if it is the one that this build wrote. */
const HOME = self.registration.scope;
const OURS = `raywalk ${HOME} `; // other sites of the same host have caches of their own
const NAME = OURS + BUILD.version;
const OTHERS = `${NAME} others`; // pages of another build than this, by client
const MARK = "x-raywalk-hash";
const AT_ONCE = 6; // requests

const addressOf = (path) => new URL(path, HOME).href;

/** The path of a file of this build; null for everything else. */
function pathOf(address) {
  const { href } = new URL(address);
  if (!href.startsWith(HOME)) return null;
  const path = decodeURIComponent(href.slice(HOME.length).replace(/[?#].*$/, ""));
  const file = path === "" || path.endsWith("/") ? `${path}index.html` : path;
  return Object.hasOwn(BUILD.files, file) ? file : null;
}

async function hashOf(bytes) {
  const hash = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
  return [...hash].map((byte) => byte.toString(16).padStart(2, "0")).join("").slice(0, BUILD.files["index.html"][0].length);
}

/** From the network, with its hash noted; `other` is what the host has instead by now. */
async function fetched(path) {
  const answer = await fetch(addressOf(path), { cache: "no-cache" });
  if (!answer.ok) throw new Error(`${path}: ${answer.status}`);
  const bytes = await answer.arrayBuffer();
  const headers = { "content-type": answer.headers.get("content-type") ?? "" };
  if ((await hashOf(bytes)) !== BUILD.files[path][0]) return { other: new Response(bytes, { headers }) };
  return { own: new Response(bytes, { headers: { ...headers, [MARK]: BUILD.files[path][0] } }) };
}

/** Pages and their data never mix. A page of a newer build has everything from the host; one of an older build, which was
 *  open when this worker took over, has nothing any longer: it says so, and is right when it is loaded anew. */
const note = async (client, build) => (await caches.open(OTHERS)).put(addressOf(`@${client}`), new Response(build));
const buildOf = async (client) => (client ? (await (await caches.open(OTHERS)).match(addressOf(`@${client}`)))?.text() : undefined);

/** The host has another build by now, whose worker is asked for; from now on pages come from there while it can be reached. */
async function fromAnother(event, other) {
  await note("host", "newer");
  event.waitUntil(self.registration.update().catch(() => {}));
  return event.request.mode === "navigate" ? asNewer(event, other) : Response.error();
}

async function asNewer(event, page) {
  await note(event.resultingClientId, "newer");
  return page;
}

/** What older builds kept and this one has unchanged need not be fetched again. */
async function takeOver(cache) {
  for (const name of await caches.keys()) {
    if (!name.startsWith(OURS) || name === NAME) continue;
    const old = await caches.open(name);
    for (const request of await old.keys()) {
      const path = pathOf(request.url);
      const kept = path && (await old.match(request));
      if (kept && kept.headers.get(MARK) === BUILD.files[path][0]) await cache.put(addressOf(path), kept);
    }
  }
}

const isData = (path) => path.endsWith("/scene.js");

/** The pages of the scene that a file is of: the viewer shows a scene without loading its page, but puts its address there. */
function pagesOf(path) {
  const [, folder] = /^(?:\w+\/)?(scenes\/[^/]+\/)/.exec(path) ?? [];
  return folder ? BUILD.homes.map((home) => `${home}${folder}index.html`) : [];
}

/** Keeps files, a few at a time; those that are kept already cost nothing. */
async function keep(paths) {
  const cache = await caches.open(NAME);
  const left = paths.filter((path) => Object.hasOwn(BUILD.files, path));
  const one = async () => {
    for (let path = left.shift(); path; path = left.shift()) {
      if (await cache.match(addressOf(path))) continue;
      const { own } = await fetched(path);
      if (!own) throw new Error(`${path}: not this build's`);
      await cache.put(addressOf(path), own);
    }
  };
  await Promise.all(Array.from({ length: AT_ONCE }, one));
}

/** All that pages need, and what of it is not here yet. */
async function list() {
  const kept = new Set((await (await caches.open(NAME)).keys()).map(({ url }) => pathOf(url)));
  const all = Object.entries(BUILD.files).filter(([path]) => !/^(\w+\/)?slides\//.test(path));
  const sizes = ([, [, bytes]]) => bytes;
  return { bytes: all.reduce((sum, each) => sum + sizes(each), 0), missing: all.filter(([path]) => !kept.has(path)).map((each) => [each[0], sizes(each)]) };
}

async function answer(event, path) {
  if (event.request.mode === "navigate") {
    const page = (await buildOf("host")) && (await fetch(event.request).catch(() => null));
    if (page?.ok) return asNewer(event, page);
  } else {
    const other = await buildOf(event.clientId);
    if (other) return other === "newer" ? fetch(event.request) : Response.error();
  }
  const cache = await caches.open(NAME);
  const kept = await cache.match(addressOf(path));
  if (kept) return kept;
  try {
    const { own, other } = await fetched(path);
    if (!own) return fromAnother(event, other);
    const ours = cache.put(addressOf(path), own.clone()).then(() => (isData(path) ? keep(pagesOf(path)) : null));
    event.waitUntil(ours.catch(() => {})); // no room: then it is not kept
    return own;
  } catch {
    return elsewhere(event, path);
  }
}

/** From the network as it is; a page that cannot be had is replaced by one that says so. */
async function elsewhere(event, path) {
  try {
    return await fetch(event.request);
  } catch (error) {
    if (event.request.mode !== "navigate") throw error;
    const home = BUILD.homes.find((each) => each && path.startsWith(each)) ?? "";
    return Response.redirect(addressOf(`${home}offline/index.html`));
  }
}

self.addEventListener("install", (event) => {
  const come = async () => {
    await takeOver(await caches.open(NAME));
    await keep(BUILD.first);
  };
  event.waitUntil(come());
});

self.addEventListener("activate", (event) => {
  const go = async () => {
    const older = (await caches.keys()).filter((name) => name.startsWith(OURS) && name !== NAME && name !== OTHERS);
    if (older.length) for (const { id } of await self.clients.matchAll({ includeUncontrolled: true })) await note(id, "older");
    for (const name of older) await caches.delete(name);
    await self.clients.claim();
  };
  event.waitUntil(go());
});

self.addEventListener("fetch", (event) => {
  const { request } = event;
  if (request.method !== "GET" || !request.url.startsWith(HOME)) return;
  const path = pathOf(request.url);
  if (path) event.respondWith(answer(event, path));
  else if (request.mode === "navigate") event.respondWith(elsewhere(event, request.url.slice(HOME.length)));
});

self.addEventListener("message", (event) => {
  const { does, paths = [] } = event.data;
  const reply = (said) => event.ports[0]?.postMessage(said);
  if (does === "take over") void self.skipWaiting();
  if (does === "list") event.waitUntil(list().then(reply));
  if (does === "keep") event.waitUntil(keep([...paths, ...paths.filter(isData).flatMap(pagesOf)]).then(() => reply(true), () => reply(false)));
});
