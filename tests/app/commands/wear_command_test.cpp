// steadyslide wear: its rows, its end, and a run that was interrupted.

#include <csignal>

#include "app/json_answers.hpp"
#include "app/process.hpp"

namespace {

const std::string blade = R"(load = "2"
units = { length = "mm", force = "N" }
[half_space]
poisson = "0.2"
[friction]
values = ["0.1", "0.5", "0.2"]
jumps = ["-0.3", "0.4"]
[indenter]
profile = "x^2/2"
)";
const std::string wear = "[wear]\ncoefficients = [1, 3, \"0.5\"]\n";

/// The column of a table in CSV.
std::vector<double> column(const std::string& table, const std::string& name) {
  const std::vector<std::string> rows = lines(table), names = cells_of(rows[0]);
  const auto k = static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  std::vector<double> result;
  for (std::size_t n = 1; n < rows.size(); ++n) result.push_back(std::stod(cells_of(rows[n]).at(k)));
  return result;
}

}  // namespace

TEST_CASE("wear: the first row is the contact that solve finds, and other commands only check the table") {
  const TemporaryFolder folder{{"blade.toml", blade + wear}, {"plain.toml", blade}};
  const std::string table = out_of(folder.run(words("wear blade.toml --distance 3 --cells 1024")));
  const std::string solved =
      out_of(folder.run(words("solve blade.toml --method variational --cells 1024 --format json")));
  CHECK(solved == out_of(folder.run(words("solve plain.toml --method variational --cells 1024 --format json"))));
  const Json json = Json::parse(solved);
  const auto first = [&](const char* name) { return column(table, name).front(); };
  for (const char* key : {"effective_friction", "centre_of_pressure"}) {
    CHECK(first(key) == doctest::Approx(number(json["resultants"][key]).convert_to<double>()).epsilon(1e-8));
  }
  CHECK(first("left") == doctest::Approx(number(json["contact"][0]["left"]["x"]).convert_to<double>()));
  CHECK(first("wear_volume") == 0);
  CHECK(column(table, "distance").back() == 3);
  // A given number of steps; the volume is the sum of the rates.
  const std::string steps = out_of(folder.run(words("wear blade.toml --distance 3 --steps 6 --cells 256")));
  CHECK(column(steps, "distance") == std::vector<double>{0, 0.5, 1, 1.5, 2, 2.5, 3});
  double volume = 0;
  for (const double rate : column(steps, "wear_rate")) volume += 0.5 * rate;
  volume -= 0.5 * column(steps, "wear_rate").front();
  CHECK(column(steps, "wear_volume").back() == doctest::Approx(volume).epsilon(1e-9));
  // The end near the run-in pressure.
  const std::string until = out_of(folder.run(words("wear blade.toml --distance 1e9 --until 1e-3 --cells 256")));
  CHECK(column(until, "from_run_in").back() <= 1e-3);
  CHECK(*(column(until, "from_run_in").end() - 2) > 1e-3);
}

TEST_CASE("wear: layers and a period have the same run-in pressure as the half-plane") {
  // The jumps are ends of cells. a = P/sum(l/k), and the friction is the mean of f under the pressures a/k.
  const double a = 2 / (0.7 / 1 + 0.7 / 3 + 0.6 / 0.5),
               friction = a * (0.1 * 0.7 / 1 + 0.5 * 0.7 / 3 + 0.2 * 0.6 / 0.5) / 2;
  const auto with = [](const std::string& body) { return replaced(blade, "poisson = \"0.2\"", body) + wear; };
  const TemporaryFolder folder{
      {"layer.toml", with("base = \"rigid\"\nlayers = [ {thickness = \"0.5\", young = 1, poisson = \"0.4\"} ]")},
      {"period.toml", with("poisson = \"0.2\"\nperiod = \"2.5\"")},
      {"plane.toml", with("poisson = \"0.2\"")}};
  std::vector<double> first;
  for (const std::string file : {"layer.toml", "period.toml", "plane.toml"}) {
    const std::string table = out_of(folder.run(words("wear " + file + " --distance 1e9 --until 1e-4 --cells 200")));
    CHECK(column(table, "effective_friction").back() == doctest::Approx(friction).epsilon(1e-4));
    first.push_back(column(table, "effective_friction").front());
  }
  // They begin with different contacts.
  CHECK(std::abs(first[0] - first[2]) > 1e-3);
  CHECK(std::abs(first[1] - first[2]) > 1e-3);
}

