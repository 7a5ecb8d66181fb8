// steadyslide sweep, run as a user does: rows compared with single solves, their order, workers, interruptions.

#include <sys/stat.h>
#include <csignal>
#include <fstream>

#include "app/json_answers.hpp"
#include "app/sweep/sweep_folder.hpp"

namespace {

std::vector<std::vector<std::string>> table_of(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  for (const std::string& line : lines(csv)) rows.push_back(cells_of(line));
  return rows;
}

/// Returns the first cells of each row, after the names.
std::string firsts(const std::string& csv, std::size_t count) {
  std::string result;
  for (const auto& row : table_of(csv)) {
    for (std::size_t k = 0; k < count; ++k) result += (k == 0 ? "" : ",") + row.at(k);
    result += "\n";
  }
  return result;
}

/// It works for more than a second in one thread.
const std::string long_sweep =
    "[vary]\n\"friction.values[0]\" = \"0.01:0.8:0.01\"\n\"friction.values[1]\" = \"0.01:0.8:0.01\"\n"
    "[output]\ncolumns = [\"effective_friction\", \"load_share[0]\"]\n";

}  // namespace

TEST_CASE("sweep: each row has the results of one solve") {
  const SweepFolder folder(sweep_of_three_data +
                           "[output]\ncolumns = [\"effective_friction\", \"resultants.centre_of_pressure_error\", "
                           "\"load_share[1]\", \"contact[0].right.exponent\", \"singular_points[1].intensity\", "
                           "\"singular_points[3].kind\", \"contact.size\", \"digits\", \"method\", "
                           "\"load_share_error[1]\", \"largest_pressure_error\", "
                           "\"singular_points[1].stress_intensity\"]\n");
  const auto table = table_of(out_of(folder.sweep()));
  REQUIRE(table.size() == 13);
  for (std::size_t n = 1; n < table.size(); ++n) {
    const auto& row = table[n];
    const std::string problem =
        replaced(replaced(replaced(sweep_base, "\"0.5\"", "\"" + row[0] + "\""), "\"0.2\"", "\"" + row[1] + "\""),
                 "jumps = [0]", "jumps = [\"" + row[2] + "\"]");
    const Json json = Json::parse(output(problem, {"--format", "json"}));
    const auto at = [&](const char* pointer) { return text_of(value_of(json.at(Json::json_pointer(pointer)))); };
    CHECK(row[3] == at("/resultants/effective_friction"));
    CHECK(row[4] == at("/resultants/centre_of_pressure/error"));
    CHECK(row[5] == at("/resultants/load_share/1"));
    CHECK(row[6] == at("/contact/0/right/exponent"));
    CHECK(row[7] == at("/singular_points/1/intensity"));
    CHECK(row[8] == "");  // there are three singular points
    CHECK(row[9] == "1");
    CHECK(row[10] == "16");
    CHECK(row[11] == at("/method"));
    CHECK(row[12] == at("/resultants/load_share/1/error"));
    CHECK(row[13] == at("/resultants/largest_pressure/value/error"));
    CHECK(row[14] ==
          at("/singular_points/1/stress_intensity/left") + " " + at("/singular_points/1/stress_intensity/right"));
    CHECK(row.back() == "");
  }
  CHECK(table[1][3] != table[2][3]);
}

TEST_CASE("sweep: the first datum of the file changes slowest, and [together] counts at its place in the file") {
  const SweepFolder folder(
      "[vary]\nload = [\"1\", \"2\"]\nhalf_space.young = [1, 3]\n[together]\n"
      "\"friction.values[1]\" = \"0.4:0.5:0.1\"\n\"friction.values[0]\" = [\"1/3\", 0]\n");
  CHECK(firsts(out_of(folder.sweep()), 4) ==
        "load,half_space.young,friction.values[1],friction.values[0]\n"
        "1,1,0.4,0.3333333333333333\n1,1,0.5,0\n1,3,0.4,0.3333333333333333\n1,3,0.5,0\n"
        "2,1,0.4,0.3333333333333333\n2,1,0.5,0\n2,3,0.4,0.3333333333333333\n2,3,0.5,0\n");
  folder.write("sweep.toml",
               "together = { load_at = [0, 0.1] }\nvary = { sliding = [\"+x\", \"-x\"], load = [2, 1] }\n[problem]\n" +
                   sweep_base.substr(0, 9) +
                   "[problem.half_space]\npoisson = 0.3\n[problem.friction]\nvalues = [0.2]\n[problem.indenter]\n"
                   "profile = \"x^2\"\n");
  CHECK(firsts(out_of(folder.sweep()), 3) ==
        "load_at,sliding,load\n0,+x,2\n0,+x,1\n0,-x,2\n0,-x,1\n0.1,+x,2\n0.1,+x,1\n0.1,-x,2\n0.1,-x,1\n");
}

