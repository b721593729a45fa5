/* In the place of sw.js while scenes are being written: pages must be the newest, so a worker that an earlier visit left goes. */
self.addEventListener("install", () => void self.skipWaiting());
self.addEventListener("activate", (event) => {
  const go = async () => {
    for (const name of await caches.keys()) if (name.startsWith(`raywalk ${self.registration.scope} `)) await caches.delete(name);
    await self.registration.unregister();
    for (const page of await self.clients.matchAll()) void page.navigate(page.url);
  };
  event.waitUntil(go());
});
