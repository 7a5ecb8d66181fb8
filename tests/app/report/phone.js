// The page in a frame as wide as a phone.
var inner = document.getElementById("phone").contentDocument;
inner.getElementById("open-all").click();
var wide = [];
inner.querySelectorAll("body *").forEach(function (e) {
  if (e.closest("svg, math, .wide, .drawing, pre")) return;
  if (e.getBoundingClientRect().right > 390.5) wide.push(e.tagName + "." + e.className);
});
result = JSON.stringify({ width: inner.documentElement.scrollWidth, wide: wide,
                          open: inner.querySelectorAll("details[open]").length });
