#include "app/browser.hpp"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "app/process.hpp"

namespace steadyslide::testing {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The profile is of this run: browsers do not share one.
Finished chromium(const fs::path& folder, std::vector<std::string> arguments) {
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

std::string url(const fs::path& file) { return "file://" + file.string(); }

std::string resolved(std::string text) {
  for (const auto& [entity, character] : {std::pair("&lt;", "<"), {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}}) {
    text = std::regex_replace(text, std::regex(entity), character);
  }
  return text;
}

constexpr const char* before = R"(<script>
var complaints = [];
window.addEventListener("error", function (event) { complaints.push(String(event.message)); });
console.error = function (text) { complaints.push(String(text)); };
</script>
)";

std::string after(const std::string& script) {
  return "<script>\nwindow.addEventListener('load', function () {\n  var result = '';\n  try {\n" + script +
         "\n  } catch (error) { complaints.push(String(error)); }\n"
         "  var pre = document.createElement('pre');\n  pre.id = 'result';\n"
         "  pre.textContent = complaints.length ? 'COMPLAINTS ' + complaints.join('; ') : result;\n"
         "  document.body.appendChild(pre);\n});\n</script>\n";
}

}  // namespace

bool no_browser() {
  if (std::getenv("CI") != nullptr) return false;
  return run_other({"sh", "-c", "command -v chromium"}, fs::temp_directory_path()).code != 0;
}

Browsed browse(const fs::path& folder, const std::string& page, const std::string& script) {
  std::string html = read(folder / page);
  const std::size_t head = html.find("<head>"), end = html.rfind("</body>");
  if (head == std::string::npos || end == std::string::npos) throw std::runtime_error("no page: " + page);
  html.insert(end, after(script));
  html.insert(head + 6, before);
  const fs::path driven = folder / ("driven-" + page);
  std::ofstream(driven, std::ios::binary) << html;
  const Finished finished = chromium(folder, {"--virtual-time-budget=5000", "--dump-dom", url(driven)});
  Browsed browsed;
  const std::string opening = "<pre id=\"result\">";
  const std::size_t begin = finished.out.rfind(opening);
  if (begin == std::string::npos) throw std::runtime_error("the browser shows no result: " + finished.err);
  const std::size_t from = begin + opening.size();
  browsed.result = resolved(finished.out.substr(from, finished.out.find("</pre>", from) - from));
  std::istringstream lines(finished.err);
  for (std::string line; std::getline(lines, line);) {
    if (line.find("CONSOLE") != std::string::npos) browsed.console.push_back(line);
  }
  return browsed;
}

std::size_t printed_pages(const fs::path& folder, const std::string& page) {
  const fs::path pdf = folder / "printed.pdf";
  chromium(folder, {"--virtual-time-budget=5000", "--no-pdf-header-footer", "--print-to-pdf=" + pdf.string(),
                    url(folder / page)});
  const std::string text = read(pdf);
  const std::regex leaf("/Type ?/Page[^s]");
  return static_cast<std::size_t>(std::distance(std::sregex_iterator(text.begin(), text.end(), leaf), {}));
}

}  // namespace steadyslide::testing
