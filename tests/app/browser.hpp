#pragma once
// A page in a browser without a window.

#include <cstdlib>
#include <regex>

#include "app/process.hpp"
#include "support/test.hpp"

namespace steadyslide::testing {

struct Browsed {
  std::string result;                ///< what the page's script left in <pre id="result">, entities resolved
  std::vector<std::string> console;  ///< what the page, or the browser about it, wrote to the console
};

inline std::string script(const std::string& file) { return file_text(STEADYSLIDE_TESTS "/app/report/" + file); }

/// Is there none? False where the environment says CI: there the tests have to run.
inline bool no_browser() {
  if (std::getenv("CI") != nullptr) return false;
  return run_other({"sh", "-c", "command -v chromium"}, std::filesystem::temp_directory_path()).code != 0;
}

/// The profile is of this run: browsers do not share one.
inline Finished chromium(const std::filesystem::path& folder, std::vector<std::string> arguments) {
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

inline std::string url(const std::filesystem::path& file) { return "file://" + file.string(); }

/// Opens FOLDER/PAGE with `drive` run at its end, which leaves text in a variable `result`.
inline Browsed browse(const std::filesystem::path& folder, const std::string& page, const std::string& drive) {
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

/// The number of pages of FOLDER/PAGE, printed.
inline std::ptrdiff_t printed_pages(const std::filesystem::path& folder, const std::string& page) {
  const std::string pdf = (folder / "printed.pdf").string();
  chromium(folder,
           {"--virtual-time-budget=5000", "--no-pdf-header-footer", "--print-to-pdf=" + pdf, url(folder / page)});
  const std::string text = file_text(pdf);
  const std::regex leaf("/Type ?/Page[^s]");
  return std::distance(std::sregex_iterator(text.begin(), text.end(), leaf), {});
}

}  // namespace steadyslide::testing
