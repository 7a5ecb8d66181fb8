#include "library/problem_file/profile_trace.hpp"
#include "library/problem_file/file_error.hpp"
#include "support/rows.hpp"

using namespace steadyslide::library;

namespace {

ProfileTrace read_trace(const std::string& text) { return parse_trace(text, "t.csv", std::nullopt); }

bool same(const ProfileTrace& a, const ProfileTrace& b) {
  return a.points == b.points && a.range.left == b.range.left && a.range.right == b.range.right &&
         std::equal(a.pieces.begin(), a.pieces.end(), b.pieces.begin(), b.pieces.end(),
                    [](const auto& p, const auto& q) { return p.to == q.to && p.profile == q.profile; });
}

const std::string plain_trace = "-1,0.5\n0,0\n2,1/3\n";

/// `plain_trace`, cut off at `right`.
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
    CHECK_MESSAGE(same(read_trace(text), trace), text);
  }
  // Each of these differs: in a value, in a place, by one more point.
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
  auto traces = rows_of(STEADYSLIDE_TESTS "/library/problem_file/bad_traces.json");
  CHECK(traces.size() >= 20);
  traces.emplace_back("0,1\n1," + long_number + "\n",
                      "2: psi: number too long; a number has at most 400 characters; 401 characters");
  traces.emplace_back("0,1\n" + std::string(1001, ' ') + "\n",
                      "2: line too long; a line of a trace has at most 1000 characters; 1001 characters");
  for (const auto& row : traces) {
    CHECK_THROWS_WITH_AS_MESSAGE(read_trace(row.first), ("t.csv:" + row.second).c_str(), InvalidFile, row.first);
  }
  // A line of the largest allowed length.
  CHECK_NOTHROW(read_trace("0,1\n" + std::string(1000, ' ') + "\n1,2\n"));
  CHECK_NOTHROW(read_trace("0,1\n1," + long_number.substr(1) + "\n"));
  CHECK_NOTHROW(read_trace("0,1\n1e400,1\n"));
}

namespace {

struct TracePoint {
  Rational x, height;
};

std::string text_of(const std::vector<TracePoint>& points) {
  std::string text;
  for (const auto& [x, height] : points) text += to_string(x) + "," + to_string(height) + "\n";
  return text;
}

/// Returns the heights at the points, from the pieces beside them.
std::vector<Rational> heights_of(const ProfileTrace& trace, const std::vector<TracePoint>& points) {
  std::vector<Rational> heights{trace.pieces.front().profile(points.front().x)};
  for (std::size_t i = 1; i < points.size(); ++i) heights.push_back(trace.pieces[i - 1].profile(points[i].x));
  return heights;
}

std::vector<TracePoint> random_points() {
  const int count = uniform(2, 12);
  std::vector<TracePoint> points;
  Rational x = uniform(-50, 50);
  for (int i = 0; i < count; ++i) {
    points.push_back({x, Rational(uniform(-1000, 1000), 100)});
    x += Rational(uniform(1, 300), 100);
  }
  return points;
}

/// Returns sums over the remaining heights: of heights, and of heights times x.
std::pair<Rational, Rational> moments(const std::vector<Rational>& heights, const std::vector<TracePoint>& points) {
  Rational sum = 0, first = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    sum += heights[i];
    first += heights[i] * points[i].x;
  }
  return {sum, first};
}

}  // namespace

TEST_CASE("heights are turned and brought into another unit exactly") {
  REQUIRE(rc::check([] {
    const std::vector<TracePoint> points = random_points();
    const Rational factor(uniform(-30, 30), 1000);
    const auto scaled = parse_trace(text_of(points), "t.csv", std::nullopt, {factor, Detrend::none});
    const std::vector<Rational> found = heights_of(scaled, points);
    for (std::size_t i = 0; i < points.size(); ++i) RC_ASSERT(found[i] == factor * points[i].height);
    RC_ASSERT(!scaled.trend);
  }));
}

