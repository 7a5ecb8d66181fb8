// steadyslide-sweep: several processes under mpirun, and HDF5. Both are optional.

#include <csignal>

#include "app/sweep/sweep_folder.hpp"

#ifdef STEADYSLIDE_SWEEP

namespace {

Finished together(int processes, const Arguments& arguments, const SweepFolder& folder) {
  return run_other(joined({STEADYSLIDE_MPIRUN, "--allow-run-as-root", "--oversubscribe", "-n",
                           std::to_string(processes), STEADYSLIDE_SWEEP},
                          arguments),
                   folder.path());
}

}  // namespace

TEST_CASE("mpirun steadyslide-sweep: the same table from any number of processes") {
  const SweepFolder folder(sweep_of_three_data);
  const std::string one = out_of(folder.sweep({"-j", "1"}));
  CHECK(out_of(run_other({STEADYSLIDE_SWEEP, "sweep.toml"}, folder.path())) == one);
  CHECK(out_of(together(2, {"sweep.toml"}, folder)) == one);
  CHECK(out_of(together(3, {"sweep.toml", "-o", "out", "-j", "2"}, folder)) == "");
  CHECK(folder.read("out") == one);
  std::filesystem::remove(folder.path() / "out");
  folder.write("long.toml", "problem = \"base.toml\"\n[vary]\nload = \"1:3000:1\"\n");
  // mpirun ends this sweep of one process; the next run finds its rows.
  const Finished killed =
      run_and_interrupt({"sweep", "long.toml", "-o", "out"}, folder, SIGKILL, std::chrono::milliseconds(100));
  REQUIRE(killed.code == 128 + SIGKILL);
  CHECK(out_of(together(2, {"long.toml", "-o", "out", "--resume"}, folder)) == "");
  CHECK(out_of(folder.run({"sweep", "long.toml"})) == folder.read("out"));
}

TEST_CASE("mpirun steadyslide-sweep: an error is printed once, and failures are rows") {
  const SweepFolder folder("[vary]\nfriction.jumps = [[0], [2], [0]]\n");
  const Finished failed = together(2, {"sweep.toml", "-o", "out"}, folder);
  CHECK(failed.code == 1);
  CHECK(failed.err.starts_with("steadyslide: sweep.toml: 1 of 3 problems not solved, first of all row 2; "));
  CHECK(run_other({STEADYSLIDE_SWEEP, "sweep.toml", "-o", "single"}, folder.path()).code == 1);
  CHECK(folder.read("out") == folder.read("single"));
  folder.write("sweep.toml", "problem = \"none.toml\"\n");
  const Finished wrong = together(2, {"sweep.toml", "-o", "wrong"}, folder);
  CHECK(wrong.code == 2);
  CHECK(wrong.err.starts_with("steadyslide: sweep.toml:1: problem: no such problem file; "));
  CHECK(times(wrong.err, "no such problem file") == 1);
  CHECK(folder.names() == std::vector<std::string>{"base.toml", "out", "single", "sweep.toml"});
}

TEST_CASE("sweep -o FILE.h5 writes a dataset for each column, of numbers or words, and the same bytes each time") {
  const SweepFolder folder(
      "[vary]\nfriction.jumps = [[0], [2], [\"1/2\"]]\nsliding = [\"+x\"]\n[output]\ncolumns = "
      "[\"effective_friction\", \"method\"]\n");
  CHECK(folder.sweep({"-o", "out.h5"}).code == 1);
  CHECK(folder.sweep({"-o", "again", "--format", "hdf5", "-j", "1"}).code == 1);
  CHECK(folder.read("out.h5") == folder.read("again"));
  CHECK(folder.sweep({"-o", "out.csv"}).code == 1);
  CHECK(folder.names() == std::vector<std::string>{"again", "base.toml", "out.csv", "out.h5", "sweep.toml"});
  const auto dump = [&](const std::string& name) {
    return run_other({"h5dump", "-m", "%.16g", "-y", "-w", "200", "-d", name, "out.h5"}, folder.path());
  };
  if (dump("method").code == 127) {
    MESSAGE("h5dump is not installed: what is in the file is not looked at");
    return;
  }
  const std::string csv = folder.read("out.csv");
  const std::string friction = lines(csv)[1].substr(5, lines(csv)[1].find(',', 5) - 5);
  CHECK(holds(dump("effective_friction").out, friction + ", nan, 0."));
  CHECK(holds(dump("effective_friction").out, "H5T_IEEE_F64LE"));
  CHECK(holds(dump("friction.jumps").out, "0, 2, 0.5"));
  CHECK(holds(dump("sliding").out, "\"+x\", \"+x\", \"+x\""));
  CHECK(holds(dump("method").out, "\"closed-form\", \"\", \"closed-form\""));
  CHECK(holds(dump("failed_condition").out, "\"\", \"friction.jumps[0]: jump outside the support; "));
}

#else

TEST_CASE("without steadyslide-sweep an HDF5 file is refused") {
  MESSAGE("libopenmpi-dev or libhdf5-dev is not installed: nothing is known of steadyslide-sweep");
  const SweepFolder folder(sweep_of_three_data);
  const Finished finished = folder.sweep({"-o", "out.h5"});
  CHECK(finished.code == 2);
  CHECK(holds(finished.err, "--format: no HDF5 here; steadyslide-sweep writes it, which is built with MPI and HDF5; "));
  CHECK(folder.names() == std::vector<std::string>{"base.toml", "sweep.toml"});
}

#endif