TEST_CASE("sweep: lists, profiles and keys that the problem does not have can vary") {
  const SweepFolder folder(
      "[vary]\nfriction.jumps = [[\"-0.5\"], [\"0.5\"]]\nindenter.profile = [0, \"x^2*8\"]\n"
      "half_space.plane = [\"stress\"]\n[output]\ncolumns = [\"contact[0].left.kind\"]\n");
  CHECK(out_of(folder.sweep()) ==
        "friction.jumps,indenter.profile,half_space.plane,contact[0].left.kind,failed_condition\n"
        "-0.5,0,stress,edge,\n-0.5,x^2*8,stress,free,\n0.5,0,stress,edge,\n0.5,x^2*8,stress,free,\n");
}

TEST_CASE("sweep: columns of a second component have its values, columns of a missing component are empty") {
  const std::string two_bumps =
      replaced(replaced(sweep_base, "profile = 0", "support = [-2, 2]\nprofile = \"(x^2-1)^2/4\""), "load = 1",
               "load = \"0.1\"");
  const SweepFolder folder(
      "[vary]\nsliding = [\"+x\"]\n[output]\ncolumns = [\"contact[0].width\", \"contact[1].width\", "
      "\"contact[1].left.kind\", \"contact[2].width\", \"contact.size\"]\n");
  folder.write("base.toml", two_bumps);
  const std::vector<std::string> row = table_of(out_of(folder.sweep())).at(1);
  const Json contact = Json::parse(output(two_bumps, {"--format", "json"})).at("contact");
  REQUIRE(contact.size() == 2);
  CHECK(row[1] == text_of(value_of(contact[0].at("width"))));
  CHECK(row[2] == text_of(value_of(contact[1].at("width"))));
  CHECK(row[1] != row[2]);
  CHECK(row[3] == "free");
  CHECK(row[4] == "");
  CHECK(row[5] == "2");
}

TEST_CASE("sweep: measured profiles can vary") {
  const SweepFolder folder(
      "[vary]\nindenter.samples = [\"flat.csv\", \"wedge.csv\"]\n[output]\ncolumns = [\"method\"]\n");
  folder.write("base.toml", replaced(sweep_base, "profile = 0", "samples = \"none.csv\""));
  folder.write("flat.csv", "-1,0\n1,0\n");
  folder.write("wedge.csv", "-1,1\n0,0\n1,1\n");
  CHECK(out_of(folder.sweep({"-o", "out"})) == "");
  CHECK(folder.read("out") ==
        "indenter.samples,method,failed_condition\nflat.csv,closed-form,\nwedge.csv,riemann-hilbert,\n");
}

TEST_CASE("sweep: digits, method, cells and the window are those of solve") {
  const SweepFolder folder("[vary]\nload = [1, 2]\n[solve]\ndigits = 30\n[output]\ncolumns = [\"load_share[0]\"]\n");
  const Json json = Json::parse(output(sweep_base, {"--format", "json", "--digits", "30"}));
  CHECK(table_of(out_of(folder.sweep()))[1][1] == text_of(json["resultants"]["load_share"][0]["value"]));
  folder.write("sweep.toml",
               "problem = \"base.toml\"\n[vary]\nload = [1]\n[solve]\nmethod = \"variational\"\n"
               "cells = 2048\niterations = 9\nover = 0.1\n[output]\ncolumns = [\"largest_average\", \"load_share[0]\", "
               "\"method\"]\n");
  const Json cells = Json::parse(
      output(sweep_base, {"--format", "json", "--method", "variational", "--cells", "2048", "--over", "0.1"}));
  CHECK(table_of(out_of(folder.sweep()))[1] ==
        std::vector<std::string>{"1", text_of(cells["resultants"]["largest_average"]["value"]),
                                 text_of(cells["resultants"]["load_share"][0]["value"]), "variational", ""});
}

TEST_CASE("sweep: the largest stress is that of --max-stress, and is computed for its columns alone") {
  const SweepFolder folder(
      "[vary]\nload = [1]\n[solve]\nover = 0.1\ndepth = 0.2\n[output]\ncolumns = [\"largest_stress.von_mises\", "
      "\"largest_stress.z_error\", \"largest_stress.average.von_mises\"]\n");
  const Json largest =
      Json::parse(output(sweep_base, words("--format json --max-stress --depth 0.2 --over 0.1")))["largest_stress"];
  CHECK(table_of(out_of(folder.sweep()))[1] ==
        std::vector<std::string>{"1", text_of(largest["von_mises"]["value"]), text_of(largest["z"]["error"]),
                                 text_of(largest["average"]["von_mises"]["value"]), ""});
}

