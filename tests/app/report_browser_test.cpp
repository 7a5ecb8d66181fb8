// The report in a browser: filter, order, folds, phone, print.

#include <nlohmann/json.hpp>

#include "app/browser.hpp"
#include "app/process.hpp"
#include "app/report_fixture.hpp"
#include "support/test.hpp"

using namespace steadyslide::testing;
using Json = nlohmann::json;

namespace {

/// What every drive of a page uses.
const std::string tools = R"JS(
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
)JS";

bool skipped() {
  if (!no_browser()) return false;
  MESSAGE("skipped: no chromium");
  return true;
}

/// A fabricated page in a folder of its own.
struct Page {
  TemporaryFolder folder;
  Page() { folder.write("report.html", steadyslide::app::report_html(fabricated_result(), fabricated_supplement())); }
  Json drive(const std::string& script) const {
    const Browsed browsed = browse(folder.path(), "report.html", tools + script);
    CAPTURE(browsed.result);
    CHECK(browsed.console == std::vector<std::string>{});
    REQUIRE(browsed.result.starts_with("{"));
    return Json::parse(browsed.result);
  }
};

Json list(std::initializer_list<const char*> ids) {
  Json json = Json::array();
  for (const char* id : ids) json.push_back(id);
  return json;
}

}  // namespace

TEST_CASE("the ledger in a browser: filter, verdicts, order, folds") {
  if (skipped()) return;
  const Page page;
  const Json seen = page.drive(R"JS(
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
    r.height = first.offsetHeight;
    first.querySelector("summary").click(); r.opened = opened(); r.tall = first.offsetHeight > r.height + 100;
    first.querySelector("summary").click(); r.closed = opened();
    click("open-all"); r.everything = opened().length;
    click("close-all"); r.nothing = opened().length;
    r.maths = document.querySelectorAll("math").length;
    r.fraction = document.querySelector("#eq-04-flat-punch mfrac").getBoundingClientRect().height > 10;
    r.unknown = document.querySelectorAll("math merror").length;
    result = JSON.stringify(r);
  )JS");
  const Json ledger = list({"energy-identity", "eq-04-flat-punch", "vi-rate", "thm-16-existence", "bad-claim"});
  CHECK(seen["all"] == ledger);
  CHECK(seen["tools"] == true);
  CHECK(seen["status"] == "5 of 5 shown");
  CHECK(seen["filtered"] == list({"eq-04-flat-punch"}));
  CHECK(seen["filteredStatus"] == "1 of 5 shown");
  CHECK(seen["bySource"] == list({"thm-16-existence"}));
  CHECK(seen["byFormula"] == list({"eq-04-flat-punch"}));
  CHECK(seen["none"] == Json::array());
  CHECK(seen["withoutSupported"] == list({"energy-identity", "thm-16-existence", "bad-claim"}));
  CHECK(seen["openedVisible"] == seen["withoutSupported"]);
  CHECK(seen["again"] == 5);
  const Json slowest = list({"vi-rate", "bad-claim", "eq-04-flat-punch", "energy-identity", "thm-16-existence"});
  CHECK(seen["slowest"] == slowest);
  CHECK(seen["fastest"] == Json(std::vector<Json>(slowest.rbegin(), slowest.rend())));
  CHECK(seen["byId"] == list({"bad-claim", "energy-identity", "eq-04-flat-punch", "thm-16-existence", "vi-rate"}));
  CHECK(seen["byVerdict"] == list({"bad-claim", "thm-16-existence", "eq-04-flat-punch", "vi-rate", "energy-identity"}));
  CHECK(seen["pressed"] == 1);
  CHECK(seen["byOrder"] == ledger);
  CHECK(seen["opened"] == list({"eq-04-flat-punch"}));
  CHECK(seen["tall"] == true);
  CHECK(seen["closed"] == Json::array());
  CHECK(seen["everything"] == 5);
  CHECK(seen["nothing"] == 0);
  CHECK(seen["maths"] > 20);
  CHECK(seen["fraction"] == true);
  CHECK(seen["unknown"] == 0);
}

TEST_CASE("a link to a statement opens it, also where the filter hides it") {
  if (skipped()) return;
  const Page page;
  const Json seen = page.drive(R"JS(
    var r = {};
    type("flat punch");
    location.hash = "#energy-identity";
    window.dispatchEvent(new HashChangeEvent("hashchange"));
    r.opened = opened();
    r.visible = visible().length;
    location.hash = "#references";
    window.dispatchEvent(new HashChangeEvent("hashchange"));
    r.still = opened();
    result = JSON.stringify(r);
  )JS");
  CHECK(seen["opened"] == list({"energy-identity"}));
  CHECK(seen["visible"] == 5);
  CHECK(seen["still"] == list({"energy-identity"}));
}

