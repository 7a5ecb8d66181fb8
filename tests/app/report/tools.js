// Functions that all scripts for the page use.
var all = Array.prototype.slice.call(document.querySelectorAll("#claims .claim"));
function now() { return Array.prototype.slice.call(document.querySelectorAll("#claims .claim")); }
function visible() { return now().filter(function (c) { return c.offsetParent !== null; }); }
function ids(list) { return list.map(function (c) { return c.id; }); }
function opened() { return ids(now().filter(function (c) { return c.open; })); }
function type(text) {
  var filter = document.getElementById("filter");
  filter.value = text;
  filter.dispatchEvent(new Event("input"));
}
function box(verdict) { document.querySelector("input[name=verdict][value=" + verdict + "]").click(); }
function order(key) { document.querySelector("[data-sort=" + key + "]").click(); }
function click(id) { document.getElementById(id).click(); }
