#include "app/wear/wear_record.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/results/rows.hpp"
#include "library/text/number_format.hpp"

namespace steadyslide::app {
namespace {

using numeric::wear::WearProcess;
using numeric::wear::WearRow;

constexpr int shown_digits = 10;
constexpr std::size_t most_parts = 4096;

std::string number(double value, int digits = shown_digits) { return full_number(value, digits); }
std::string number_if_any(const std::optional<double>& value, int digits = shown_digits) {
  return value ? number(*value, digits) : "";
}

std::size_t cells_in_part(std::size_t cells) { return (cells + most_parts - 1) / most_parts; }

WornProfile profile_of(const WearProcess& process, const numeric::wear::WearState& state) {
  return {state.distance, means_over_parts(process.pressures(state)), means_over_parts(process.depths(state))};
}

}  // namespace

std::vector<double> means_over_parts(const std::vector<double>& cells) {
  const std::size_t step = cells_in_part(cells.size());
  std::vector<double> result;
  for (std::size_t i = 0; i < cells.size(); i += step) {
    const std::size_t end = std::min(i + step, cells.size());
    double sum = 0;
    for (std::size_t k = i; k < end; ++k) sum += cells[k];
    result.push_back(sum / static_cast<double>(end - i));
  }
  return result;
}

std::string wear_header() {
  return "distance,left,right,zones,effective_friction,centre_of_pressure,tilt,largest_pressure,wear_rate,wear_volume,"
         "from_run_in,step_error,failed_condition\n";
}

std::string wear_line(const WearRow& row) {
  const std::vector<std::string> cells{number(row.distance),
                                       number(row.left),
                                       number(row.right),
                                       fmt::format("{}", row.zones),
                                       number(row.effective_friction),
                                       number(row.centre_of_pressure),
                                       number_if_any(row.tilt),
                                       number(row.largest_pressure),
                                       number(row.wear_rate),
                                       number(row.wear_volume),
                                       number_if_any(row.from_run_in, 4),
                                       number(row.step_error, 2),
                                       csv_field(row.failed_condition)};
  return fmt::format("{}\n", fmt::join(cells, ","));
}

void WearRecord::add(const numeric::wear::WearRun& run) {
  rows += wear_line(run.row());
  state = run.state();
  step_error = run.row().step_error;
  if (profiles.empty() || (state.distance > 0 && state.distance >= 2 * profiles.back().distance)) {
    profiles.push_back(profile_of(run.process(), state));
  }
}

void WearRecord::add_last_profile(const WearProcess& process) {
  if (profiles.back().distance < state.distance) profiles.push_back(profile_of(process, state));
}

std::vector<double> profile_edges(const WearProcess& process) {
  const std::vector<double> cells = process.edges();
  const std::size_t step = cells_in_part(cells.size() - 1);
  std::vector<double> result;
  for (std::size_t i = 0; i + 1 < cells.size(); i += step) result.push_back(cells[i]);
  result.push_back(cells.back());
  return result;
}

std::string profile_table(const WearRecord& record, const std::vector<double>& edges) {
  std::string table = "distance,x,pressure,depth\n";
  for (const auto& [distance, pressure, depth] : record.profiles) {
    for (std::size_t i = 0; i < pressure.size(); ++i) {
      if (pressure[i] == 0 && depth[i] == 0) continue;
      table += fmt::format("{},{},{},{}\n", number(distance), number((edges[i] + edges[i + 1]) / 2),
                           number(pressure[i]), number(depth[i]));
    }
  }
  return table;
}

std::string bytes_of(const WearRecord& record, const std::string& title) {
  using nlohmann::json;
  const auto& [distance, next_step, depth, contact] = record.state;
  json all{{"rows", record.rows},
           {"steps", record.steps},
           {"step_error", record.step_error},
           {"state", {distance, next_step, depth, contact.pressure, contact.approach, contact.tilt}},
           {"profiles", json::array()}};
  for (const WornProfile& one : record.profiles) all["profiles"].push_back({one.distance, one.pressure, one.depth});
  std::string bytes = title;
  json::to_cbor(all, bytes);
  return bytes;
}

WearRecord record_of(const std::string& bytes, const std::string& title, const std::string& file) {
  if (!bytes.starts_with(title)) {
    throw Failure(ExitCode::bad_input,
                  fmt::format("{}:1: another run; --resume goes on with the same problem, options and version; {}",
                              file, excerpt(std::string_view(bytes).substr(0, bytes.find('\n')))));
  }
  try {
    const auto all = nlohmann::json::from_cbor(bytes.substr(title.size()));
    const auto& state = all.at("state");
    WearRecord record{all.at("rows"),
                      all.at("steps"),
                      all.at("step_error"),
                      {state.at(0), state.at(1), state.at(2), {state.at(3), state.at(4), state.at(5)}},
                      {}};
    for (const auto& one : all.at("profiles")) record.profiles.push_back({one.at(0), one.at(1), one.at(2)});
    return record;
  } catch (const nlohmann::json::exception&) {
    throw Failure(ExitCode::bad_input,
                  fmt::format("{}:2: not whole; remove it and start again; {} bytes", file, bytes.size()));
  }
}

}  // namespace steadyslide::app
