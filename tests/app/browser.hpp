#pragma once
// A page in a browser without a window.

#include <filesystem>
#include <string>
#include <vector>

namespace steadyslide::testing {

struct Browsed {
  std::string result;                ///< what the page's script left in <pre id="result">, entities resolved
  std::vector<std::string> console;  ///< what the page, or the browser about it, wrote to the console
};

/// Is there none? False where the environment says CI: there the tests have to run.
bool no_browser();

/// Opens FOLDER/PAGE with `script` run at its end, which leaves text in a variable `result`.
Browsed browse(const std::filesystem::path& folder, const std::string& page, const std::string& script);

/// The number of pages of FOLDER/PAGE, printed.
std::size_t printed_pages(const std::filesystem::path& folder, const std::string& page);

}  // namespace steadyslide::testing
