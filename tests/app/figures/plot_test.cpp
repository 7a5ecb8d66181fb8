// The picture of the rough surface: the commands of examples/README.md draw it.

#include "app/command_line.hpp"
#include "app/svg.hpp"

namespace {

const std::string examples = STEADYSLIDE_EXAMPLES;

Finished draw(const TemporaryFolder& folder, const Arguments& arguments) {
  return run_other(joined({"gnuplot", "-c", examples + "/plot_rough_surface.gp"}, arguments), folder.path());
}

/// The lengths of the longest paths of a colour, counted in characters.
std::size_t longest_path(const std::string& svg, const std::string& colour) {
  std::size_t longest = 0;
  for (std::size_t at = 0; (at = svg.find("<path", at)) != std::string::npos; ++at) {
    const std::string path = svg.substr(at, svg.find("/>", at) - at);
    const std::string before = svg.substr(svg.rfind("<g", at), at - svg.rfind("<g", at));
    if (holds(before + path, colour)) longest = std::max(longest, path.size());
  }
  return longest;
}

}  // namespace

TEST_CASE("the script draws what was solved, well-formed, every curve with its points") {
  const TemporaryFolder folder;
  const Finished solved = folder.run({"solve", examples + "/rough_surface.toml", "--method", "variational", "--cells",
                                      "65536", "--at=-0.99975:0.99975:0.0005", "--format", "csv", "-o", "solved.csv"});
  CHECK(solved.code == 0);
  out_of(draw(folder, {"solved.csv", examples + "/rough_surface.csv", "picture.svg"}));
  const std::string svg = folder.read("picture.svg");
  CHECK(is_well_formed(svg));
  check_holds(svg, {"profile", "surface u + C", "contact zones", "pressure", "x (unit of length)"});
  // 2000 points each, in the colours of profile and of surface and pressure.
  CHECK(longest_path(svg, "176,  48,  48") > 10000);
  CHECK(longest_path(svg, " 32,  96, 160") > 10000);
  // The control.
  CHECK(longest_path(svg, "1,   2,   3") == 0);
  CHECK_FALSE(is_well_formed(svg.substr(0, svg.size() / 2)));
  CHECK_FALSE(is_well_formed("<a><b></a></b>"));

  const Finished incomplete = draw(folder, {"solved.csv"});
  CHECK(incomplete.code == 2);
  CHECK(incomplete.err == "usage: gnuplot -c plot_rough_surface.gp SOLVED TRACE PICTURE\n");
}
