// The report in a browser: filter, order, folds, phone, print. What is done there: tests/app/report/*.js.

#include <nlohmann/json.hpp>

#include "app/browser.hpp"
#include "app/report_fixture.hpp"

using Json = nlohmann::json;

namespace {

bool skipped() {
  if (!no_browser()) return false;
  MESSAGE("skipped: no chromium");
  return true;
}

/// A fabricated page in a folder of its own.
struct Page {
  TemporaryFolder folder;
  Page() { folder.write("report.html", app::report_html(fabricated_result(), fabricated_supplement())); }
};

Json drive(const TemporaryFolder& folder, const std::string& page, const std::string& text) {
  const Browsed browsed = browse(folder.path(), page, text);
  CAPTURE(browsed.result);
  CHECK(browsed.console == std::vector<std::string>{});
  REQUIRE(browsed.result.starts_with("{"));
  return Json::parse(browsed.result);
}

Json drive(const TemporaryFolder& folder, const std::string& file) {
  return drive(folder, "report.html", script("tools.js") + script(file));
}

}  // namespace

TEST_CASE("the ledger in a browser: filter, verdicts, order, folds, links, print") {
  if (skipped()) return;
  CHECK(drive(Page().folder, "ledger.js") == Json::parse(script("ledger.json")));
}

TEST_CASE("on a phone nothing is wider than the page, in both colours") {
  if (skipped()) return;
  const Page page;
  page.folder.write("phone.html",
                    "<!DOCTYPE html><html><head></head><body style=\"margin:0\"><iframe id=\"phone\" "
                    "width=\"390\" height=\"800\" src=\"report.html\"></iframe></body></html>");
  const Json seen = drive(page.folder, "phone.html", script("phone.js"));
  CHECK(seen["width"] <= 390);
  CHECK(seen["open"] == 5);
  CHECK(seen["wide"] == Json::array());
}

TEST_CASE("the page is printed on more than one") {
  if (skipped()) return;
  CHECK(printed_pages(Page().folder.path(), "report.html") > 1);
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
  const Json json = Json::parse(folder.read("out.json")), seen = drive(folder, "summary.js");
  CHECK(seen["shown"] == json["claims"].size());
  const Json& counts = json["counts"];
  CHECK(seen["tiles"] == Json{counts["proved"], counts["supported"], counts["undecided"], counts["refuted"]});
  std::size_t total = 0;
  for (const Json& claim : json["claims"]) total += claim["controls"]["total"].get<std::size_t>();
  const std::string n = std::to_string(total);
  CHECK(holds(seen["summary"].get<std::string>(), n + " of " + n + " controls refuted"));
  for (const auto& [verdict, count] : seen["count"].items()) CHECK(counts[verdict] == count);
}
