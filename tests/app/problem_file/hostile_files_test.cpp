// Hostile files of ten megabytes: the program answers or reports an error within ten seconds and one gigabyte, and
// never crashes.

#include <random>

#include "app/command_line.hpp"

namespace {

constexpr std::size_t ten_megabytes = std::size_t{10} << 20;

std::string repeated(const std::string& part, std::size_t size) {
  std::string text;
  while (text.size() < size) text += part;
  return text;
}

/// Returns random characters of an alphabet, or random bytes if it is empty.
std::string noise(const std::string& alphabet) {
  std::mt19937 generator(1);
  std::string bytes(ten_megabytes, '\0');
  for (char& c : bytes) c = alphabet.empty() ? static_cast<char>(generator()) : alphabet[generator() % alphabet.size()];
  return bytes;
}

/// Runs a problem file, if given with a trace t.csv beside it, within ten seconds and one gigabyte. A sanitizer
/// reserves terabytes, and takes six times as long.
Finished run_limited(const std::string& text, const std::string& trace = "") {
  const TemporaryFolder folder{{"f.toml", text}, {"t.csv", trace}};
#ifdef __SANITIZE_ADDRESS__
  const std::string limited = "exec timeout 60";
#else
  const std::string limited = "ulimit -v 1048576; exec timeout 10";
#endif
  return run_other({"sh", "-c", limited + " '" STEADYSLIDE_EXECUTABLE "' exponents f.toml"}, folder.path());
}

void check_refusal(const Finished& finished, const std::string& message) {
  CHECK(finished.code == 2);
  CHECK(finished.err.starts_with("steadyslide: " + message));
  CHECK(finished.err.size() < 700);
  CHECK(finished.err.find('\n') == finished.err.size() - 1);
}

void check_refused(const std::string& text, const std::string& message) { check_refusal(run_limited(text), message); }

std::string problem_with(const std::string& friction, const std::string& profile) {
  return "load = 1\n[half_space]\npoisson = 0.3\n[friction]\n" + friction + "[indenter]\n" + profile;
}

Finished run_with_trace(const std::string& trace) {
  return run_limited(problem_with("values = [0.1]\n", "samples = \"t.csv\"\n"), trace);
}

}  // namespace

TEST_CASE("ten megabytes of noise are refused") {
  check_refused(noise(""), "f.toml:");
  check_refused(noise("ab.=[]{}\"'#,10\n -"), "f.toml:");
}

TEST_CASE("a million jumps are refused") {
  std::string friction = "values = [";
  for (int k = 0; k <= 1000000; ++k) friction += "0.1,";
  friction += "]\njumps = [";
  for (int k = 1; k <= 1000000; ++k) friction += "\"" + std::to_string(k) + "e-7\",";
  check_refused(problem_with(friction + "]\n", "profile = 0\n"),
                "f.toml:5: too many values; a problem file has at most 200000 keys and values; more\n");
}

TEST_CASE("the largest number of friction values is accepted, and one more is refused") {
  const auto problem = [](int values) {
    std::string friction = "values = [";
    for (int k = 0; k < values; ++k) friction += "\"" + std::to_string(k % 7) + "e-1\",";
    friction += "]\njumps = [";
    for (int k = 1; k < values; ++k) friction += "\"" + std::to_string(k) + "e-6\",";
    return problem_with(friction + "]\n", "profile = 0\n");
  };
  CHECK(run_limited(problem(90000)).code == 0);
  check_refused(problem(90001),
                "f.toml:5: friction.values: too many entries; there are at most 90000; 90001 entries\n");
}