TEST_CASE("sweep: a failure is a row with its reason, and exit code 1") {
  const SweepFolder folder(
      "[vary]\n\"friction.jumps[0]\" = [\"0.5\", 1, \"-3/2\"]\n[solve]\nmethod = \"closed-form\"\n"
      "[output]\ncolumns = [\"method\", \"warnings.size\"]\n");
  const Finished finished = folder.sweep({"-o", "out.csv"});
  CHECK(finished.code == 1);
  CHECK(finished.err ==
        "steadyslide: sweep.toml: 2 of 3 problems not solved, first of all row 2; the column "
        "failed_condition says why\n");
  CHECK(folder.read("out.csv") ==
        "friction.jumps[0],method,warnings.size,failed_condition\n0.5,closed-form,0,\n"
        "1,,,\"friction.jumps[0]: jump outside the support; jumps lie in ]-1, 1[; 1\"\n"
        "-1.5,,,\"friction.jumps[0]: jump outside the support; jumps lie in ]-1, 1[; -1.5\"\n");
  CHECK(folder.names() == std::vector<std::string>{"base.toml", "out.csv", "sweep.toml"});
}

TEST_CASE("sweep: random values agree with another implementation") {
  const SweepFolder folder(
      "[vary]\n\"friction.jumps[0]\" = { random = 50, from = \"-0.9\", to = \"9/10\", seed = 1 }\n"
      "load = { random = 2, from = 1, to = 2, seed = 18446744073709551615 }\n");
  // TOML's integers end at 2^63-1. A larger seed is written as a string.
  folder.write("sweep.toml", replaced(folder.read("sweep.toml"), "18446744073709551615", "\"18446744073709551615\""));
  const auto table = table_of(out_of(folder.sweep()));
  const auto expected = [&](const Arguments& arguments) {
    return lines(out_of(
        run_other(joined({"python3", STEADYSLIDE_TESTS "/app/sweep/random_decimals.py"}, arguments), folder.path())));
  };
  const std::vector<std::string> jumps = expected({"friction.jumps[0]", "1", "-9/10", "9/10", "50"});
  const std::vector<std::string> loads = expected({"load", "18446744073709551615", "1", "2", "2"});
  REQUIRE(table.size() == 101);
  for (std::size_t n = 0; n < 100; ++n) {
    CHECK(parse_rational(table[n + 1][0]) == parse_rational(jumps[n / 2]));
    CHECK(parse_rational(table[n + 1][1]) == parse_rational(loads[n % 2]));
  }
  CHECK(table[1][0] == "-0.0285036204852");
}

TEST_CASE("sweep: the same table from any number of threads, to a file or not, from the standard input") {
  const SweepFolder folder(sweep_of_three_data);
  const std::string one = out_of(folder.sweep({"-j", "1"}));
  for (const char* jobs : {"2", "7"}) CHECK(out_of(folder.sweep({"--jobs", jobs})) == one);
  CHECK(folder.sweep({"-o", "out"}).code == 0);
  CHECK(folder.read("out") == one);
  CHECK(out_of(folder.run({"sweep", "-"}, folder.read("sweep.toml"))) == one);
  CHECK(folder.sweep({"-o", "/dev/null"}).code == 0);
  CHECK(folder.names() == std::vector<std::string>{"base.toml", "out", "sweep.toml"});
}

TEST_CASE("sweep: a killed and resumed sweep gives the same file to the byte") {
  const SweepFolder folder(long_sweep);
  REQUIRE(folder.sweep({"-o", "whole"}).code == 0);
  const std::string whole = folder.read("whole");
  CHECK(lines(whole).size() == 6401);
  const std::vector<std::string> with_part{"base.toml", "out.part", "sweep.toml", "whole"};
  for (const auto& [signal, code] : {std::pair(SIGKILL, 128 + SIGKILL), {SIGINT, 130}, {SIGTERM, 130}}) {
    const Finished killed = run_and_interrupt({"sweep", "sweep.toml", "-j", "2", "-o", "out"}, folder, signal,
                                              std::chrono::milliseconds(250));
    REQUIRE(killed.code == code);
    CHECK(folder.names() == with_part);
    const std::string part = folder.read("out.part");
    const std::string rows = part.substr(part.find('\n') + 1);
    CHECK(lines(rows).size() > 10);
    CHECK(lines(rows).size() < 6000);
    CHECK(whole.starts_with(rows));
    // The last line is incomplete.
    if (signal == SIGKILL) std::ofstream(folder.path() / "out.part", std::ios::app) << "0.79,0.5";
    CHECK(out_of(folder.sweep({"--resume", "-o", "out"})) == "");
    CHECK(folder.read("out") == whole);
    std::filesystem::remove(folder.path() / "out");
    CHECK(folder.names() == std::vector<std::string>{"base.toml", "sweep.toml", "whole"});
  }
}

