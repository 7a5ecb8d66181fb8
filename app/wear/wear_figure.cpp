#include "app/wear/wear_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "app/embedded.hpp"
#include "library/text/one_line.hpp"

namespace steadyslide::app {
namespace {

constexpr std::size_t most_curves = 5;
constexpr std::size_t most_points = 400;
/// A pressure above this multiple of the mean one is cut: at first edges have infinite pressures.
constexpr double drawn_over_mean = 4;
constexpr int run_in_style = 3;
constexpr std::array curve_styles{2, 4, 5, 7, 1};

double largest(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }

/// Returns the profile before any wear, the last one, and others between them: evenly from the first one that has a
/// hundredth of the last depth.
std::vector<const WornProfile*> chosen(const std::vector<WornProfile>& all) {
  const double seen = largest(all.back().depth) / 100;
  std::vector<const WornProfile*> result{&all.front()};
  const auto first =
      std::ranges::find_if(all, [&](const WornProfile& one) { return one.distance > 0 && largest(one.depth) >= seen; });
  const auto rest = static_cast<std::size_t>(all.end() - first);
  const std::size_t count = std::min(most_curves - 1, rest);
  for (std::size_t k = 1; k <= count; ++k) result.push_back(&*(first + static_cast<long>(k * rest / count) - 1));
  return result;
}

/// A unit of length as a label shows it.
std::string length_label(const std::string& unit) {
  if (unit.empty()) return "user's unit of length";
  return unit == "um" ? "µm" : enhanced(unit);
}

/// The range of x, and the parts of the support in it.
struct DrawnRange {
  double from, to;
  std::size_t begin, end;
};

/// Returns the part of the support that ever had contact, with a margin.
DrawnRange drawn_range(const WearRecord& record, const std::vector<double>& edges) {
  std::size_t begin = edges.size() - 1, end = 0;
  for (const WornProfile& profile : record.profiles) {
    for (std::size_t i = 0; i < profile.pressure.size(); ++i) {
      if (profile.pressure[i] == 0 && profile.depth[i] == 0) continue;
      begin = std::min(begin, i);
      end = std::max(end, i + 1);
    }
  }
  const double margin = 0.04 * (edges[end] - edges[begin]);
  return {edges[begin] - margin, edges[end] + margin, begin, end};
}

std::vector<Point> curve(const std::vector<double>& values, const std::vector<double>& edges, const DrawnRange& range) {
  std::vector<Point> points;
  const std::size_t step = std::max<std::size_t>((range.end - range.begin) / most_points, 1);
  for (std::size_t i = range.begin; i < range.end; i += step)
    points.push_back({(edges[i] + edges[i + 1]) / 2, values[i]});
  return points;
}

}  // namespace

Figure wear_figure(const Problem& problem, const WearRecord& record, const std::vector<double>& edges,
                   const std::vector<double>& run_in) {
  const auto& [length, force] = problem.units;
  const std::string length_unit = length_label(length);
  const bool has_units = !length.empty() && !force.empty();
  const std::string stress_unit =
      has_units ? fmt::format("{}/{}²", enhanced(force), length_unit) : "user's unit of stress";
  const DrawnRange range = drawn_range(record, edges);
  const double mean = problem.contact.load().convert_to<double>() / (edges[range.end] - edges[range.begin]);

  Panel depth{{0.12, 0.98, 0.57, 0.86}, {"", range.from, range.to, false, 0, false}, {}};
  Panel pressure{{0.12, 0.98, 0.16, 0.5}, {"{/:Italic x}  (" + length_unit + ")", range.from, range.to}, {}};
  double deepest = 0, highest = run_in.empty() ? 0 : largest(run_in);
  const std::vector<const WornProfile*> drawn = chosen(record.profiles);
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    const WornProfile& profile = *drawn[k];
    const int style = curve_styles[k];
    deepest = std::max(deepest, largest(profile.depth));
    highest = std::max(highest, largest(profile.pressure));
    depth.series.push_back({fmt::format("{{/:Italic S}} = {:.3g}", profile.distance), Look::line, style,
                            curve(profile.depth, edges, range)});
    pressure.series.push_back({"", Look::line, style, curve(profile.pressure, edges, range)});
  }
  const bool is_cut = highest > drawn_over_mean * mean;
  if (is_cut) highest = drawn_over_mean * mean;
  if (!run_in.empty()) {
    pressure.series.push_back({"run-in pressure", Look::line, run_in_style, curve(run_in, edges, range)});
  }
  depth.y = {"worn depth  (" + length_unit + ")", 0, deepest > 0 ? 1.05 * deepest : 1};
  pressure.y = {fmt::format("pressure{}  ({})", is_cut ? ", cut" : "", stress_unit), 0, 1.05 * highest};
  depth.legend = LegendAt::row_above;
  pressure.legend = run_in.empty() ? LegendAt::none : LegendAt::row_below;

  const std::string name =
      problem.file == "-" ? "standard input" : one_line(std::filesystem::path(problem.file).filename().string());
  Figure figure{"wear",
                fmt::format("{}, worn over the sliding distance {:.6g}{}{}", name, record.state.distance,
                            length.empty() ? "" : " ", length),
                "Worn depth of the indenter and pressure after some sliding distances, and the run-in pressure.",
                680,
                {std::move(depth), std::move(pressure)}};
  figure.origin = fmt::format("steadyslide {}, wear", version);
  return figure;
}

}  // namespace steadyslide::app