TEST_CASE("wear: a killed and resumed run gives the same files to the byte") {
  const TemporaryFolder folder{{"blade.toml", blade + wear}};
  const auto command = [](const std::string& more) {
    return words("wear blade.toml --distance 3 --steps 150 --cells 20000 -o " + more);
  };
  out_of(folder.run(command("whole --profiles profiles")));
  const std::string whole = folder.read("whole"), profiles = folder.read("profiles");
  CHECK(lines(whole).size() == 152);
  CHECK(lines(profiles).size() > 10000);
  for (const auto& [signal, code] : {std::pair("KILL", 128 + SIGKILL), {"TERM", 130}}) {
    const std::string run = std::string(STEADYSLIDE_EXECUTABLE) + " wear blade.toml --distance 3 --steps 150 " +
                            "--cells 20000 -o out --profiles later";
    const Finished killed =
        run_other({"bash", "-c",
                   run + " & for i in {1..6000}; do [ -e out.part ] && break; sleep 0.01; done; kill -" + signal +
                       " $!; wait $!"},
                  folder.path());
    REQUIRE(killed.code == code);
    const std::vector<std::string> names = folder.names();
    REQUIRE(std::count(names.begin(), names.end(), "out.part") == 1);
    CHECK(std::count(names.begin(), names.end(), "out") == 0);
    const std::string part = folder.read("out.part");
    CHECK(holds(part, "\n" + lines(whole)[2] + "\n"));  // the rows are in it, not the last one
    CHECK_FALSE(holds(part, lines(whole).back()));
    check_refused(folder.run(command("out")),
                  "out.part:1: an interrupted run; --resume goes on with it; without it there is no such file");
    check_refused(folder.run(words("wear blade.toml --distance 2 --steps 150 --cells 20000 --resume -o out")),
                  "out.part:1: another run; --resume goes on with the same problem, options and version; '" +
                      lines(part)[0].substr(0, 40) + "...'");
    folder.write("cut.part", part.substr(0, part.size() - 8));
    check_refused(folder.run(command("cut --resume")),
                  "cut.part:2: not whole; remove it and start again; " + std::to_string(part.size() - 8) + " bytes");
    out_of(folder.run(command("out --resume --profiles later")));
    CHECK(folder.read("out") == whole);
    CHECK(folder.read("later") == profiles);
    for (const char* name : {"out", "later", "cut.part"}) std::filesystem::remove(folder.path() / name);
    CHECK(folder.names() == std::vector<std::string>{"blade.toml", "profiles", "whole"});
  }
  // A run that has no FILE.part starts from the beginning.
  out_of(folder.run(command("out --resume")));
  CHECK(folder.read("out") == whole);
}

TEST_CASE("wear: what is refused, and a step that has no solution") {
  const std::string elastic =
      replaced(blade, "profile = \"x^2/2\"", "profile = \"2*x^2\"\nelastic = { poisson = \"0.3\", young = 2 }");
  const TemporaryFolder folder{{"plain.toml", blade},
                               {"elastic.toml", elastic + wear},
                               {"tilting.toml", "load_at = \"0.8\"\n" + blade + "[wear]\ncoefficients = [1, 0, 1]\n"}};
  check_refused(folder.run(words("wear plain.toml --distance 1")),
                "plain.toml: wear: missing; the command wear needs the table; absent");
  check_refused(folder.run(words("wear tilting.toml --distance 1 --until 0.1")),
                "command line: --until: no run-in pressure; the cells that do not wear carry the load at its place in "
                "the end; they cannot");
  CHECK(holds(out_of(folder.run(words("wear tilting.toml --distance 1 --steps 2 --cells 64"))), ",,"));
  // The contact of an elastic indenter grows until it reaches an edge.
  const Finished failed = folder.run(words("wear elastic.toml --distance 100 --cells 256 -o out"));
  CHECK(failed.code == 1);
  const std::string reason =
      "the contact of an elastic indenter reaches an edge, where the half-plane idealisation fails";
  CHECK(holds(failed.err, "elastic.toml: not solved beyond the sliding distance 0.03"));
  CHECK(holds(failed.err, reason + "; what was reached is printed"));
  CHECK(holds(lines(folder.read("out")).back(), ",\"" + reason + "\""));
}

TEST_CASE("wear: the picture has depths, pressures and the run-in pressure") {
  const TemporaryFolder folder{{"blade.toml", blade + wear}};
  out_of(folder.run(words("wear blade.toml --distance 20 --cells 256 -o out.csv --plot worn.svg")));
  const std::string svg = folder.read("worn.svg");
  for (const char* text : {"blade.toml, worn over the sliding distance 20", "run-in pressure", "worn depth", "N/mm²"}) {
    CAPTURE(text);
    CHECK(holds(svg, text));
  }
}