TEST_CASE("sweep: rows of an earlier sweep are neither overwritten nor used for another sweep") {
  const SweepFolder folder("[vary]\nload = [1, 2]\nfriction.jumps = [[0], [2]]\n");
  CHECK(folder.sweep({"-o", "out", "--resume"}).code == 1);  // there is nothing to resume: it starts from the beginning
  const std::string whole = folder.read("out");
  const auto refused = [&](const Arguments& arguments, const std::string& message, int code = 2) {
    check_refused(folder.sweep(arguments), message, code);
  };
  refused({"--resume"},
          "command line: --resume: nothing to resume; it goes on with FILE.part of --output FILE; "
          "'standard output'");
  folder.write("out.part", "# steadyslide 0.0.1, sweep 0123456789abcdef\nload\n1\n");
  refused({"-o", "out"},
          "out.part:1: rows of an interrupted sweep; --resume goes on with them; without it there is no "
          "such file; '# steadyslide 0.0.1, sweep 0123456789abc...'");
  refused({"-o", "out", "--resume"},
          "out.part:1: rows of another sweep; --resume goes on with the same sweep, problem "
          "and version; '# steadyslide 0.0.1, sweep 0123456789abc...'");
  CHECK(folder.read("out") == whole);
}

TEST_CASE("sweep: rows that are missing or doubled are noticed, and a FILE.part that is no regular file") {
  const SweepFolder folder(long_sweep);
  const Finished killed =
      run_and_interrupt({"sweep", "sweep.toml", "-o", "out"}, folder, SIGKILL, std::chrono::milliseconds(200));
  REQUIRE(killed.code == 128 + SIGKILL);
  std::vector<std::string> part = lines(folder.read("out.part"));
  REQUIRE(part.size() > 20);
  const auto refused_at = [&](std::vector<std::string> changed, int line) {
    std::string text;
    for (const std::string& one : changed) text += one + "\n";
    folder.write("out.part", text);
    const Finished finished = folder.sweep({"-o", "out", "--resume"});
    CHECK(finished.code == 2);
    CHECK(
        finished.err.starts_with("steadyslide: out.part:" + std::to_string(line) +
                                 ": not the row of its problem; rows are those of the sweep, in order, each once; '"));
    CHECK(folder.read("out.part") == text);
  };
  auto changed = part;
  changed.erase(changed.begin() + 7);
  refused_at(changed, 8);
  changed = part;
  changed.insert(changed.begin() + 7, part[7]);
  refused_at(changed, 9);
  changed = part;
  changed.push_back(part.back());
  refused_at(changed, static_cast<int>(part.size()) + 1);
  changed = part;
  std::swap(changed[5], changed[6]);
  refused_at(changed, 6);

  std::filesystem::remove(folder.path() / "out.part");
  REQUIRE(::mkfifo((folder.path() / "out.part").c_str(), 0600) == 0);
  for (const char* resume : {"--resume", "-j2"}) {
    check_refused(run_program_by({"timeout", "20"}, {"sweep", "sweep.toml", "-o", "out", resume}, folder.path()),
                  "out.part:1: no regular file; rows are kept in one until they are all there; a pipe or a device");
  }
}

TEST_CASE("sweep: rows of another problem, of other columns or another trace are refused") {
  const SweepFolder folder(long_sweep);
  folder.write("base.toml", replaced(sweep_base, "profile = 0", "samples = \"trace.csv\""));
  folder.write("trace.csv", "-1,0\n1,0\n");
  const Finished killed =
      run_and_interrupt({"sweep", "sweep.toml", "-o", "out"}, folder, SIGKILL, std::chrono::milliseconds(200));
  REQUIRE(killed.code == 128 + SIGKILL);
  const std::string part = folder.read("out.part");
  const auto is_refused_with = [&](const std::string& file, const std::string& what, const std::string& with) {
    const std::string before = folder.read(file);
    folder.write(file, replaced(before, what, with));
    const Finished finished = folder.sweep({"-o", "out", "--resume"});
    folder.write(file, before);
    return finished.code == 2 && finished.err.starts_with("steadyslide: out.part:1: rows of another sweep; ");
  };
  CHECK(is_refused_with("base.toml", "load = 1", "load = 2"));
  CHECK(is_refused_with("sweep.toml", "load_share[0]", "load_share[1]"));
  CHECK(is_refused_with("trace.csv", "1,0\n1", "2,0\n1"));
  CHECK(folder.read("out.part") == part);
  CHECK(folder.sweep({"-o", "out", "--resume"}).code == 0);
  CHECK(folder.read("out").starts_with(part.substr(part.find('\n') + 1)));
}