TEST_CASE("deep nesting, long keys, long strings and NUL bytes are refused") {
  for (const char* open : {"[", "{a="}) {
    check_refused("a = " + repeated(open, ten_megabytes), "f.toml:1: nested too deep;");
  }
  const std::string dotted = repeated("a.", ten_megabytes);
  for (const std::string& key : {dotted + "a = 1\n", "[" + dotted + "a]\n"}) {
    check_refused(key, "f.toml:1: key too deep;");
  }
  check_refused(std::string(ten_megabytes, 'a') + " = 1\n", "f.toml:1: unknown key;");
  check_refused("load = \"" + std::string(ten_megabytes, '1') + "\"\n", "f.toml:1: load: number too long;");
  check_refused("load = " + std::string(ten_megabytes, '1') + "\n", "f.toml:1: not TOML;");
  check_refused(std::string(ten_megabytes, '\0'), "f.toml:1: not TOML;");
  check_refused(R"(load = """)" + std::string(ten_megabytes, '\n'), "f.toml:10485760: not TOML;");
  check_refused(std::string(ten_megabytes, '\n'), "f.toml:1: load: missing;");
  check_refused(repeated("a = []\n", ten_megabytes), "f.toml:");
  check_refused("load = \"1\xff\"\n", "f.toml:1: not UTF-8;");
  check_refused(std::string("load = 1\n\0\n", 11), "f.toml:2: not TOML;");
  check_refused(std::string(65 << 20, ' '), "f.toml:1: file too large; a problem file has at most 64 MiB;");
}

TEST_CASE("profiles with too large polynomials are refused") {
  const std::string friction = "values = [0.1]\n";
  check_refused(problem_with(friction, "profile = \"((((1e400)^64)^64)^64)*x\"\n"),
                "f.toml:7: indenter.profile: coefficient too large at character 11;");
  check_refused(problem_with(friction, "profile = \"" + std::string(ten_megabytes, '(') + "\"\n"),
                "f.toml:7: indenter.profile: polynomial too long;");
  std::string pieces = "pieces = [\n";
  for (int k = 1; k <= 1000; ++k) {
    pieces += "{to = \"" + std::to_string(k) + "e-3\", profile = \"(x+" + std::to_string(k) + "/3)^64" +
              repeated("*1.01", 9000) + "\"},\n";
  }
  check_refused(problem_with(friction, pieces + "]\n"), "f.toml:");
}

TEST_CASE("the most complicated pieces that are accepted do not take long") {
  std::string pieces = "support = [0, 1]\npieces = [\n";
  const std::string digits(395, '7');
  for (int k = 0; k < 40; ++k) {
    pieces += "{to = \"" + (k == 39 ? "1" : "0." + std::to_string(k + 10) + digits) + "\", profile = \"(x+0." +
              std::string(18, '3') + ")^64\"},\n";
  }
  out_of(run_limited(problem_with("values = [0.1]\n", pieces + "]\n")));
}

TEST_CASE("traces of ten megabytes of noise are refused") {
  const auto refused = [](const std::string& trace, const char* why) {
    check_refusal(run_with_trace(trace), std::string("t.csv:") + why);
  };
  refused(noise(""), "");
  std::string bytes = noise("0123456789.,-e/ ;\t#");
  refused(bytes, "1: line too long;");
  for (std::size_t k = 0; k < bytes.size(); k += 9) bytes[k] = '\n';
  refused(bytes, "");
  for (const char c : {'\0', '1', ','}) refused(std::string(ten_megabytes, c), "1: line too long;");
  refused(std::string(ten_megabytes, '\n'), "10485760: too few points;");
  refused(repeated("#\n", ten_megabytes), "5242880: too few points;");
  refused(repeated("1,1\n", ten_megabytes), "2: x: not increasing;");
  refused(std::string(65 << 20, '\n'), "1: file too large; a trace has at most 64 MiB; more\n");
}

TEST_CASE("a trace whose exact heights would fill the memory is refused") {
  std::string trace;
  for (int k = 0; trace.size() < ten_megabytes; ++k) {
    trace += std::to_string(k) + (k % 2 == 0 ? ",1e-400\n" : ",1e400\n");
  }
  check_refusal(run_with_trace(trace), "t.csv:740969: trace too complicated; all numbers together are limited in ");
}

TEST_CASE("a trace of a hundred thousand points with all digits of a double is read") {
  std::mt19937_64 generator(1);
  const auto digits = [&] { return std::to_string(generator() % 90000000000000000 + 10000000000000000); };
  std::string trace = "x,psi\n";
  constexpr int points = 100000;
  for (int k = 0; k < points; ++k) trace += std::to_string(k) + "." + digits() + ",0." + digits() + "\n";
  // A header, four ends, a wedge at every point between the ends, two free ends.
  CHECK(lines(out_of(run_with_trace(trace))).size() == 1 + 4 + (points - 2) + 2);
}
