/* Languages: a link to another one takes the view along and is remembered; the site's first page opens in
   the language chosen last. Storage may be refused: then the address alone decides. */
(() => {
  const KEY = "raywalk.language";
  const SCENE = /scenes\/[^/]+\//;
  const page = document.documentElement;
  const attempt = (act) => {
    try {
      return act();
    } catch {
      return null;
    }
  };
  const chosen = attempt(() => localStorage.getItem(KEY));
  const other = [...document.querySelectorAll("link[rel=alternate]")].find((link) => link.hreflang === chosen);
  if ("first" in page.dataset && other && chosen !== page.lang) location.replace(other.href + location.hash);

  document.addEventListener("click", (event) => {
    const link = event.target instanceof Element && event.target.closest("a.language");
    if (!link) return;
    attempt(() => localStorage.setItem(KEY, link.hreflang));
    const here = SCENE.exec(location.pathname); // the viewer may show another scene than the page came with
    if (here) link.pathname = link.pathname.replace(SCENE, here[0]);
    link.search = location.search;
    link.hash = location.hash;
  });
})();