TEST_CASE("what is left after the mean has none, after the line neither mean nor slope; only a line is taken off") {
  REQUIRE(rc::check([] {
    const std::vector<TracePoint> points = random_points();
    for (const Detrend kind : {Detrend::mean, Detrend::line}) {
      const auto trace = parse_trace(text_of(points), "t.csv", std::nullopt, {1, kind});
      const std::vector<Rational> left = heights_of(trace, points);
      RC_ASSERT(trace.trend.has_value());
      RC_ASSERT(trace.trend->kind == kind);
      for (std::size_t i = 0; i < points.size(); ++i) {
        RC_ASSERT(left[i] == points[i].height - trace.trend->height - trace.trend->slope * points[i].x);
      }
      // Exact, unless a number of the trend is longer than 128 bits and was rounded to 20 digits.
      const auto [sum, first] = moments(left, points);
      const Rational rounding = 1e-13_r;
      RC_ASSERT(abs(sum) <= rounding);
      if (kind == Detrend::mean) RC_ASSERT(sum == 0);
      if (kind == Detrend::line) RC_ASSERT(abs(first) <= rounding);
      // The control: with another line the sums are not zero.
      std::vector<Rational> other = left;
      for (std::size_t i = 0; i < points.size(); ++i) other[i] += points[i].x / 1000000 + 1;
      if (kind == Detrend::line && points.size() > 2) RC_ASSERT(moments(other, points).first != first);
    }
  }));
}

TEST_CASE("a line of least squares, by hand; the support changes nothing of it") {
  const std::string text = "0,1\n1,0\n2,5\n";  // slope 2, mean 2
  for (const auto& support : {std::optional<Support>(), std::optional(Support{Rational(1, 2), Rational(3, 2)})}) {
    const auto trace = parse_trace(text, "t.csv", support, {1, Detrend::line});
    REQUIRE(trace.trend);
    CHECK(trace.trend->height == 0);
    CHECK(trace.trend->slope == 2);
    CHECK(trace.pieces.front().profile == Polynomial({1, -3}));
    CHECK(trace.pieces.back().profile == Polynomial({-5, 3}));
  }
  CHECK(parse_trace(text, "t.csv", std::nullopt, {-2, Detrend::mean}).trend->height == -4);
}

TEST_CASE("long numbers of a trend are rounded to 20 digits, those without a common denominator refused") {
  std::string seventeen;
  for (int k = 0; k < 1000; ++k) {
    const std::string digits = std::to_string(k * 7919 % 1009 + 1000);
    seventeen += std::to_string(k) + ".0123456789012345" + digits + ",0.1234567890123" + digits + "\n";
  }
  const auto trace = parse_trace(seventeen, "t.csv", std::nullopt, {1, Detrend::line});
  REQUIRE(trace.trend);
  const std::string slope = to_string(trace.trend->slope);
  CAPTURE(slope);
  CHECK(slope.find('/') == 20);
  CHECK(slope.substr(20, 2) == "/1");
  CHECK(slope.find_first_not_of('0', 22) == slope.npos);

  std::string unrelated;
  for (int k = 0; k < 3000; ++k) unrelated += std::to_string(k) + ",1/" + std::to_string(100003 + 2 * k) + "\n";
  CHECK(parse_trace(unrelated, "t.csv", std::nullopt).points == 3000);
  const std::string refused = thrown_by([&] { parse_trace(unrelated, "t.csv", std::nullopt, {1, Detrend::mean}); });
  CHECK(refused.starts_with("t.csv:"));
  CHECK(refused.ends_with(": trace too complicated to detrend; sums over its numbers are limited in digits; more"));
}

