// Filter, verdicts, order, folds, links, print: ledger.json has the expected results.
var r = {};
r.all = ids(visible());
r.tools = getComputedStyle(document.getElementById("tools")).display !== "none";
r.status = document.getElementById("shown").textContent;
type("FLAT punch"); r.filtered = ids(visible()); r.filteredStatus = document.getElementById("shown").textContent;
type("theorem 16"); r.bySource = ids(visible());
type("gamma f"); r.byFormula = ids(visible());
type("nowhere"); r.none = ids(visible());
type("");
box("supported"); r.withoutSupported = ids(visible());
click("open-all"); r.openedVisible = opened(); click("close-all");
box("supported"); r.again = visible().length;
order("seconds"); r.slowest = ids(now());
order("seconds"); r.fastest = ids(now());
order("id"); r.byId = ids(now());
order("verdict"); r.byVerdict = ids(now());
r.pressed = document.querySelectorAll("[data-sort][aria-pressed=true]").length;
order("place"); r.byOrder = ids(now());
var first = document.getElementById("eq-04-flat-punch");
var height = first.offsetHeight;
first.querySelector("summary").click(); r.opened = opened(); r.tall = first.offsetHeight > height + 100;
first.querySelector("summary").click(); r.closed = opened();
click("open-all"); r.everything = opened().length;
click("close-all"); r.nothing = opened().length;
r.manyFormulas = document.querySelectorAll("math").length > 20;
r.fraction = document.querySelector("#eq-04-flat-punch mfrac").getBoundingClientRect().height > 10;
r.unknown = document.querySelectorAll("math merror").length;
// A place matches as a whole: an entry of theorem 16 does not match theorem 1.
type("theorem 1"); r.byPlace = ids(visible());
r.address = location.hash;
type("");
location.hash = "#?q=flat+punch&hide=proved&sort=-id";
window.dispatchEvent(new HashChangeEvent("hashchange"));
r.recalled = ids(visible()); r.recalledText = document.getElementById("filter").value;
box("proved"); type(""); order("place");
// Open details are printed; all of them are printed if the reader asks for it.
window.dispatchEvent(new Event("beforeprint")); r.printed = opened().length;
window.print = function () { r.printedAll = opened().length; };
click("print-all");
window.dispatchEvent(new Event("afterprint")); r.afterPrint = opened().length;
// A formula shows its TeX and links to its symbols.
document.querySelector("#eq-04-flat-punch .statement math").dispatchEvent(new MouseEvent("click", { bubbles: true, cancelable: true }));
r.tex = document.querySelector("#formula code").textContent;
r.symbols = Array.prototype.map.call(document.querySelectorAll("#formula a"), function (a) {
  return document.querySelector(a.hash).textContent; });
// A verdict is cited as text and as BibTeX.
document.querySelector("#energy-identity .cite").click();
r.cited = document.querySelector("#formula > p").textContent;
r.bibtex = document.querySelector("#formula > pre").textContent.split("\n")[0];
// A link opens its statement, even if the filter hides it.
type("flat punch");
location.hash = "#energy-identity";
window.dispatchEvent(new HashChangeEvent("hashchange"));
r.linked = opened(); r.linkedVisible = visible().length;
location.hash = "#references";
window.dispatchEvent(new HashChangeEvent("hashchange"));
r.still = opened();
result = JSON.stringify(r);
