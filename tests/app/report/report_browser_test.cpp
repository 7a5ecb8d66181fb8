// The report in a browser: filter, order, folds, phone, print. The scripts are tests/app/report/*.js.

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <regex>

#include "app/process.hpp"
#include "app/report_fixture.hpp"

using Json = nlohmann::json;

namespace {

struct Browsed {
  std::string result;                ///< text in <pre id="result">, written by the page's script, entities resolved
  std::vector<std::string> console;  ///< messages of the page, and of the browser about it, on the console
};

std::string script(const std::string& file) { return file_text(STEADYSLIDE_TESTS "/app/report/" + file); }

/// True if there is no browser. If the environment has CI set, the tests have to run.
bool skipped() {
  if (std::getenv("CI") != nullptr) return false;
  if (run_other({"sh", "-c", "command -v chromium"}, std::filesystem::temp_directory_path()).code == 0) return false;
  MESSAGE("skipped: no chromium");
  return true;
}

/// Each run has its own profile: browsers cannot share one.
Finished chromium(const std::filesystem::path& folder, std::vector<std::string> arguments) {
  std::vector<std::string> command{"chromium",
                                   "--headless=new",
                                   "--no-sandbox",
                                   "--disable-gpu",
                                   "--disable-dev-shm-usage",
                                   "--no-first-run",
                                   "--disable-extensions",
                                   "--user-data-dir=" + (folder / "profile").string(),
                                   "--host-resolver-rules=MAP * ~NOTFOUND",
                                   "--allow-file-access-from-files",
                                   "--enable-logging=stderr",
                                   "--v=0"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return run_other(command, folder);
}

std::string url(const std::filesystem::path& file) { return "file://" + file.string(); }

/// Opens FOLDER/PAGE and runs `drive` at its end; the script leaves text in a variable `result`.
Browsed browse(const std::filesystem::path& folder, const std::string& page, const std::string& drive) {
  const std::string html = file_text((folder / page).string());
  const std::size_t head = html.find("<head>") + 6, end = html.rfind("</body>");
  if (head < 6 || end == std::string::npos) throw std::runtime_error("no page: " + page);
  const std::string mark = "/* SCRIPT */";
  std::string after = script("after.js");
  const std::filesystem::path driven = folder / ("driven-" + page);
  std::ofstream(driven, std::ios::binary) << html.substr(0, head) << "<script>\n"
                                          << script("before.js") << "</script>\n"
                                          << html.substr(head, end - head) << "<script>\n"
                                          << after.replace(after.find(mark), mark.size(), drive) << "</script>\n"
                                          << html.substr(end);
  const Finished finished = chromium(folder, {"--virtual-time-budget=5000", "--dump-dom", url(driven)});
  const std::string opening = "<pre id=\"result\">";
  const std::size_t begin = finished.out.rfind(opening);
  if (begin == std::string::npos) throw std::runtime_error("the browser shows no result: " + finished.err);
  const std::size_t from = begin + opening.size();
  Browsed browsed{finished.out.substr(from, finished.out.find("</pre>", from) - from), {}};
  for (const auto& [entity, character] : {std::pair("&lt;", "<"), {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}}) {
    browsed.result = std::regex_replace(browsed.result, std::regex(entity), character);
  }
  for (const std::string& line : lines(finished.err)) {
    if (holds(line, "CONSOLE")) browsed.console.push_back(line);
  }
  return browsed;
}

/// Returns the number of printed pages of FOLDER/PAGE.
std::ptrdiff_t printed_pages(const std::filesystem::path& folder, const std::string& page) {
  const std::string pdf = (folder / "printed.pdf").string();
  chromium(folder,
           {"--virtual-time-budget=5000", "--no-pdf-header-footer", "--print-to-pdf=" + pdf, url(folder / page)});
  const std::string text = file_text(pdf);
  const std::regex leaf("/Type ?/Page[^s]");
  return std::distance(std::sregex_iterator(text.begin(), text.end(), leaf), {});
}

/// A fabricated page in its own folder.
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
  CHECK(drive(Page().folder, "ledger.js") ==
        Json::parse(std::regex_replace(script("ledger.json"), std::regex("VERSION"), STEADYSLIDE_VERSION)));
}

TEST_CASE("on a phone nothing is wider than the page, in both colour schemes") {
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

TEST_CASE("the page prints on more than one sheet") {
  if (skipped()) return;
  CHECK(printed_pages(Page().folder.path(), "report.html") > 1);
}

TEST_CASE("control: an error or a warning of a page is noticed") {
  if (skipped()) return;
  const TemporaryFolder folder{
      {"bad.html", "<!DOCTYPE html><html><head></head><body><script>missing();</script></body></html>"}};
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
  const Finished finished = folder.run({"verify", "--quick", "--digits", "16", "--claim", "eq-04-*", "--claim",
                                        "gamma-*", "--format", "json", "--report", ".", "-o", "out.json"});
  CHECK(finished.code == 0);
  const Json json = Json::parse(folder.read("out.json")), seen = drive(folder, "summary.js");
  CHECK(seen["shown"] == json["claims"].size());
  const Json& counts = json["counts"];
  CHECK(seen["tiles"] == Json{counts["proved"], counts["supported"], counts["undecided"], counts["refuted"]});
  const Json& statements = json["statement_counts"];
  CHECK(seen["statements"] == Json{statements["proved"], statements["proved, restricted"],
                                   statements["proved, as reconstructed"], statements["supported"],
                                   statements["undecided"], statements["refuted"]});
  std::map<std::string, int> of_the_paper;
  for (const Json& statement : json["statements"]) {
    if (statement["place"] != "") ++of_the_paper[statement["standing"].get<std::string>()];
  }
  CHECK(of_the_paper["proved"] == statements["proved"]);
  CHECK(of_the_paper["proved"] > 0);
  std::size_t total = 0;
  for (const Json& claim : json["claims"]) total += claim["controls"]["total"].get<std::size_t>();
  const std::string n = std::to_string(total);
  CHECK(holds(seen["summary"].get<std::string>(), n + " of " + n + " controls refuted"));
  for (const auto& [verdict, count] : seen["count"].items()) CHECK(counts[verdict] == count);
}
