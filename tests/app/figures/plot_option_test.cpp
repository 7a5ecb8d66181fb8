// `solve --plot`: the curves in the picture are the samples of the result, for every method. Also: refused options.

#include "app/json_answers.hpp"
#include "app/svg.hpp"

namespace {

using Points = std::vector<std::pair<double, double>>;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Returns the text between `from` and the next `to`.
std::string between(const std::string& text, const std::string& from, const std::string& to, std::size_t at = 0) {
  const std::size_t begin = text.find(from, at);
  REQUIRE(begin != std::string::npos);
  const std::size_t inside = begin + from.size();
  return text.substr(inside, text.find(to, inside) - inside);
}

/// Returns the coordinates of a path's points.
Points points_of(const std::string& path) {
  Points points;
  static const std::regex pair("(-?[0-9.]+),(-?[0-9.]+)");
  for (std::sregex_iterator at(path.begin(), path.end(), pair), end; at != end; ++at) {
    points.emplace_back(std::stod((*at)[1]), std::stod((*at)[2]));
  }
  return points;
}

/// Reads a number as gnuplot prints it, with a minus sign. Returns NaN for a text.
double printed(std::string label) {
  if (label.starts_with("−")) label = "-" + label.substr(std::string("−").size());
  static const std::regex number("-?[0-9.]+(e[-+]?[0-9]+)?");
  return std::regex_match(label, number) ? std::stod(label) : std::nan("");
}

/// Converts coordinates of the picture to numbers, from the numbers at two tics.
struct Scale {
  double place = 0, value = 0, unit = 0;

  double operator()(double at) const { return value + (at - place) * unit; }
  static Scale through(const Points& tics) {
    REQUIRE(tics.size() >= 2);
    const auto& [from, low] = tics.front();
    const auto& [to, high] = tics.back();
    return {from, low, (high - low) / (to - from)};
  }
};

/// One of the panels: 'a' is the upper one, 'b' the lower one; with both directions 'c' is below 'b'.
class PlottedPanel {
 public:
  PlottedPanel(const std::string& svg, char panel) : svg_(svg), panel_(panel) {
    std::size_t begin = 0;  // the last curve of the panel before
    const auto curve_before = [&](int k) {
      return svg.find("id=\"solve_plot_" + std::to_string(k) + static_cast<char>(panel - 1));
    };
    for (int k = 1; curve_before(k) != std::string::npos; ++k) begin = curve_before(k);
    const std::string axes = svg.substr(begin, svg.find(std::string("id=\"solve_plot_1") + panel) - begin);
    Points across, up;
    for (std::size_t at = 0; (at = axes.find("<path stroke='black'  d='", at)) != std::string::npos; ++at) {
      const Points tic = points_of(between(axes, "d='", "'", at));
      const std::string text = axes.substr(at, axes.find("</g>", at) - at);
      if (tic.size() != 4 || !holds(text, "<tspan")) continue;
      const double label = printed(shown_text(text + "</text>").substr(0, shown_text(text + "</text>").find('\n')));
      if (std::isnan(label)) continue;
      if (tic[0].second == tic[1].second) up.emplace_back(tic[0].second, label);
      if (tic[0].first == tic[1].first) across.emplace_back(tic[0].first, label);
    }
    up_ = Scale::through(up);
    if (!across.empty()) across_ = Scale::through(across);
  }

  /// Returns the k-th curve, counted from 1, without the sample of its line in the legend.
  Points curve(int k) const {
    const std::size_t at = svg_.find("id=\"solve_plot_" + std::to_string(k) + panel_);
    REQUIRE(at != std::string::npos);
    const std::string group = svg_.substr(at, svg_.find("\n\t</g>\n", svg_.find("<path", at)) - at);
    Points points;
    for (std::size_t path = 0; (path = group.find("<path", path)) != std::string::npos; ++path) {
      const Points more = points_of(between(group, "d='", "'", path));
      points.insert(points.end(), more.begin(), more.end());
    }
    points.erase(points.begin(), points.begin() + 2);
    for (auto& [x, y] : points) {
      x = across_(x);
      y = up_(y);
    }
    return points;
  }

  void use_x_of(const PlottedPanel& other) { across_ = other.across_; }
  /// Half of the last digit in the picture, twice: once for the point, once for the scale.
  double tolerance_x() const { return 0.02 * std::abs(across_.unit); }
  double tolerance_y() const { return 0.02 * std::abs(up_.unit); }

 private:
  const std::string& svg_;
  char panel_;
  Scale across_, up_;
};

/// Returns how many of the points are vertices of the curve. The frame may cut off the others.
std::size_t met(const Points& points, const Points& curve, const PlottedPanel& panel) {
  std::size_t count = 0;
  for (const auto& [x, y] : points) {
    count += std::ranges::any_of(curve, [&, x = x, y = y](const auto& vertex) {
      return std::abs(vertex.first - x) <= panel.tolerance_x() && std::abs(vertex.second - y) <= panel.tolerance_y();
    });
  }
  return count;
}

struct Sampled {
  Points pressure, shear, surface;
};

double side(const Json& value, const char* which) {
  const std::string text = text_of(value_of(value.contains(which) ? value[which] : value));
  return text == "-inf" ? -infinite : text == "inf" ? infinite : std::stod(text);
}

/// Tractions are sampled only in the contact; the surface, of the height psi minus the gap, everywhere.
Sampled sampled(const Json& solution, double (*psi)(double)) {
  Sampled result;
  for (const Json& sample : solution["samples"]) {
    const double x = real(sample["x"]), gap = side(sample["gap"], "");
    result.surface.emplace_back(x, psi(x) - gap);
    if (gap > 0) continue;
    for (const char* which : {"left", "right"}) {
      result.pressure.emplace_back(x, -side(sample["traction"], which));
      result.shear.emplace_back(x, side(sample["shear"], which));
    }
  }
  return result;
}

void keep_below(Points& points, double most) {
  std::erase_if(points, [&](const auto& point) { return !(std::abs(point.second) < most); });
}

}  // namespace

