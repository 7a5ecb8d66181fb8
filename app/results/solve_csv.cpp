#include "app/results/row_writer.hpp"
#include "app/results/solve_writers.hpp"

namespace steadyslide::app {

void write_solve_csv(const SolveReport& report, Output& output) {
  const auto rows = make_row_writer(Format::csv, {{"x"}, {"traction"}, {"shear"}, {"gap"}, {"slope"}}, output);
  for (const SampleText& sample : report.samples) {
    const std::string gap = sample.gap.value_or("");
    rows->row({sample.x, sample.traction.left, sample.shear.left, gap, sample.slope.left});
    if (sample.traction.two_sided() || sample.shear.two_sided() || sample.slope.two_sided()) {
      rows->row({sample.x, sample.traction.right, sample.shear.right, gap, sample.slope.right});
    }
  }
  rows->end();
}

}  // namespace steadyslide::app
