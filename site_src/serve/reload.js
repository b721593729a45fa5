/**
 * Only in pages that `raywalk serve` hands out, never in a built site: shows the newest build,
 * and the scenes' mistakes until they are mended. The address keeps what is being looked at.
 */
(() => {
  const own = document.currentScript;
  const version = Number(own.dataset.version);
  const panel = document.body.appendChild(document.createElement("section"));
  panel.id = "raywalk-serve";
  panel.setAttribute("role", "status");
  const title = panel.appendChild(document.createElement("h2"));
  const text = panel.appendChild(document.createElement("pre"));
  let events = null;

  function show(now) {
    if (now.version > version && !now.trouble) return location.reload(); // while busy, too: a first sight
    panel.className = now.trouble ? "trouble" : now.busy ? "busy" : "";
    title.textContent = now.title;
    text.textContent = now.trouble;
  }

  // A hidden page lets go of the line: browsers hold only six of them to one server.
  function listen() {
    events?.close();
    events = document.hidden ? null : new EventSource("/@raywalk/events");
    if (events) events.onmessage = (message) => show(JSON.parse(message.data));
  }
  document.addEventListener("visibilitychange", listen);
  listen();
})();
