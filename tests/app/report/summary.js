// Checks the summary of a run on the page.
var count = {};
all.forEach(function (c) { count[c.dataset.verdict] = (count[c.dataset.verdict] || 0) + 1; });
result = JSON.stringify({ shown: visible().length, count: count,
                          summary: document.getElementById("summary").textContent,
                          tiles: numbers("#tiles-ledger"), statements: numbers("#tiles-paper") });
function numbers(tiles) {
  return Array.prototype.map.call(document.querySelectorAll(tiles + " .tile b"), function (b) { return Number(b.textContent); });
}
