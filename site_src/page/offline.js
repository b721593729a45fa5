/* On a host: the site can be installed, and what was looked at once is there without a network. From a disk it is anyway. */
(() => {
  const { root, worker, manifest } = document.currentScript.dataset;
  if (!worker || !/^https?:$/.test(location.protocol) || !navigator.serviceWorker || window.top !== window) return;
  const MEGABYTE = 1e6;
  const AT_ONCE = 12; // files, between two looks at how far it is

  const link = document.createElement("link");
  link.rel = "manifest";
  link.href = root + manifest;
  document.head.append(link);

  /** Asks the worker, which answers once. */
  const ask = (to, what) =>
    new Promise((done) => {
      const { port1, port2 } = new MessageChannel();
      port1.onmessage = ({ data }) => done(data);
      to.postMessage(what, [port2]);
    });

  /** What this page loaded before the worker was there is kept too. */
  function usedFiles() {
    const home = new URL(root || "./", location.href).href.replace(/[?#].*$/, "").replace(/[^/]*$/, "");
    const used = [location.href, ...performance.getEntriesByType("resource").map(({ name }) => name)];
    const paths = used.map((each) => each.replace(/[?#].*$/, "")).filter((each) => each.startsWith(home)).map((each) => decodeURIComponent(each.slice(home.length)));
    return [...new Set(paths.map((path) => (path === "" || path.endsWith("/") ? `${path}index.html` : path)))];
  }

  /** The gallery's button that keeps all of it. */
  async function offer(panel, active) {
    const [button, status] = [panel.querySelector("button"), panel.querySelector("output")];
    const size = (bytes) => panel.dataset.size.replace("{size}", (bytes / MEGABYTE).toFixed(1).replace(".", panel.dataset.decimal));
    const { bytes, missing } = await ask(active, { does: "list" });
    panel.hidden = false;
    const finish = () => {
      button.hidden = true;
      status.textContent = panel.dataset.kept.replace("{size}", size(bytes));
    };
    if (!missing.length) return finish();
    button.textContent = panel.dataset.keep.replace("{size}", size(bytes));
    button.onclick = async () => {
      button.disabled = true;
      const { missing } = await ask(active, { does: "list" });
      const left = missing.map(([path]) => path);
      let rest = missing.reduce((sum, [, each]) => sum + each, 0);
      while (left.length) {
        status.textContent = panel.dataset.keeping.replace("{done}", size(bytes - rest)).replace("{size}", size(bytes));
        const some = left.splice(0, AT_ONCE);
        if (!(await ask(active, { does: "keep", paths: some }))) {
          button.disabled = false;
          status.textContent = panel.dataset.failed;
          return;
        }
        rest -= missing.filter(([path]) => some.includes(path)).reduce((sum, [, each]) => sum + each, 0);
      }
      void navigator.storage?.persist?.();
      finish();
    };
  }

  /** A newer build waits until nobody looks at the old one; who wants it now may have it. */
  function offerUpdate(registration) {
    const panel = document.getElementById("newer");
    const show = () => {
      if (!registration.waiting || !navigator.serviceWorker.controller || !panel) return;
      panel.hidden = false;
      panel.querySelector("button").onclick = () => {
        navigator.serviceWorker.addEventListener("controllerchange", () => location.reload());
        registration.waiting.postMessage({ does: "take over" });
      };
    };
    registration.addEventListener("updatefound", () => registration.installing?.addEventListener("statechange", show));
    show();
  }

  async function start() {
    const registration = await navigator.serviceWorker.register(root + worker);
    offerUpdate(registration);
    const { active } = await navigator.serviceWorker.ready;
    await ask(active, { does: "keep", paths: usedFiles() });
    const panel = document.getElementById("offline");
    if (panel) await offer(panel, active);
  }
  window.addEventListener("load", () => void start().catch(() => {})); // refused: then the site needs its network
})();
