#include "app/results/solution_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <ranges>

#include "app/embedded.hpp"
#include "app/terminal/failure.hpp"
#include "numeric/periodic/repeated_contact.hpp"
#include "numeric/variational/cell_data.hpp"

namespace steadyslide::app {
namespace {

/// If there are more components, only their bars are drawn, and free ends have no mark.
constexpr std::size_t most_marked_components = 4;
/// Breaks of a trace are drawn up to this number; more cannot be seen.
constexpr std::size_t most_drawn_breaks = 20000;
constexpr double largest_over_mean = 6;
/// The place of the contact among the curves of the upper panel; the surface is before it.
constexpr std::size_t contact_series = 3;
/// The rows of exponents above the tractions and of friction values on the indenter, their distance as a fraction of the
/// panel's height, and the width of a character as a fraction of the panel's width.
constexpr std::size_t exponent_rows = 3, friction_rows = 2;
constexpr double row_height = 0.072, character_width = 0.0125;

struct ValueRange {
  double from = std::numeric_limits<double>::infinity();
  double to = -std::numeric_limits<double>::infinity();

  void include(double value) {
    from = std::min(from, value);
    to = std::max(to, value);
  }
  bool holds(double value) const { return value >= from && value <= to; }
  double length() const { return to - from; }
};

/// The number in a result's text; NaN if it is empty.
double value_of(const std::string& text) {
  return text.empty() ? std::numeric_limits<double>::quiet_NaN() : std::strtod(text.c_str(), nullptr);
}

double value_of(const Rational& value) { return value.convert_to<double>(); }

std::string with_minus(const std::string& text) { return text.starts_with('-') ? "−" + text.substr(1) : text; }

std::string towards(const Problem& problem) {
  return problem.contact.sliding() == Sliding::plus_x ? "towards +x" : "towards −x";
}

std::string shown_name(const Problem& problem) {
  if (problem.file == "-") return "standard input";
  return one_line(std::filesystem::path(problem.file).filename().string());
}

/// Short labels along x. A label that would touch another one goes into the next row.
class LabelRows {
 public:
  explicit LabelRows(std::size_t rows) : taken_(rows, -1) {}

  /// Returns the row of a label at a place between 0 and 1, or nothing if no row has room for it.
  std::optional<std::size_t> place(double at, std::size_t characters) {
    const double half = character_width * static_cast<double>(characters) / 2;
    const auto row = std::ranges::find_if(taken_, [&](double end) { return end < at - half; });
    if (row == taken_.end()) return std::nullopt;
    *row = at + half;
    return static_cast<std::size_t>(row - taken_.begin());
  }

 private:
  std::vector<double> taken_;
};

class SolutionFigure {
 public:
  /// The range of x has the contact of `also`, too.
  SolutionFigure(const Problem& problem, const SolutionText& solution, const SolutionText& also)
      : problem_(problem), solution_(solution) {
    for (const auto& [left, right] : solution.contact) {
      contact_length_ += value_of(right.x.value) - value_of(left.x.value);
    }
    for (const SolutionText* one : {&solution, &also}) {
      for (const auto& [left, right] : one->contact) {
        contact_.include(value_of(left.x.value));
        contact_.include(value_of(right.x.value));
      }
    }
    const auto& [length, force] = problem.units;
    if (!length.empty()) length_unit_ = length == "um" ? "µm" : enhanced(length);
    if (!length.empty() && !force.empty()) {
      load_unit_ = fmt::format(" {}/{}", force, length);
      stress_unit_ = fmt::format("{}/{}²", enhanced(force), length_unit_);
    }
    const Indenter& shape = problem.contact.indenter();
    ValueRange drawn{value_of(shape.left()), value_of(shape.right())};
    // Repeated contact may lie across an end of the support.
    if (contact_.from < drawn.from || contact_.to > drawn.to) {
      drawn = {};
      for (const SolutionText* one : {&solution, &also}) {
        for (const SampleText& sample : one->curve) drawn.include(value_of(sample.x));
      }
    }
    const double margin = 0.6 * contact_.length(), beside = 0.04 * contact_.length();
    x_ = {std::max(drawn.from - beside, contact_.from - margin), std::min(drawn.to + beside, contact_.to + margin)};
  }

