#include "library/problem_file/profile_trace.hpp"
#include "library/problem_file/file_error.hpp"
#include "support/test.hpp"

using namespace steadyslide::library;

namespace {

ProfileTrace read_trace(const std::string& text) { return parse_trace(text, "t.csv", std::nullopt); }

bool same(const ProfileTrace& a, const ProfileTrace& b) {
  return a.points == b.points && a.range.left == b.range.left && a.range.right == b.range.right &&
         std::equal(a.pieces.begin(), a.pieces.end(), b.pieces.begin(), b.pieces.end(),
                    [](const auto& p, const auto& q) { return p.to == q.to && p.profile == q.profile; });
}

/// "" if the trace is accepted.
std::string complaint(const std::string& text) {
  try {
    read_trace(text);
  } catch (const InvalidFile& invalid) {
    return invalid.what();
  }
  return "";
}

const std::string plain_trace = "-1,0.5\n0,0\n2,1/3\n";

/// Of `plain_trace`, cut off at `right`.
void check_joined_at_0(const ProfileTrace& trace, const Rational& right) {
  CHECK(trace.points == 3);
  CHECK(trace.range.left == -1);
  CHECK(trace.range.right == 2);
  REQUIRE(trace.pieces.size() == 2);
  CHECK(trace.pieces[0].to == 0);
  CHECK(trace.pieces[0].profile == Polynomial({0, Rational(-1, 2)}));
  CHECK(trace.pieces[1].to == right);
  CHECK(trace.pieces[1].profile == Polynomial({0, Rational(1, 6)}));
}

}  // namespace

TEST_CASE("points are joined by exact straight lines") { check_joined_at_0(read_trace(plain_trace), 2); }

TEST_CASE("neighbours on one line stay as they are read") { CHECK(read_trace("0,1\n1,2\n2,3\n").pieces.size() == 2); }

TEST_CASE("the same trace, written in other ways") {
  const ProfileTrace trace = read_trace(plain_trace);
  for (const char* text :
       {"x,psi\n-1,0.5\n0,0\n2,1/3\n", "-1,0.5\r\n0,0\r\n2,1/3\r\n", "\xef\xbb\xbf-1,0.5\n0,0\n2,1/3",
        "\xef\xbb\xbfx,psi\r\n-1,0.5\r\n0,0\r\n2,1/3", "-1;0.5\n0;0\n2;1/3\n", "-1\t0.5\n0\t0\n2\t1/3\n",
        "  -1   0.5  \n0 \t 0\n 2 1/3\n", "-1 , 5e-1\n 0,\t0\n+2.,1/3\n",
        "# measured\n\n  # today\nx (mm); psi (\xb5m)\n-1;.5 # the left end\n\n0;-0\n2;1/3\n#\n",
        "position height quality\n-1 0.5\n0 0\n2 1/3\n", "\"x\",\"psi\"\n-1,0.5\n0,0\n2,1/3\n"}) {
    CAPTURE(text);
    CHECK(same(read_trace(text), trace));
  }
  // What the comparison tells apart: a value, a place, a point more.
  for (const char* text : {"-1,0.5\n0,0\n2,1/4\n", "-1,0.5\n0.5,0\n2,1/3\n", "-1,0.5\n0,0\n2,1/3\n3,0\n"}) {
    CHECK_FALSE(same(read_trace(text), trace));
  }
}

TEST_CASE("a support cuts the trace, exactly") {
  const auto cut = [](const char* left, const char* right) {
    return parse_trace(plain_trace, "t.csv", Support{parse_rational(left), parse_rational(right)});
  };
  check_joined_at_0(cut("-1/3", "1"), 1);

  CHECK(same(cut("-1", "2"), read_trace(plain_trace)));
  CHECK(cut("0", "2").pieces.size() == 1);
  CHECK(cut("-1", "0").pieces.size() == 1);
  REQUIRE(cut("0.5", "1").pieces.size() == 1);
  CHECK(cut("0.5", "1").pieces[0].to == 1);
}

TEST_CASE("bad traces: the whole message") {
  const std::string long_number(401, '1');
  auto traces = sections_of(STEADYSLIDE_TESTS "/library/problem_file/bad_traces.txt");
  CHECK(traces.size() >= 20);
  traces.insert(
      traces.end(),
      {{"2: psi: number too long; a number has at most 400 characters; 401 characters", "0,1\n1," + long_number + "\n"},
       {"2: line too long; a line of a trace has at most 1000 characters; 1001 characters",
        "0,1\n" + std::string(1001, ' ') + "\n"},
       {"2: not a text; a trace has no NUL bytes; '1,\\x002'", std::string("0,1\n1,\0", 7) + "2\n"},
       {"1: not a text; a trace has no NUL bytes; '\\x00'", std::string("\0", 1)}});
  for (const auto& [message, text] : traces) CHECK_MESSAGE(complaint(text) == "t.csv:" + message, text);
  // As long as it may be.
  CHECK(complaint("0,1\n" + std::string(1000, ' ') + "\n1,2\n") == "");
  CHECK(complaint("0,1\n1," + long_number.substr(1) + "\n") == "");
  CHECK(complaint("0,1\n1e400,1\n") == "");
}