TEST_CASE("a spline goes through all points, and has neither wedges nor steps") {
  REQUIRE(rc::check([] {
    const std::vector<TracePoint> points = random_points();
    const auto trace =
        parse_trace(text_of(points), "t.csv", std::nullopt, {1, Detrend::none, {}, Interpolation::spline});
    const std::vector<Rational> found = heights_of(trace, points);
    for (std::size_t i = 0; i < points.size(); ++i) RC_ASSERT(found[i] == points[i].height);
    const Indenter spline(trace.range.left, trace.pieces);
    RC_ASSERT(spline.is_smooth());
    for (const Indenter::Break& at : spline.breaks()) RC_ASSERT(at.derivative() == 0);
    for (const Indenter::Piece& piece : spline.pieces()) RC_ASSERT(piece.profile.degree() <= 3);
    // The control: straight lines have wedges, unless all points lie on one line. The parentheses keep RC_ASSERT from
    // evaluating each side.
    const Indenter lines(trace.range.left, parse_trace(text_of(points), "t.csv", std::nullopt).pieces);
    RC_ASSERT((points.size() == 2 || !lines.is_smooth() || lines.pieces()[0].profile == lines.pieces()[1].profile));
  }));
}

TEST_CASE("a spline of two points is their line; a support cuts a spline, and does not change it") {
  const Heights spline{1, Detrend::none, {}, Interpolation::spline};
  CHECK(same(parse_trace("0,1/3\n3,1\n", "t.csv", std::nullopt, spline), read_trace("0,1/3\n3,1\n")));
  const auto whole = parse_trace("-1,0.5\n0,0\n2,1/3\n3,1\n", "t.csv", std::nullopt, spline);
  const auto cut = parse_trace("-1,0.5\n0,0\n2,1/3\n3,1\n", "t.csv", Support{-0.5_r, 1.5_r}, spline);
  REQUIRE(cut.pieces.size() == 2);
  CHECK(cut.pieces[0].profile == whole.pieces[0].profile);
  CHECK(cut.pieces[1].profile == whole.pieces[1].profile);
  CHECK(cut.pieces[1].to == 1.5_r);
}

TEST_CASE("the trend is subtracted before the filter, and filtered heights are joined") {
  // A line alone: nothing is left of it, although a filter bends a line near its ends.
  std::string line;
  for (int k = 0; k <= 20; ++k) line += std::to_string(k) + "," + std::to_string(3 * k + 1) + "\n";
  const auto detrended = parse_trace(line, "t.csv", std::nullopt, {1, Detrend::line, 8_r});
  for (const Indenter::Piece& piece : detrended.pieces) CHECK(piece.profile == Polynomial());
  const auto bent = parse_trace(line, "t.csv", std::nullopt, {1, Detrend::none, 8_r});
  CHECK(bent.pieces.front().profile(0) > 1.5_r);
  CHECK(bent.pieces.front().profile(1) > 5);
  CHECK(abs(bent.pieces[10].profile(10) - 31) < 1e-13_r);
  CHECK(bent.points == 21);
}

TEST_CASE("a cutoff that does not fit the points, and numbers beyond double, are refused") {
  const auto refused = [](const std::string& text, const Heights& heights) {
    return thrown_by([&] { parse_trace(text, "t.csv", std::nullopt, heights); });
  };
  const std::string text = "0,1\n1,0\n3,5\n8,1\n";
  CHECK(refused(text, {1, Detrend::none, 8.5_r}) ==
        "cutoff longer than the trace; it is at most the length of the trace, 8; 8.5");
  CHECK(refused(text, {1, Detrend::none, 1_r}) ==
        "cutoff too short; it is at least twice the longest distance between points, 10; 1");
  CHECK(refused("0,1\n1,0\n3,5\n4,1\n", {1, Detrend::none, 4_r}) == "no error");
  CHECK(refused("0,1\n1,0\n", {1, Detrend::none, 1_r}) ==
        "cutoff too short; it is at least twice the longest distance between points, 2; 1");
  const Heights spline{1, Detrend::none, {}, Interpolation::spline};
  for (const char* beyond : {"0,1\n1,1e400\n2,0\n", "0,1\n1e-400,2\n2,0\n", "0,1\n1,1e308\n2,-1e308\n"}) {
    CHECK(refused(beyond, spline) ==
          "t.csv:3: numbers out of range; a filter and a spline are computed in double; beyond it");
  }
  CHECK(refused("0,1\n1,1e400\n2,0\n", {1, Detrend::none, 2_r}) ==
        "t.csv:3: numbers out of range; a filter and a spline are computed in double; beyond it");
}
