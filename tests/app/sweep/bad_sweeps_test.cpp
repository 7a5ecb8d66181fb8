// Bad sweeps: the whole message and the exit code of each. Nothing is written.

#include "app/changed_files.hpp"
#include "app/sweep/sweep_folder.hpp"

TEST_CASE("bad sweeps: message, exit code, no output") {
  const auto sweeps = changed_files(STEADYSLIDE_TESTS "/app/sweep/bad_sweeps.txt");
  CHECK(sweeps.size() >= 60);
  for (const auto& sweep : sweeps) {
    CAPTURE(sweep.second);
    const SweepFolder folder("");
    folder.write("bad.toml", sweep.second);
    folder.write("out", "earlier");
    check_refused(folder.run({"sweep", "bad.toml", "-o", "out"}), "bad.toml:" + sweep.first);
    CHECK(folder.read("out") == "earlier");
    CHECK(folder.names() == std::vector<std::string>{"bad.toml", "base.toml", "out", "sweep.toml"});
  }
}

TEST_CASE("bad sweeps: the message for a mistake in the base has the line of the base") {
  const SweepFolder folder("[vary]\nload = [1, 2]\n");
  folder.write("base.toml", "lode = 1\n" + sweep_base);
  check_refused(folder.sweep({"-o", "out"}),
                "base.toml:1: unknown key; the keys of a problem file are load, load_at, "
                "sliding, units, half_space, friction, indenter, wear; 'lode'");
  folder.write("base.toml", "load = ");
  check_refused(folder.sweep({"-o", "out"}),
                "base.toml:1: not TOML; a problem file is written in TOML; Error while "
                "parsing key-value pair: encountered end-of-file");
  check_refused(folder.run({"sweep", "none.toml"}), "none.toml: cannot be read: No such file or directory", 3);
  CHECK(folder.names() == std::vector<std::string>{"base.toml", "sweep.toml"});
}

TEST_CASE("bad sweeps: the message for an unknown column lists the known ones") {
  const SweepFolder folder("[vary]\nload = [1, 2]\n[output]\ncolumns = [\"effective_frikshun\"]\n");
  const Finished finished = folder.sweep({"-o", "out"});
  CHECK(finished.code == 2);
  CHECK(
      finished.err.starts_with("steadyslide: sweep.toml:5: output.columns[0]: unknown column; keys here are method, "));
  CHECK(holds(finished.err, ", effective_friction, load_share, "));
  CHECK(finished.err.ends_with("; 'effective_frikshun'\n"));
  CHECK(folder.names() == std::vector<std::string>{"base.toml", "sweep.toml"});
}

TEST_CASE("bad sweeps: a file that cannot be written is refused before the first row") {
  const SweepFolder folder(sweep_of_three_data);
  check_refused(folder.sweep({"-o", "none/out"}), "none/out: cannot be written: No such file or directory", 3);
  check_refused(folder.sweep({"-o", "/dev/full"}), "/dev/full: cannot be written: No space left on device", 3);
  CHECK(folder.names() == std::vector<std::string>{"base.toml", "sweep.toml"});
}