TEST_CASE("on a phone nothing is wider than the page, in both colours") {
  if (skipped()) return;
  const Page page;
  page.folder.write("phone.html",
                    "<!DOCTYPE html><html><head></head><body style=\"margin:0\"><iframe id=\"phone\" "
                    "width=\"390\" height=\"800\" src=\"report.html\"></iframe></body></html>");
  const std::string script = R"JS(
    var inner = document.getElementById("phone").contentDocument;
    inner.getElementById("open-all").click();
    var wide = [];
    inner.querySelectorAll("body *").forEach(function (e) {
      if (e.closest("svg, math, .wide, .drawing, pre")) return;
      if (e.getBoundingClientRect().right > 390.5) wide.push(e.tagName + "." + e.className);
    });
    result = JSON.stringify({ width: inner.documentElement.scrollWidth, wide: wide,
                              open: inner.querySelectorAll("details[open]").length });
  )JS";
  const Browsed browsed = browse(page.folder.path(), "phone.html", script);
  CAPTURE(browsed.result);
  REQUIRE(browsed.result.starts_with("{"));
  const Json seen = Json::parse(browsed.result);
  CHECK(seen["width"] <= 390);
  CHECK(seen["open"] == 5);
  CHECK(seen["wide"] == Json::array());
}

TEST_CASE("printed, the entries are open and the page is more than one") {
  if (skipped()) return;
  const Page page;
  CHECK(printed_pages(page.folder.path(), "report.html") > 1);
  const Json seen = page.drive(R"JS(
    window.dispatchEvent(new Event("beforeprint"));
    var r = { printed: opened().length };
    window.dispatchEvent(new Event("afterprint"));
    r.after = opened().length;
    result = JSON.stringify(r);
  )JS");
  CHECK(seen["printed"] == 5);
  CHECK(seen["after"] == 0);
}

TEST_CASE("control: a page that complains is noticed") {
  if (skipped()) return;
  const TemporaryFolder folder;
  folder.write("bad.html", "<!DOCTYPE html><html><head></head><body><script>missing();</script></body></html>");
  CHECK(browse(folder.path(), "bad.html", "result = 'fine';").result.starts_with("COMPLAINTS"));
  folder.write("far.html",
               "<!DOCTYPE html><html><head></head><body><img src=\"http://example.invalid/x.png\"></body></html>");
  const Browsed far = browse(folder.path(), "far.html", "console.warn('seen'); result = 'fine';");
  CHECK(far.result == "fine");
  CHECK_FALSE(far.console.empty());
}

TEST_CASE("page and JSON of one run agree") {
  if (skipped()) return;
  const TemporaryFolder folder;
  const Finished finished = run_program(
      {"verify", "--quick", "--digits", "16", "--claim", "eq-*", "--format", "json", "--report", ".", "-o", "out.json"},
      folder.path());
  CHECK(finished.code == 0);
  const Json json = Json::parse(folder.read("out.json"));
  const Browsed browsed = browse(folder.path(), "report.html", tools + R"JS(
    var count = {};
    all.forEach(function (c) { count[c.dataset.verdict] = (count[c.dataset.verdict] || 0) + 1; });
    result = JSON.stringify({ shown: visible().length, count: count,
                              summary: document.getElementById("summary").textContent,
                              tiles: Array.prototype.map.call(document.querySelectorAll(".tile b"),
                                                              function (b) { return Number(b.textContent); }) });
  )JS");
  CAPTURE(browsed.result);
  CHECK(browsed.console == std::vector<std::string>{});
  const Json seen = Json::parse(browsed.result);
  CHECK(seen["shown"] == json["claims"].size());
  CHECK(seen["tiles"] == Json{json["counts"]["proved"], json["counts"]["supported"], json["counts"]["undecided"],
                              json["counts"]["refuted"]});
  std::size_t total = 0;
  for (const Json& claim : json["claims"]) total += claim["controls"]["total"].get<std::size_t>();
  const std::string controls = std::to_string(total) + " of " + std::to_string(total) + " controls refuted";
  CHECK(seen["summary"].get<std::string>().find(controls) != std::string::npos);
  for (const auto& [verdict, n] : seen["count"].items()) CHECK(json["counts"][verdict] == n);
}
