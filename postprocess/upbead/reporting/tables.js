// A table that is wider than the page scrolls: then the keyboard must reach it.
"use strict";
(() => {
  const seen = new ResizeObserver((changed) => {
    for (const {target} of changed)
      if (target.scrollWidth > target.clientWidth) target.tabIndex = 0; else target.removeAttribute("tabindex");
  });
  for (const table of document.querySelectorAll(".table")) seen.observe(table);
})();