  Figure figure() {
    Figure figure{"solve", title(), caption(), 680, {}};
    figure.digits = 15;
    figure.origin = fmt::format("steadyslide {}, {}", version, solution_.method);
    Panel below = tractions();
    mark(below);
    Panel above = shapes(below.guides);
    name_friction(above, below.x.label);
    figure.panels = {std::move(above), std::move(below)};
    return figure;
  }

 private:
  std::string title() const {
    const ContactProblem& contact = problem_.contact;
    return fmt::format("{}{}, load {:.6g}{}, sliding {}",
                       solution_.failed_condition.empty() ? "" : "NOT SOLVED: ", shown_name(problem_),
                       value_of(contact.load()), load_unit_, towards(problem_));
  }

  std::string caption() const {
    const std::string what =
        "Indenter with its friction values, surface and contact zones; pressure and tangential traction, with the "
        "exponents of singular points.";
    return solution_.failed_condition.empty() ? what : what + " Not solved: " + solution_.failed_condition + ".";
  }

  Axis across(bool labelled) const {
    return {labelled ? "{/:Italic x}  (" + length_unit_ + ")" : "", x_.from, x_.to, false, 0, labelled};
  }

  /// psi plus the tilt, on one side of x.
  double height(const Rational& x, Side side) const {
    const double tilted = solution_.resultants.tilt ? value_of(solution_.resultants.tilt->value) * value_of(x) : 0;
    const Indenter& indenter = problem_.contact.indenter();
    const double waves = numeric::variational::harmonic_sum(problem_.contact, x).height;
    const std::optional<Rational>& period = problem_.contact.body().period();
    const bool beyond = period && (x < indenter.left() || x > indenter.right());
    const Rational place = beyond ? numeric::moved_into(x, indenter.left(), *period) : x;
    return value_of(indenter.profile(place, side)(place)) + waves + tilted;
  }

  Panel shapes(std::vector<Guide> guides) const {
    Series profile{solution_.resultants.tilt ? "indenter ψ, tilted" : "indenter ψ", Look::line, 2, {}};
    Series surface{"surface {/:Italic u} + {/:Italic C}", Look::line, 1, {}};
    for (const SampleText& sample : solution_.curve) {
      const Rational x = parse_rational(sample.x);
      if (!x_.holds(value_of(x))) continue;
      const double left = height(x, Side::left), right = height(x, Side::right);
      profile.points.push_back({value_of(x), left});
      // At a step the gap belongs to one side only.
      if (left == right) surface.points.push_back({value_of(x), left - value_of(sample.gap.value)});
    }
    add_breaks(profile.points);
    ValueRange y;
    for (const Series* series : {&profile, &surface}) {
      for (const Point& point : series->points) {
        if (!std::isnan(point.y)) y.include(point.y);
      }
    }
    // The panel of a flat punch is as tall as a part of the contact's length.
    const double tall = y.length() == 0 ? 0.1 * contact_.length() : y.length();
    Panel panel{{0.12, 0.98, 0.594, 0.918},
                across(false),
                {"height  (" + length_unit_ + ")", y.from - 0.15 * tall, y.to + 0.25 * tall}};
    Series indenter{"", Look::area, 6, profile.points};
    if (!profile.points.empty()) {
      indenter.points.push_back({profile.points.back().x, panel.y.to});
      indenter.points.push_back({profile.points.front().x, panel.y.to});
    }
    panel.series = {std::move(indenter), std::move(profile), std::move(surface), zones(y.from - 0.08 * tall)};
    panel.legend = LegendAt::row_above;
    panel.guides = std::move(guides);
    return panel;
  }

