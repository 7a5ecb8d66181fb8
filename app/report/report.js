// The ledger's filter, order and folds. Without it the page is complete, in the paper's order.
(function () {
  "use strict";
  var tools = document.getElementById("tools");
  var list = document.getElementById("claims");
  if (!tools || !list) return;
  var claims = Array.prototype.slice.call(list.querySelectorAll(".claim"));
  var boxes = Array.prototype.slice.call(tools.querySelectorAll("input[name=verdict]"));
  var buttons = Array.prototype.slice.call(tools.querySelectorAll("[data-sort]"));
  var filter = document.getElementById("filter");
  var shown = document.getElementById("shown");
  var severity = { refuted: 0, undecided: 1, supported: 2, proved: 3 };

  function show() {
    var words = filter.value.toLowerCase().split(/\s+/).filter(Boolean);
    var verdicts = boxes.filter(function (box) { return box.checked; }).map(function (box) { return box.value; });
    var count = 0;
    claims.forEach(function (claim) {
      var text = claim.dataset.text.toLowerCase();
      var visible = verdicts.indexOf(claim.dataset.verdict) >= 0 &&
        words.every(function (word) { return text.indexOf(word) >= 0; });
      claim.hidden = !visible;
      if (visible) count += 1;
    });
    shown.textContent = count + " of " + claims.length + " shown";
  }

  var before = {
    place: function (a, b) { return a.dataset.order - b.dataset.order; },
    id: function (a, b) { return a.id < b.id ? -1 : a.id > b.id ? 1 : 0; },
    verdict: function (a, b) { return severity[a.dataset.verdict] - severity[b.dataset.verdict]; },
    seconds: function (a, b) { return b.dataset.seconds - a.dataset.seconds; }
  };

  // A second click on the same button turns the order round; equal ones stay in the paper's.
  function sort(button) {
    var down = button.dataset.direction === "up";
    buttons.forEach(function (other) {
      other.setAttribute("aria-pressed", String(other === button));
      delete other.dataset.direction;
    });
    button.dataset.direction = down ? "down" : "up";
    claims.sort(function (a, b) {
      return (down ? -1 : 1) * before[button.dataset.sort](a, b) || before.place(a, b);
    });
    claims.forEach(function (claim) { list.appendChild(claim); });
  }

  function fold(open) {
    claims.forEach(function (claim) { if (!claim.hidden) claim.open = open; });
  }

  function openTarget() {
    var id = decodeURIComponent(location.hash.slice(1));
    var claim = id && document.getElementById(id);
    if (!claim || claims.indexOf(claim) < 0) return;
    if (claim.hidden) {
      filter.value = "";
      boxes.forEach(function (box) { box.checked = true; });
      show();
    }
    claim.open = true;
    claim.scrollIntoView();
  }

  var folded = [];
  window.addEventListener("beforeprint", function () {
    folded = claims.filter(function (claim) { return !claim.open; });
    folded.forEach(function (claim) { claim.open = true; });
  });
  window.addEventListener("afterprint", function () {
    folded.forEach(function (claim) { claim.open = false; });
  });

  tools.addEventListener("submit", function (event) { event.preventDefault(); });
  filter.addEventListener("input", show);
  boxes.forEach(function (box) { box.addEventListener("change", show); });
  buttons.forEach(function (button) { button.addEventListener("click", function () { sort(button); }); });
  document.getElementById("open-all").addEventListener("click", function () { fold(true); });
  document.getElementById("close-all").addEventListener("click", function () { fold(false); });
  window.addEventListener("hashchange", openTarget);
  tools.hidden = false;
  sort(buttons[0]);
  show();
  openTarget();
})();
