/* Before all else: what does not arrive is reported. */
(() => {
  // A script of the page's own is missing or damaged: the page stays as it was written.
  addEventListener(
    "error",
    (event) => {
      const from = event.target.src ?? event.filename ?? "";
      const notice = document.getElementById("broken");
      if (notice && from.includes("/assets/") && !document.body.classList.contains("live")) notice.hidden = false;
    },
    true,
  );
})();
