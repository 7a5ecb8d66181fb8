#include <fmt/format.h>

#include "app/report/references.hpp"
#include "app/report/sections.hpp"

namespace steadyslide::app {
namespace {

/// A path, which may go on in the next line after a part of it.
std::string path(std::string_view file) {
  std::string html;
  for (const char c : file) {
    html += escaped({&c, 1});
    if (c == '/' || c == '_') html += "<wbr>";
  }
  return element("code", html);
}

}  // namespace

Section mutants_section(const std::vector<Mutant>& mutants) {
  Section section{"mutants", "Faults put into the program", ""};
  if (mutants.empty()) return section;
  std::vector<std::vector<std::string>> rows;
  rows.reserve(mutants.size());
  for (const Mutant& m : mutants) {
    rows.push_back({element("code", escaped(m.id)), path(m.file), cited_prose(m.change),
                    element("code", escaped(m.killer)), cited_prose(m.evidence)});
  }
  section.html = element("p", fmt::format("Controls change a statement; these changes, {} of them, were made in the "
                                          "program itself, one at a time, and each was noticed by the "
                                          "executable named, a test or a part of the checks, with its arguments.",
                                          mutants.size())) +
                 "\n" + table_element(section.title, {"id", "file", "change", "noticed by", "evidence"}, rows);
  return section;
}

}  // namespace steadyslide::app
