#include "app/gnuplot/gnuplot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/replace.hpp>
#include <cmath>

namespace steadyslide::app {

namespace {

constexpr int width = 800;
/// In pixels: the distance of a legend from the axes above it and below it, with their numbers and label.
constexpr double legend_row = 4, axis_labels = 60;

/// Colours of Okabe and Ito: they stay distinct for the colour-blind and in grey print. Each has its own dashes, mark
/// and tint for areas.
struct Style {
  const char* colour;
  const char* dashes;
  int mark;
  const char* tint;
};
constexpr std::array<Style, 8> styles{{{"#0072b2", "1", 6, "#dfeaf3"},
                                       {"#d55e00", "(12,4)", 4, "#f9e3d3"},
                                       {"#000000", "(3,3)", 8, "#cfcac4"},
                                       {"#009e73", "(12,4,3,4)", 10, "#d5efe7"},
                                       {"#aa4499", "(7,3)", 12, "#f0dcec"},
                                       {"#808080", "(2,4)", 2, "#eeeeee"},
                                       {"#56b4e9", "(9,2,3,2)", 14, "#e6f3fb"},
                                       {"#ffffff", "1", 2, "#ffffff"}}};

constexpr auto darker = "0 '#ffffe5', 0.15 '#fff7bc', 0.3 '#fec44f', 0.5 '#ec7014', 0.75 '#8c2d04', 1 '#3b0f02'";
constexpr auto two_signs = "0 '#b35806', 0.25 '#f1a340', 0.5 '#ffffff', 0.75 '#998ec3', 1 '#542788'";

/// A text in the single quotes of gnuplot.
std::string quoted(const std::string& text) { return "'" + boost::replace_all_copy(text, "'", "''") + "'"; }

const char* text_of(Align align) { return align == Align::left ? "left" : align == Align::centre ? "center" : "right"; }

std::string text_of(const Series& series) {
  const Style& style = styles.at(static_cast<std::size_t>(series.style - 1));
  switch (series.look) {
    case Look::line: return fmt::format("lines lc rgb '{}' lw 2 dt {}", style.colour, style.dashes);
    case Look::bar: return fmt::format("vectors nohead lc rgb '{}' lw 6", style.colour);
    case Look::band: return fmt::format("lines lc rgb '{}' lw 7 dt 1", style.colour);
    case Look::area: return fmt::format("filledcurves closed fs solid noborder lc rgb '{}'", style.tint);
    case Look::marks: break;
  }
  return fmt::format("points lc rgb '{}' lw 1.5 pt {} ps 0.7", style.colour, style.mark);
}

class Script {
 public:
  Script(const Figure& figure, Picture picture) : figure_(figure), picture_(picture) {}

  std::string text() {
    line("set encoding utf8");
    line("set minussign");
    line("set terminal {}", terminal());
    line("set multiplot");
    line("set style textbox opaque noborder fillcolor rgb '#ffffff' margins 0.3,0.1");
    line("set tics scale 0.7,0.35");
    line("set grid back lw 0.5 lc rgb '#d8d8d8' dt 1");
    for (std::size_t k = 0; k < figure_.panels.size(); ++k) panel(figure_.panels[k], k);
    line("unset multiplot");
    return std::move(text_);
  }

 private:
  template <class... T>
  void line(fmt::format_string<T...> format, T&&... values) {
    text_ += fmt::format(format, std::forward<T>(values)...) + "\n";
  }

  std::string terminal() const {
    const int height = figure_.height;
    switch (picture_) {
      case Picture::pdf:
        return fmt::format("pdfcairo size {},{} enhanced font 'Helvetica,15' fontscale 0.567 background 'white' lw 0.6",
                           centimetres(width), centimetres(height));
      case Picture::png:
        return fmt::format(
            "pngcairo size {},{} enhanced font 'Helvetica,15' fontscale 1.5 background 'white' lw 2 pointscale 2",
            2 * width, 2 * height);
      case Picture::svg: break;
    }
    return fmt::format("svg size {},{} fixed enhanced font 'Helvetica,15' background 'white' name {} standalone", width,
                       height, quoted(figure_.id_prefix()));
  }

