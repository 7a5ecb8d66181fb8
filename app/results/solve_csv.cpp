#include "app/results/number_rows.hpp"
#include "app/results/solve_writers.hpp"

namespace steadyslide::app {

void write_solve_csv(const SolveReport& report, Output& output) {
  NumberRows rows(Format::csv, {{"x"}, {"traction", true}, {"shear", true}, {"gap", true}, {"slope", true}}, output);
  for (const SampleText& sample : report.samples) {
    const NumberText gap = sample.gap.value_or(NumberText{});
    rows.row({sample.x, sample.traction.left, sample.shear.left, gap, sample.slope.left});
    if (sample.traction.two_sided() || sample.shear.two_sided() || sample.slope.two_sided()) {
      rows.row({sample.x, sample.traction.right, sample.shear.right, gap, sample.slope.right});
    }
  }
  rows.end();
}

}  // namespace steadyslide::app