  /// Adds the corners of the profile, from the left and from the right, to its points.
  void add_breaks(std::vector<Point>& points) const {
    const Indenter& shape = problem_.contact.indenter();
    if (shape.pieces().size() > most_drawn_breaks) return;
    for (const Indenter::Piece& piece : shape.pieces()) {
      const double x = value_of(piece.to);
      if (!x_.holds(x) || piece.to == shape.right()) continue;
      points.push_back({x, height(piece.to, Side::left)});
      points.push_back({x, height(piece.to, Side::right)});
    }
    std::ranges::stable_sort(points, {}, &Point::x);
  }

  Series zones(double y) const {
    Series zones{"contact", Look::bar, 3, {}};
    for (const auto& [left, right] : solution_.contact) {
      for (const double x : {value_of(left.x.value), value_of(right.x.value)}) zones.points.push_back({x, y});
    }
    return zones;
  }

  Panel tractions() {
    Series pressure{"pressure −{/:Italic t}_n", Look::line, 1, {}};
    Series shear{"shear {/:Italic t}_t", Look::line, 2, {}};
    bool in_contact = false;
    for (const SampleText& sample : solution_.curve) {
      const bool open = value_of(sample.gap.value) > 0 && value_of(sample.traction.left.value) == 0;
      for (Series* series : {&pressure, &shear}) {
        if (open && in_contact) series->points.push_back(gap_in_curve);
      }
      in_contact = !open;
      if (open) continue;
      const double x = value_of(sample.x);
      add(pressure.points, x, -value_of(sample.traction.left.value), -value_of(sample.traction.right.value));
      add(shear.points, x, value_of(sample.shear.left.value), value_of(sample.shear.right.value));
    }
    const ValueRange y = traction_range(pressure.points, shear.points);
    if (is_infinite()) pressure.legend += fmt::format(", cut at {:.3g}", y.to);
    Panel panel{{0.12, 0.98, 0.165, 0.512}, across(true), {"traction  (" + stress_unit_ + ")", y.from, y.to}};
    panel.series = {std::move(pressure), std::move(shear)};
    panel.legend = LegendAt::row_below;
    return panel;
  }

  /// True if the pressure is infinite at some place.
  bool is_infinite() const { return std::ranges::any_of(solution_.singular_points, &SingularText::infinite); }

  /// Leaves out an infinite limit: the curve leaves the frame.
  void add(std::vector<Point>& points, double x, double left, double right) {
    if (std::isfinite(left)) points.push_back({x, left});
    if (std::isfinite(right) && right != left) points.push_back({x, right});
  }

  ValueRange traction_range(const std::vector<Point>& pressure, const std::vector<Point>& shear) const {
    ValueRange y{0, 0};
    for (const Point& point : pressure) {
      if (!std::isnan(point.y)) y.include(point.y);
    }
    const double mean = value_of(problem_.contact.load()) / contact_length_;
    if (is_infinite()) y.to = std::min(y.to, largest_over_mean * mean);
    double least = 0;
    for (const Point& point : shear) {
      if (!std::isnan(point.y)) least = std::min(least, point.y);
    }
    return {std::max(1.08 * least, -y.to), is_infinite() ? y.to : 1.08 * y.to};
  }

  /// Draws a line at each singular point and, if there is room, its exponent.
  void mark(Panel& panel) {
    const bool free_ends = solution_.contact.size() <= most_marked_components;
    LabelRows rows(exponent_rows);
    std::size_t without = 0;
    for (const SingularText& point : solution_.singular_points) {
      if (!free_ends && point.kind == "free") continue;
      const double x = value_of(point.x.value);
      panel.guides.push_back({{x, 0, false, true}, {x, 1, false, true}});
      const double value = value_of(point.exponent.value);
      const std::string text = value != 0 ? with_minus(fmt::format("{:.3g}", value)) : point.exponent.value;
      if (const auto row = rows.place((x - x_.from) / x_.length(), text.size())) {
        panel.notes.push_back({{x, 1.05 + row_height * static_cast<double>(*row), false, true}, text, Align::centre});
      } else {
        ++without;
      }
    }
    if (panel.notes.empty()) return;
    panel.notes.push_back({{-0.01, 1.05, true, true}, "exponent", Align::right});
    if (without > 0) panel.x.label += fmt::format("; {} exponents more are in the results", without);
  }

