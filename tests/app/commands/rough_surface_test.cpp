// The measured profile among the examples is the output of its generator, and has the properties in its description.

#include "app/json_answers.hpp"

namespace {

/// Returns the numbers of a trace's lines after its header.
std::vector<double> numbers(const std::string& trace) {
  std::vector<double> result;
  for (const std::string& text : lines(trace.substr(trace.find("x,psi\n") + 6))) {
    std::size_t comma = 0;
    result.push_back(std::stod(text, &comma));
    result.push_back(std::stod(text.substr(comma + 1)));
  }
  return result;
}

std::string stored_trace() { return file_text(STEADYSLIDE_EXAMPLES "/rough_surface.csv"); }

/// Returns infinity for traces of different lengths.
double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return HUGE_VAL;
  double largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}

/// The largest relative violation of |shear| = f |traction| on a side of x, and the number of rows in contact.
struct Coulomb {
  double worst = 0;
  int rows = 0;

  void add(double x, bool is_left, double traction, double shear) {
    if (traction == 0 || std::isinf(traction)) return;
    const double f = x < 0 || (x == 0 && is_left) ? 0.1 : 0.4;
    worst = std::max(worst, std::abs(std::abs(shear) / (f * std::abs(traction)) - 1));
    ++rows;
  }
};

}  // namespace

TEST_CASE("the stored rough surface is the output of its generator") {
  const std::string stored = stored_trace();
  const auto generated = [](const Arguments& parameters) {
    return run_other(joined({STEADYSLIDE_ROUGH_SURFACE}, parameters), STEADYSLIDE_EXAMPLES);
  };
  const Finished same = generated({});
  CHECK(same.code == 0);
  CHECK(lines(same.out)[0] == lines(stored)[0]);
  CHECK(numbers(stored).size() == 2 * 4001);
  CHECK(largest_difference(numbers(same.out), numbers(stored)) <= 1e-9);
  for (const char* other : {"seed=2", "rms=0.00301", "hurst=0.81", "radius=8.01", "points=4000"}) {
    CHECK(largest_difference(numbers(generated({other}).out), numbers(stored)) > 1e-6);
  }
  for (const char* bad : {"sead=2", "rms", "rms=", "rms=-1", "rms=nan", "longest=5", "points=1"}) {
    CAPTURE(bad);
    const Finished refused = generated({bad});
    CHECK(refused.code == 2);
    CHECK(refused.out == "");
    CHECK(times(refused.err, "\n") == 1);
  }
}

TEST_CASE("the rough surface has the requested roughness and wavelengths") {
  const std::vector<double> trace = numbers(stored_trace());
  const std::size_t intervals = trace.size() / 2 - 1;
  // One period: the last point equals the first one.
  double power = 0;
  std::vector<double> amplitude(300, 0);
  for (std::size_t wave = 0; wave < amplitude.size(); ++wave) {
    double cosine = 0, sine = 0;
    for (std::size_t i = 0; i < intervals; ++i) {
      const double x = trace[2 * i], rough = trace[2 * i + 1] - x * x / 16;
      const double angle = std::numbers::pi * static_cast<double>(wave) * x;
      cosine += rough * std::cos(angle);
      sine += rough * std::sin(angle);
      if (wave == 0) power += rough * rough;
    }
    amplitude[wave] = 2 * std::hypot(cosine, sine) / static_cast<double>(intervals);
  }
  CHECK(std::abs(std::sqrt(power / static_cast<double>(intervals)) - 0.003) < 1e-9);
  for (std::size_t wave = 0; wave < amplitude.size(); ++wave) {
    CAPTURE(wave);
    if (wave < 4 || wave > 200) CHECK(amplitude[wave] < 1e-10);
    if (wave >= 4 && wave <= 200) {
      CHECK(std::abs(amplitude[wave] / amplitude[4] - std::pow(static_cast<double>(wave) / 4, -1.3)) < 1e-6);
    }
  }
}

TEST_CASE("files keep Coulomb's law in every row: |shear| = f |traction|") {
  const Arguments wanted{"--at=-0.1:0.1:0.005", "--samples", "40"};
  Coulomb csv;
  const auto rows = lines(run_example("rough_surface.toml", joined(wanted, {"--format", "csv"})).out);
  CHECK(rows[0] ==
        "x,traction,shear,gap,slope,u,shear_slope,cumulative_load,friction,side,traction_error,shear_error,gap_error,"
        "slope_error,u_error,shear_slope_error,cumulative_load_error");
  std::string last;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const std::vector<std::string> row = cells_of(rows[k]);
    REQUIRE(row.size() == 17);
    const double traction = std::stod(row[1]), shear = std::stod(row[2]), friction = std::stod(row[8]);
    CHECK(std::abs(std::abs(shear) - friction * std::abs(traction)) <= 1e-15 * std::abs(shear));
    csv.add(std::stod(row[0]), row[0] != last, std::stod(row[1]), std::stod(row[2]));
    last = row[0];
    CHECK(std::stod(row[10]) >= 0);
    CHECK(std::stod(row[11]) >= 0);
  }
  CHECK(csv.rows > 500);
  CHECK(csv.worst <= 1e-15);

  Coulomb json;
  const Json solution = Json::parse(run_example("rough_surface.toml", joined(wanted, {"--format", "json"})).out);
  for (const Json& sample : solution["samples"]) {
    for (const char* name : {"left", "right"}) {
      json.add(real(sample["x"]), name == std::string("left"), real_on(sample["traction"], name),
               real_on(sample["shear"], name));
    }
  }
  CHECK(json.rows > 1000);
  CHECK(json.worst <= 1e-15);
}