  static std::string centimetres(int units) { return fmt::format("{}cm", units / 50.0); }

  std::string number(double value) const { return fmt::format("{:.{}g}", value, figure_.digits); }
  std::string coordinate(double value, bool of_panel) const { return (of_panel ? "graph " : "first ") + number(value); }
  std::string place_text(const PanelPosition& place) const {
    return coordinate(place.x, place.of_panel_x) + ", " + coordinate(place.y, place.of_panel_y);
  }

  void axis(char name, const Axis& axis) {
    line("set {}label {} offset {}", name, quoted(axis.label), name == 'x' ? "0,0.3" : "0.8,0");
    line("set {}range [{}:{}]", name, number(axis.from), number(axis.to));
    line("{} logscale {}", axis.logarithmic ? "set" : "unset", name);
    // Tics at powers of ten, far enough apart that their numbers do not touch.
    const double decades = axis.logarithmic ? std::log10(std::abs(axis.to / axis.from)) : 0;
    const bool by_tens = decades > 1.5 && decades < 24;
    std::string tics = axis.tics == 0 ? "autofreq" : number(axis.tics);
    if (by_tens) {
      const double first = std::pow(10, std::ceil(std::log10(std::min(axis.from, axis.to)) - 1e-9));
      tics = fmt::format("{}, {}", number(first), decades > 6 ? 100 : 10);
    }
    line("set {}tics {}", name, tics);
    line("set format {} '{}'", name, !axis.labelled ? "" : decades > 1.5 ? "10^{%T}" : "%g");
    const bool finer = by_tens && decades <= 6;
    line("{} m{}tics{}", finer ? "set" : "unset", name, finer ? " default" : "");
  }

  void panel(const Panel& panel, std::size_t k) {
    line("set lmargin at screen {}", number(panel.frame.left));
    line("set rmargin at screen {}", number(panel.frame.right));
    line("set bmargin at screen {}", number(panel.frame.bottom));
    line("set tmargin at screen {}", number(panel.frame.top));
    axis('x', panel.x);
    axis('y', panel.y);
    line("{}", panel.bare ? "unset border; unset xtics; unset ytics" : "set border 15 lw 0.8");
    line("set key {} Left reverse samplen 3.2 spacing 1.15 width 0 font ',14'", legend_place(panel));
    if (panel.legend == LegendAt::none) line("unset key");
    for (const Note& note : panel.notes) {
      line("set label {} at {} {} front font ',{}'{}", quoted(note.text), place_text(note.at), text_of(note.align),
           note.size, note.boxed ? " boxed" : "");
    }
    for (const Guide& guide : panel.guides) {
      line("set arrow from {} to {} {}", place_text(guide.from), place_text(guide.to),
           guide.arrow  ? "head filled size screen 0.012,20 front lw 1.5 lc rgb '#202020'"
           : panel.bare ? "nohead front lw 1 dt (4,3) lc rgb '#606060'"
                        : "nohead back lw 1 dt (4,3) lc rgb '#606060'");
    }
    if (k == 0) {
      line("set label {} at screen 0.5, screen {} center font ',16'", quoted(enhanced(figure_.title)),
           number(1 - 18.0 / figure_.height));
      line("set label {} at screen 0.995, screen {} right front font ',10' textcolor rgb '#808080'",
           quoted(enhanced(figure_.command())), number(9.0 / figure_.height));
    }
    std::vector<std::string> plots;
    if (panel.map) map(*panel.map, panel.frame, k, plots);
    for (std::size_t j = 0; j < panel.series.size(); ++j) {
      const Series& series = panel.series[j];
      const std::string name = fmt::format("$series_{}_{}", k, j);
      data(name, series);
      const char* columns = series.look == Look::bar ? "1:2:($3-$1):($4-$2)" : "1:2";
      plots.push_back(fmt::format("{} using {} with {} {}", name, columns, text_of(series),
                                  series.legend.empty() ? "notitle" : "title " + quoted(series.legend)));
    }
    line("plot {}", fmt::join(plots, ", "));
    line("unset label");
    line("unset arrow");
  }

