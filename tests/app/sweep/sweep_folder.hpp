#pragma once
// The fixture of sweeps: a folder with base.toml, which has two coatings under a flat punch, and a sweep of it.

#include "app/command_line.hpp"

namespace steadyslide::testing {

inline const std::string sweep_base =
    "load = 1\n[half_space]\npoisson = \"0.2\"\n[friction]\nvalues = [\"0.1\", \"0.5\"]\njumps = [0]\n[indenter]\n"
    "profile = 0\n";

struct SweepFolder : TemporaryFolder {
  /// `rest`: the text of sweep.toml below the problem's name.
  explicit SweepFolder(const std::string& rest) {
    write("base.toml", sweep_base);
    write("sweep.toml", "problem = \"base.toml\"\n" + rest);
  }
  /// Runs `steadyslide sweep sweep.toml ARGUMENTS`.
  Finished sweep(const Arguments& arguments = {}) const {
    return run_program(joined({"sweep", "sweep.toml"}, arguments), path());
  }
};

inline const std::string sweep_of_three_data =
    "[vary]\n\"friction.values[1]\" = \"0.4:0.5:0.1\"\nhalf_space.poisson = [\"0.2\", 0.3]\n"
    "\"friction.jumps[0]\" = { random = 3, from = \"-0.9\", to = \"0.9\", seed = 7 }\n";

}  // namespace steadyslide::testing
