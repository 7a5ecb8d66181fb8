#include "proofs_checks/proof/box.hpp"

#include <algorithm>
#include <boost/algorithm/string/trim.hpp>
#include <set>
#include <stdexcept>
#include <vector>

#include "model/invalid_data.hpp"
#include "proofs_checks/proof/markdown.hpp"

namespace steadyslide::proofs_checks {
namespace {

const Interval& along(const Box& box, const std::string& parameter) {
  static const Interval any;
  const auto found = box.find(parameter);
  return found == box.end() ? any : found->second;
}

using ParameterPoint = std::map<std::string, Rational>;

bool contains(const Box& box, const ParameterPoint& place) {
  return std::ranges::all_of(place, [&](const auto& p) { return along(box, p.first).contains(p.second); });
}

/// Returns one number from each interval into which the ends divide the line, and the ends themselves.
std::vector<Rational> samples(const std::set<Rational>& ends) {
  if (ends.empty()) return {0};
  std::vector<Rational> all{Rational(*ends.begin() - 1)};
  for (auto end = ends.begin(); end != ends.end(); ++end) {
    all.push_back(*end);
    const auto next = std::next(end);
    all.push_back(next == ends.end() ? Rational(*end + 1) : Rational((*end + *next) / 2));
  }
  return all;
}

}  // namespace

bool Interval::contains(const Rational& x) const {
  const bool above = !from || x > *from || (with_from && x == *from);
  const bool below = !to || x < *to || (with_to && x == *to);
  return above && below;
}

Interval parse_interval(std::string_view text) {
  const auto refuse = [&] { throw std::logic_error("not an interval, [a, b[: " + std::string(text)); };
  const std::size_t comma = text.find(',');
  if (text.size() < 5 || comma == std::string_view::npos) refuse();
  const char opens = text.front();
  const char closes = text.back();
  if ((opens != '[' && opens != ']') || (closes != '[' && closes != ']')) refuse();
  std::string from(text.substr(1, comma - 1)), to(text.substr(comma + 1, text.size() - comma - 2));
  boost::algorithm::trim(from);
  boost::algorithm::trim(to);
  Interval result{std::nullopt, std::nullopt, opens == '[', closes == ']'};
  try {
    if (from != "-oo") result.from = parse_rational(from);
    if (to != "oo") result.to = parse_rational(to);
  } catch (const InvalidData&) {
    refuse();
  }
  if ((!result.from && result.with_from) || (!result.to && result.with_to)) refuse();
  if (result.from && result.to &&
      (*result.from > *result.to || (*result.from == *result.to && !result.contains(*result.from))))
    refuse();
  return result;
}

Box parse_box(std::string_view text) {
  Box box;
  for (const std::string& item : items_of(text)) {
    const std::size_t in = item.find(" in ");
    if (in == std::string::npos) throw std::logic_error("not a parameter's range, \"s in [0, 1]\": " + item);
    box[item.substr(0, in)] = parse_interval(item.substr(in + 4));
  }
  return box;
}

std::string text_of(const Interval& i) {
  return (i.with_from ? "[" : "]") + (i.from ? to_string(*i.from) : "-oo") + ", " + (i.to ? to_string(*i.to) : "oo") +
         (i.with_to ? "]" : "[");
}

std::string text_of(const Box& box) {
  std::string text;
  for (const auto& [name, interval] : box) text += (text.empty() ? "" : ", ") + name + " in " + text_of(interval);
  return text;
}

bool covers(std::span<const Box> boxes, const Box& whole) {
  std::map<std::string, std::set<Rational>> ends;
  const auto add = [&](const Box& box) {
    for (const auto& [name, interval] : box) {
      std::set<Rational>& all = ends[name];
      if (interval.from) all.insert(*interval.from);
      if (interval.to) all.insert(*interval.to);
    }
  };
  add(whole);
  for (const Box& box : boxes) add(box);
  std::vector<ParameterPoint> places(1);
  for (const auto& [name, along_axis] : ends) {
    std::vector<ParameterPoint> more;
    for (const ParameterPoint& place : places) {
      for (const Rational& x : samples(along_axis)) {
        more.push_back(place);
        more.back()[name] = x;
      }
    }
    places = std::move(more);
  }
  return std::ranges::all_of(places, [&](const ParameterPoint& place) {
    return !contains(whole, place) || std::ranges::any_of(boxes, [&](const Box& box) { return contains(box, place); });
  });
}

}  // namespace steadyslide::proofs_checks
