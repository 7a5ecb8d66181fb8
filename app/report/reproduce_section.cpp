#include <fmt/format.h>

#include "app/report/sections.hpp"
#include "app/version.hpp"

namespace steadyslide::app {

Section reproduce_section(const VerifyResult& result) {
  const std::string options = fmt::format(" --digits {} --seed {}{}", static_cast<int>(result.context.digits),
                                          result.context.seed, result.context.quick ? " --quick" : "");
  const std::string commands = "steadyslide report -o DIR" + options + "\nsteadyslide verify --claim ID" + options +
                               "\nsteadyslide verify --list\n";
  return {"reproduce", "How to reproduce this",
          element("p",
                  "The page again, one statement alone, and the list of all statements. Random parameters follow from "
                  "the seed, so that only the seconds differ:") +
              "\n" + element("pre", element("code", escaped(commands)), {{"tabindex", "0"}}) + "\n" +
              element("p", fmt::format("To cite it: <em>steadyslide</em>, version {}, together with the paper whose "
                                       "theory it examines, [<a href=\"#ref-Bal16\">Bal16</a>].",
                                       version)) +
              "\n"};
}

}  // namespace steadyslide::app