  std::string legend_place(const Panel& panel) const {
    switch (panel.legend) {
      case LegendAt::none: return "off";
      case LegendAt::top_left: return "inside top left";
      case LegendAt::top_centre: return "inside top center";
      case LegendAt::top_right: return "inside top right";
      case LegendAt::right_of_centre: return "at graph 0.56, graph 0.97 left top";
      case LegendAt::row_above: return row_at(panel.frame, panel.frame.top + legend_row / figure_.height, "bottom");
      case LegendAt::row_below: return row_at(panel.frame, panel.frame.bottom - axis_labels / figure_.height, "top");
      case LegendAt::below: break;
    }
    // Below the label of the axis.
    return fmt::format("at screen {}, screen {} left top", number(panel.frame.left - 0.06),
                       number(panel.frame.bottom - 64.0 / figure_.height));
  }

  std::string row_at(const Frame& frame, double y, const char* align) const {
    return fmt::format("at screen {}, screen {} center {} horizontal", number((frame.left + frame.right) / 2),
                       number(y), align);
  }

  void data(const std::string& name, const Series& series) {
    line("{} << END", name);
    for (std::size_t i = 0; i < series.points.size(); ++i) {
      const Point& point = series.points[i];
      const bool is_first_of_two = series.look == Look::bar && i % 2 == 0;
      text_ += std::isnan(point.x) ? "" : number(point.x) + " " + number(point.y);
      text_ += is_first_of_two ? " " : "\n";
    }
    line("END");
  }

  void map(const HeatMap& map, const Frame& frame, std::size_t k, std::vector<std::string>& plots) {
    line("$map_{} << END", k);
    for (std::size_t j = 0; j < map.y.size(); ++j) {
      for (std::size_t i = 0; i < map.x.size(); ++i) {
        line("{} {} {}", number(map.x[i]), number(map.y[j]), number(map.values[j * map.x.size() + i]));
      }
      line("");
    }
    line("END");
    line("set palette defined ({})", map.from < 0 ? two_signs : darker);
    line("set cbrange [{}:{}]", number(map.from), number(map.to));
    line("set cblabel {} offset {},0", quoted(map.label), map.from < 0 ? 1.5 : -0.5);
    line("set colorbox user origin screen {}, graph 0 size screen 0.02, graph 1", number(frame.right + 0.02));
    plots.push_back(fmt::format("$map_{} using 1:2:3 with image notitle", k));
    if (map.contours.empty()) return;
    std::vector<std::string> levels;
    for (const double level : map.contours) levels.push_back(number(level));
    // The lines of the contours, as data: `splot` makes them, `plot` draws them over the colours.
    line("set contour base");
    line("set cntrparam levels discrete {}", fmt::join(levels, ", "));
    line("unset surface");
    line("set table $contours_{}", k);
    line("splot $map_{} using 1:2:3", k);
    line("unset table");
    line("unset contour");
    line("set surface");
    plots.push_back(fmt::format("$contours_{} using 1:2 with lines lw 0.8 lc rgb '#404040' dt 1 notitle", k));
    // A label stands at the 46th point of each part of a contour. Short contours have no label.
    plots.push_back(
        fmt::format("$contours_{} using 1:2:(gprintf('%g', $3)) every 10000::45 "
                    "with labels boxed font ',11' notitle",
                    k));
  }

  const Figure& figure_;
  Picture picture_;
  std::string text_;
};

}  // namespace

std::string enhanced(const std::string& plain) {
  std::string result;
  for (const char c : plain)
    result += std::string("_^{}@&~\\").find(c) == std::string::npos ? std::string(1, c) : std::string("\\") + c;
  return result;
}

std::string gnuplot_script(const Figure& figure, Picture picture) { return Script(figure, picture).text(); }

}  // namespace steadyslide::app
