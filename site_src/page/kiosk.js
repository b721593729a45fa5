/* Kiosk: with #kiosk=1 in the address the page belongs to kiosk.ts, which is loaded only then. What goes wrong before
   it is here is kept for it. `part` is what every address of a kiosk carries. */
(() => {
  const KEYS = ["kiosk", "idle", "warn", "attract-pace", "home", "visitor", "strikes"]; // as state/kiosk-fields.ts has them
  const own = document.currentScript;
  const fieldsOf = () => new URLSearchParams(location.hash.slice(1));
  const isKiosk = () => fieldsOf().get("kiosk") === "1";
  if (!isKiosk()) {
    window.addEventListener("hashchange", () => isKiosk() && location.reload());
    return;
  }
  const page = document.documentElement;
  const fields = fieldsOf();
  if (!fields.has("home")) fields.set("home", page.lang); // the language that a reset goes back to
  const part = [...fields].filter(([key]) => KEYS.includes(key)).map(([key, value]) => `${key}=${encodeURIComponent(value)}`);
  const hook = {
    part: part.join("&"),
    start: own.dataset.start && `scenes/${own.dataset.start}/index.html`,
    root: own.dataset.root,
    faults: [],
    viewer: null,
    arrived: () => {},
    attach(viewer) {
      hook.viewer = viewer;
      hook.arrived(viewer);
    },
    status: () => null,
  };
  window.raywalkKiosk = hook;
  window.addEventListener("error", (event) => event.error && hook.faults.push(String(event.message)));
  window.addEventListener("unhandledrejection", (event) => hook.faults.push(String(event.reason)));
  page.classList.add("kiosk");
  for (const source of [own.dataset.words, own.dataset.kiosk]) {
    const script = document.createElement("script");
    script.async = false; // in this order
    script.src = own.dataset.root + source;
    document.head.append(script);
  }
})();