TEST_CASE("the curves are the samples of the result, for every method") {
  const auto bumps = [](double x) { return (x * x - 1) * (x * x - 1) / 4; };
  const auto flat = [](double) { return 0.0; };
  struct Plotted {
    const char *file, *options;
    double (*psi)(double);
    std::size_t components;
    std::string texts;
  };
  const std::string of_bumps = "two_bumps.toml, load 0.1, sliding towards +x\nsteadyslide " STEADYSLIDE_VERSION
                               ", riemann-hilbert\n0.491\n0.563\n"
                               "contact\nuser's unit of length";
  const std::vector<Plotted> plots{{"two_bumps.toml", "", bumps, 2, of_bumps},
                                   {"two_bumps.toml", "--method variational --cells 512", bumps, 2, "variational"},
                                   {"two_bumps.toml", "--digits 30", bumps, 2, ""},
                                   {"two_coatings_backward.toml", "--certify", flat, 1,
                                    "closed-form\nsliding towards −x\n0.0471\nexponent\n, cut at 3"},
                                   {"three_jumps.toml", "", flat, 1, "−0.532\n−0.0894\n0.121\n−0.0628\n−0.437"}};
  for (const auto& [file, options, psi, components, texts] : plots) {
    CAPTURE(file);
    const TemporaryFolder folder;
    const std::string picture = (folder.path() / "p.svg").string();
    const Json solution = solve_example(file, joined(words(options), {"--samples", "400", "--plot", picture}));
    CHECK(folder.names() == std::vector<std::string>{"p.svg"});
    const std::string svg = folder.read("p.svg");
    CHECK(is_well_formed(svg));
    for (const std::string& text : lines(texts)) CHECK_MESSAGE(holds(shown_text(svg), text), text);

    PlottedPanel above(svg, 'a');
    const PlottedPanel below(svg, 'b');
    above.use_x_of(below);
    Sampled wanted = sampled(solution, psi);
    const std::string cut = ", cut at ";
    const std::size_t at = svg.find(cut);
    const double most = at == std::string::npos ? infinite : 0.99 * std::stod(svg.substr(at + cut.size()));
    keep_below(wanted.pressure, most);
    keep_below(wanted.shear, most);
    CHECK(wanted.pressure.size() > 600);
    CHECK(met(wanted.pressure, below.curve(1), below) == wanted.pressure.size());
    CHECK(met(wanted.shear, below.curve(2), below) == wanted.shear.size());
    // The upper panel ends beside the contact.
    const Points surface = above.curve(3);
    std::erase_if(wanted.surface, [&](const auto& point) {
      return point.first < surface.front().first || point.first > surface.back().first;
    });
    CHECK(met(wanted.surface, surface, above) == wanted.surface.size());

    const Points bars = above.curve(4);
    REQUIRE(bars.size() == 2 * components);
    for (std::size_t k = 0; k < components; ++k) {
      const Json& zone = solution["contact"][k];
      CHECK(std::abs(bars[2 * k].first - side(zone["left"]["x"], "")) <= above.tolerance_x());
      CHECK(std::abs(bars[2 * k + 1].first - side(zone["right"]["x"], "")) <= above.tolerance_x());
    }
    // The control: pressures that are larger by two thousandths are not in the picture.
    for (auto& [x, y] : wanted.pressure) y *= 1.002;
    CHECK(met(wanted.pressure, below.curve(1), below) < wanted.pressure.size() * 9 / 10);
  }
}

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

TEST_CASE("one picture shows both directions of sliding") {
  const TemporaryFolder folder;
  const std::string picture = (folder.path() / "p.svg").string();
  const Json solution = solve_example("two_bumps.toml", words("--both-directions --samples 400 --plot " + picture));
  const std::string svg = folder.read("p.svg");
  CHECK(is_well_formed(svg));
  check_holds(shown_text(svg), {"sliding towards +x and towards −x", "contact, towards −x", "shear t", ", towards −x"});
  const auto bumps = [](double x) { return (x * x - 1) * (x * x - 1) / 4; };
  const Points one = sampled(solution, bumps).pressure, other = sampled(solution["other_direction"], bumps).pressure;
  const PlottedPanel above(svg, 'b'), below(svg, 'c');
  CHECK(met(one, above.curve(1), above) == one.size());
  CHECK(met(other, below.curve(1), below) == other.size());
  CHECK(met(other, above.curve(1), above) < other.size() / 2);  // the control
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
    const std::size_t at = svg.find("id=\"solve_plot_1b\"");
    double low = infinite, high = -infinite;
    for (const auto& [x, y] : points_of(between(svg, " d='", "'", at))) {
      low = std::min(low, y);
      high = std::max(high, y);
    }
    CHECK(high - low > 100);
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
