#pragma once
// A figure as data: the content of the drawing, not the way it is drawn. Numbers are in the units of the axis labels.
//
// Labels, legends and notes are in gnuplot's enhanced text: "{/:Italic t}_n" is an italic t with the index n. Title and
// name are plain text; captions have formulas between backticks in the notation of claims.

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace steadyslide::app {

/// Returns a plain text in gnuplot's enhanced text.
std::string enhanced(const std::string& plain);

struct Point {
  double x;
  double y;
};

/// Not a number: the curve is interrupted here.
inline constexpr Point gap_in_curve{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};

struct Axis {
  std::string label;
  double from;
  double to;
  bool logarithmic = false;
  double tics = 0;       ///< the distance of the tics; 0 for gnuplot's choice
  bool labelled = true;  ///< true: numbers at the tics

  Axis bare() const { return {"", from, to, logarithmic, tics, false}; }
};

/// The look of a curve. Bars are thick lines between points 1 and 2, 3 and 4, ...; a band is one thick line; an area is
/// the region inside the curve, in a light tint.
enum class Look { line, marks, bar, band, area };

struct Series {
  std::string legend;  ///< empty for none
  Look look;
  int style;  ///< colour, dashes and marks, from 1; different styles differ in all three
  std::vector<Point> points;
};

/// In the units of the axes or, as `of_panel_` sets it, as a fraction of the panel's width or height.
struct PanelPosition {
  double x;
  double y;
  bool of_panel_x = false;
  bool of_panel_y = false;
};

enum class Align { left, centre, right };

struct Note {
  PanelPosition at;
  std::string text;
  Align align = Align::left;
  int size = 14;
  bool boxed = false;  ///< on white, so that it is readable on a map
};

/// A thin line, or an arrow.
struct Guide {
  PanelPosition from;
  PanelPosition to;
  bool arrow = false;
};

/// A function on a grid, row after row. Values beyond `from` and `to` are drawn like these. If `from` is not negative,
/// colours get darker from there on; otherwise there are colours for two signs, and 0, in the middle, is white.
struct HeatMap {
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> values;
  double from;
  double to;
  std::string label;
  std::vector<double> contours;  ///< drawn as lines, with their values
};

/// `row_above` and `row_below` are rows outside of the axes, where they cover no curve.
enum class LegendAt { none, top_left, top_centre, top_right, right_of_centre, below, row_above, row_below };

/// The place of a panel's axes, as fractions of the figure's width and height.
struct Frame {
  double left, right, bottom, top;
};

struct Panel {
  Frame frame;
  Axis x;
  Axis y;
  std::vector<Series> series{};
  LegendAt legend = LegendAt::top_right;
  std::vector<Note> notes{};
  std::vector<Guide> guides{};
  std::optional<HeatMap> map{};
  bool bare = false;  ///< a sketch without axes
};

struct Figure {
  std::string name;
  std::string title;
  std::string caption;
  int height;  ///< the width is 800
  std::vector<Panel> panels;
  int digits = 7;        ///< digits of the numbers in the script: fewer than those in which two runs could differ
  std::string origin{};  ///< the command that made it; empty for the command `figures`

  std::string command() const { return origin.empty() ? "steadyslide figures --figure " + name : origin; }
  /// The name with _ for -: the beginning of the SVG's ids.
  std::string id_prefix() const;
};

}  // namespace steadyslide::app
