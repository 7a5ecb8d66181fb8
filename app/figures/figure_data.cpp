#include "app/figures/figure_data.hpp"

#include <fmt/format.h>

#include <boost/algorithm/string/replace.hpp>
#include <cmath>

#include "app/embedded.hpp"

namespace steadyslide::app {
namespace {

const char* name_of(Look look) {
  switch (look) {
    case Look::line: return "line";
    case Look::marks: return "marks";
    case Look::bar: return "bars from point to point, two by two";
    case Look::band: return "thick line";
    case Look::area: break;
  }
  return "boundary of an area";
}

class Data {
 public:
  std::string text(const Figure& figure) {
    line("# {} (steadyslide {}: {})", figure.title, version, figure.command());
    for (std::size_t k = 0; k < figure.panels.size(); ++k) describe(figure.panels[k], k + 1);
    line("panel,curve,x,y,value");
    for (std::size_t k = 0; k < figure.panels.size(); ++k) rows(figure.panels[k], k + 1);
    return std::move(text_);
  }

 private:
  template <class... T>
  void line(fmt::format_string<T...> format, T&&... values) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<T>(values)...);
    text_ += '\n';
  }

  static std::string unit_of(const Axis& axis, const char* otherwise) {
    return axis.label.empty() ? otherwise : plain_text(axis.label);
  }

  void describe(const Panel& panel, std::size_t k) {
    line("# panel {}: x is {}; y is {}", k, unit_of(panel.x, "as below"), unit_of(panel.y, "as x, upwards"));
    if (panel.map) line("# panel {}, curve 0: value is {}", k, plain_text(panel.map->label));
    std::string legend;
    for (std::size_t j = 0; j < panel.series.size(); ++j) {
      const Series& series = panel.series[j];
      // A curve without a legend takes the legend of the curve before it.
      if (!series.legend.empty()) legend = plain_text(series.legend);
      line("# panel {}, curve {}: {}{}", k, j + 1, name_of(series.look), legend.empty() ? "" : ", " + legend);
    }
  }

  void rows(const Panel& panel, std::size_t k) {
    if (panel.map) {
      const HeatMap& map = *panel.map;
      for (std::size_t i = 0; i < map.values.size(); ++i) {
        line("{},0,{},{},{}", k, map.x[i % map.x.size()], map.y[i / map.x.size()], map.values[i]);
      }
    }
    for (std::size_t j = 0; j < panel.series.size(); ++j) {
      for (const Point& point : panel.series[j].points) {
        if (!std::isnan(point.x)) line("{},{},{},{},", k, j + 1, point.x, point.y);
      }
    }
  }

  std::string text_;
};

}  // namespace

std::string figure_data(const Figure& figure) { return Data().text(figure); }

std::string plain_text(const std::string& enhanced) {
  std::string text = boost::replace_all_copy(enhanced, "{/:Italic ", "");
  std::erase_if(text, [](char c) { return c == '{' || c == '}'; });
  return text;
}

}  // namespace steadyslide::app
