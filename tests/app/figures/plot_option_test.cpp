// `solve --plot`: texts of the picture, its formats, and refused options. figure_of_solution_test.cpp tests the curves.

#include "app/json_answers.hpp"
#include "app/svg.hpp"

TEST_CASE("friction values stand on the indenter, and units at the axes") {
  const TemporaryFolder folder;
  const auto text = [&](const std::string& problem) {
    out_of(folder.run({"solve", "-", "-o", "text", "--plot", "p.svg"}, problem));
    return shown_text(folder.read("p.svg"));
  };
  const std::string problem =
      "load = 3\nhalf_space.poisson = 0.2\nfriction = {values = [0.1, '1/3', 0.5], jumps = [-0.5, 0.5]}\n"
      "indenter.profile = '0'\n";
  const std::string plain = text(problem);
  check_holds(plain, {"f = 0.1\n", "\n0.333\n", "load 3, ", "(user's unit of length)", "(user's unit of stress)"});
  const std::string named = text(problem + "units = {length = 'mm', force = 'N'}\n");
  check_holds(named, {"f = 0.1\n", "load 3 N/mm, ", "x  (mm)\n", "height  (mm)\n", "traction  (N/mm²)\n"});
  CHECK_FALSE(holds(named, "user's unit"));
  // Only a length: stresses have no name. Signs of gnuplot are signs of a text.
  check_holds(text(problem + "units = {length = 'in_{x}'}\n"), {"x  (in_{x})\n", "(user's unit of stress)"});
  // Values without room are counted.
  std::string values = "0", jumps;
  for (int k = 1; k < 200; ++k) {
    values += ", " + std::to_string(k);
    jumps += (k == 1 ? "'" : ", '") + std::to_string(k - 100) + "/100'";
  }
  check_holds(text("load = 1\nhalf_space.poisson = 0.2\nfriction = {values = [" + values + "], jumps = [" + jumps +
                   "]}\nindenter.profile = '0'\n"),
              {"f = 0\n", "friction values more are in the results", "exponents more are in the results"});
}

TEST_CASE("texts of a proved solution, and of both directions of sliding") {
  const TemporaryFolder folder;
  const std::string picture = (folder.path() / "p.svg").string();
  out_of(run_example("two_coatings_backward.toml", {"--certify", "--plot", picture}));
  CHECK(is_well_formed(folder.read("p.svg")));
  check_holds(shown_text(folder.read("p.svg")), {"closed-form\n", "sliding towards −x\n", "0.0471\n", ", cut at 3"});
  out_of(run_example("two_bumps.toml", {"--both-directions", "--plot", picture}));
  CHECK(is_well_formed(folder.read("p.svg")));
  check_holds(shown_text(folder.read("p.svg")), {"two_bumps.toml, load 0.1, sliding towards +x and towards −x\n",
                                                 "contact, towards −x", "shear t", ", towards −x"});
}

TEST_CASE("a picture shows a problem far from zero and a very small problem in full size") {
  for (const std::string indenter :
       {"load = 0.1\nindenter = {support = [999999, 1000001], profile = '(x-1000000)^2/2'}\n",
        "load = '1e-12'\nindenter = {support = ['-1e-9', '1e-9'], profile = '1e8*x^2'}\n"}) {
    const TemporaryFolder folder;
    out_of(folder.run({"solve", "-", "-o", "text", "--plot", "p.svg"},
                      indenter + "half_space.poisson = 0.3\nfriction.values = [0.2]\n"));
    const std::string svg = folder.read("p.svg");
    check_holds(shown_text(svg), {"standard input", "surface", "shear"});
    // A curve goes up and down over a large part of its panel.
    const std::size_t begin = svg.find(" d='", svg.find("id=\"solve_plot_1b\""));
    const std::string path = svg.substr(begin, svg.find('\'', begin + 4) - begin);
    static const std::regex upwards(",(-?[0-9.]+)");
    std::vector<double> y;
    for (std::sregex_iterator at(path.begin(), path.end(), upwards), end; at != end; ++at)
      y.push_back(std::stod((*at)[1]));
    CHECK(*std::ranges::max_element(y) - *std::ranges::min_element(y) > 100);
  }
}

TEST_CASE("--plot draws PDF or PNG by the ending of the name") {
  const TemporaryFolder folder;
  for (const auto& [file, magic] : {std::pair("p.pdf", "%PDF-"), {"p.png", "\x89PNG\r\n\x1a\n"}}) {
    const std::string picture = (folder.path() / file).string();
    CHECK(holds(out_of(run_example("parabola.toml", {"--plot", picture})), "effective friction"));
    CHECK(folder.read(file).starts_with(magic));
    CHECK(folder.read(file).size() > 10000);
  }
  // 1600 x 1360 pixels, big-endian, in the header of a PNG.
  CHECK(folder.read("p.png").substr(16, 8) == std::string("\0\0\x06\x40\0\0\x05\x50", 8));
}

TEST_CASE("a picture says that a problem is not solved, and shows the part of a trace around the contact") {
  const TemporaryFolder folder;
  const std::string picture = (folder.path() / "p.svg").string();
  CHECK(run_example("rough_surface.toml", {"--cells", "4096", "--plot", picture}).code == 0);
  check_holds(shown_text(folder.read("p.svg")), {"rough_surface.toml", "−0.0271"});
  const Arguments unsolved = words("--method variational --cells 256 --iterations 1 --plot");
  CHECK(run_example("two_bumps.toml", joined(unsolved, {picture})).code == 1);
  check_holds(shown_text(folder.read("p.svg")), {"NOT SOLVED: two_bumps.toml"});
}

TEST_CASE("if the picture cannot be written, nothing is solved and no file is left") {
  const TemporaryFolder folder;
  const auto refused = [&](const Arguments& plot, const std::string& message, int code) {
    check_refused(folder.run(joined({"solve", STEADYSLIDE_EXAMPLES "/parabola.toml"}, plot)), message, code);
    CHECK(folder.names().empty());
  };
  refused({"--plot", "none/p.svg"}, "none/p.svg: cannot be written: No such file or directory", 3);
  refused({"--plot", "p.svg", "-o", "none/text"}, "none/text: cannot be written: No such file or directory", 3);
  refused({"--plot", "p.svg", "--method", "variational", "--cells", "8"},
          "command line: --cells: out of range; it is a whole number from 16 to 4194304; '8'", 2);
  // A PATH that does not contain gnuplot.
  const Finished missing =
      run_program_by({"env", "PATH=" + folder.path().string()},
                     {"solve", STEADYSLIDE_EXAMPLES "/parabola.toml", "--plot", "p.svg"}, folder.path());
  check_refused(missing, "gnuplot: not found; figures are drawn by gnuplot 5.4 or later (Debian's package gnuplot-nox)",
                3);
  CHECK(folder.names().empty());
}