  /// Writes the friction values on the indenter, and draws a line between two of them. `results` is the label that says
  /// how many found no room.
  void name_friction(Panel& panel, std::string& results) const {
    const ContactProblem& contact = problem_.contact;
    const std::vector<Rational>& jumps = contact.friction().jumps();
    const Indenter& shape = contact.indenter();
    LabelRows rows(friction_rows);
    Series lines{"", Look::line, 6, {}};
    std::size_t without = 0;
    for (std::size_t k = 0; k < contact.friction().values().size(); ++k) {
      const double left = std::max(x_.from, value_of(k == 0 ? shape.left() : jumps[k - 1]));
      const double right = std::min(x_.to, value_of(k == jumps.size() ? shape.right() : jumps[k]));
      if (left >= right) continue;
      const double x = (left + right) / 2;
      const std::string value = fmt::format("{:.3g}", value_of(contact.friction().values()[k]));
      // "f = " stands before the first one.
      const bool first = panel.notes.empty();
      const auto row = rows.place((x - x_.from) / x_.length(), value.size() + (first ? 4 : 0));
      if (!row) {
        ++without;
        continue;
      }
      panel.notes.push_back({{x, 0.94 - row_height * static_cast<double>(*row), false, true},
                             (first ? "{/:Italic f} = " : "") + value,
                             Align::centre});
      if (k < jumps.size() && right < x_.to) {
        const double foot = height(jumps[k], Side::left);
        lines.points.insert(lines.points.end(), {{right, foot}, {right, panel.y.to}, gap_in_curve});
      }
    }
    if (!lines.points.empty()) panel.series.push_back(std::move(lines));
    if (without > 0) results += fmt::format("; {} friction values more are in the results", without);
  }

  const Problem& problem_;
  const SolutionText& solution_;
  std::string length_unit_ = "user's unit of length";
  std::string stress_unit_ = "user's unit of stress";
  std::string load_unit_;
  ValueRange contact_, x_;
  double contact_length_ = 0;
};

}  // namespace

Figure solution_figure(const Problem& problem, const SolutionText& solution) {
  return SolutionFigure(problem, solution, solution).figure();
}

Figure solution_figure(const Problem& problem, const Problem& turned, const BothText& both) {
  Figure figure = SolutionFigure(problem, both.as_given, both.opposite).figure();
  Figure other = SolutionFigure(turned, both.opposite, both.as_given).figure();
  const std::string way = towards(problem), other_way = towards(turned);
  figure.title += fmt::format(" and {}", other_way);
  figure.origin += ", --both-directions";

  Panel& shapes = figure.panels.front();
  const double lower = 0.035 * (shapes.y.to - shapes.y.from);
  Series zones = std::move(other.panels.front().series.at(contact_series));
  for (Point& end : zones.points) end.y = shapes.series.at(contact_series).points.front().y - lower;
  zones.style = 4;
  zones.legend += ", " + other_way;
  for (const std::size_t k : {contact_series - 1, contact_series}) shapes.series.at(k).legend += ", " + way;
  shapes.series.push_back(std::move(zones));
  for (Series& series : figure.panels.back().series) series.legend += ", " + way;
  for (Series& series : other.panels.back().series) series.legend += ", " + other_way;

  // The height of the other tractions with their exponents and legend, and of a second row of the legend above.
  constexpr int more = 390, second_row = 28;
  const double height = figure.height, whole = height + more + second_row;
  const auto place = [&](Frame& frame, double up) {
    frame.bottom = (height * frame.bottom + up) / whole;
    frame.top = (height * frame.top + up) / whole;
  };
  for (Panel& panel : figure.panels) place(panel.frame, more);
  place(other.panels.back().frame, 0);
  figure.panels.push_back(std::move(other.panels.back()));
  figure.height = static_cast<int>(whole);
  return figure;
}

}  // namespace steadyslide::app
