// Stresses below the surface, nodal forces and the largest stress in the program's output: compared with each other,
// proved and estimated, for every method and at many digits.

#include "app/json_answers.hpp"

namespace {

const std::string coated =
    "load = 2\n[half_space]\npoisson = 0.3\nyoung = 3\n[friction]\nvalues = [0.2, 0.6]\njumps = [0.1]\n[indenter]\n"
    "profile = 0\n";

const std::string reduced =
    "load = 2\n[half_space]\ngamma = 0.25\n[friction]\nvalues = [0.2]\n[indenter]\nprofile = 0\n";

Json fields_of(const Arguments& arguments, const std::string& problem = coated) {
  const TemporaryFolder folder{{"p.toml", problem},
                               {"points.csv", "x,z\n0.05,0.25\n-1,1e-6\n1.5,1/3\n"},
                               {"mesh.csv", "x,order\n-1,2\n-0.25,2\n0.5,2\n1,2\n1.5,2\n"}};
  const Arguments files{"solve", "p.toml", "--format", "json", "--stress-at", "points.csv", "--loads-on", "mesh.csv"};
  return Json::parse(out_of(folder.run(joined(files, arguments))));
}

double real_at(const Json& object, const std::string& key) { return real(object.at(key)); }
double error(const Json& number) { return std::stod(number.back().get<std::string>()); }
double error_at(const Json& object, const std::string& key) { return error(object.at(key)); }

/// Compares all numbers of an object, and of the objects in it.
void check_agree(const Json& a, const Json& b, double relative) {
  sum_over_numbers(a, b, [&](const Json& one, const Json& other) {
    CHECK(std::abs(real(one) - real(other)) <= error(one) + error(other) + relative * std::abs(real(other)));
    return 1;
  });
}

void check_same(const Json& a, const Json& b, double relative = 1e-15) {
  REQUIRE(a.at("stresses").size() == 3);
  REQUIRE(a.at("nodal_forces").size() == 5);
  for (std::size_t i = 0; i < 3; ++i) check_agree(a["stresses"][i], b["stresses"][i], relative);
  for (std::size_t i = 0; i < 5; ++i) check_agree(a["nodal_forces"][i], b["nodal_forces"][i], relative);
}

}  // namespace

TEST_CASE("stresses at depths beyond the range of double are computed with more digits") {
  const auto stress_at = [](const std::string& depth) {
    const TemporaryFolder folder{{"p.toml", coated}, {"points.csv", "x,z\n0.1," + depth + "\n"}};
    const Finished finished = folder.run({"solve", "p.toml", "--format", "json", "--stress-at", "points.csv"});
    return Json::parse(out_of(finished)).at("stresses").at(0);
  };
  // Beside a friction jump the stresses are a constant plus a power of the depth: each decade changes them by a factor.
  const auto factor = [&](int decade) {
    const auto sxx = [&](int power) { return real_at(stress_at("1e-" + std::to_string(power)), "sxx"); };
    return (sxx(decade + 2) - sxx(decade + 1)) / (sxx(decade + 1) - sxx(decade));
  };
  const double per_decade = factor(40);
  CHECK(std::abs(per_decade - 1) > 0.05);
  for (const int decade : {152, 154, 320, 397}) CHECK(factor(decade) == doctest::Approx(per_decade).epsilon(1e-10));
}

TEST_CASE("proved stresses, gradients and nodal forces agree with the estimated ones within both errors") {
  const Json estimated = fields_of({}), proved = fields_of({"--certify"});
  check_same(estimated, proved);
  check_same(fields_of({"--method", "riemann-hilbert"}), proved);
  check_same(fields_of({"--digits", "40"}), proved);
  CHECK(error_at(proved["stresses"][0], "sxx") < 1e-13);
  // Control: with another load the numbers differ.
  const Json heavier = fields_of({}, replaced(coated, "load = 2", "load = 2.001"));
  CHECK(std::abs(real_at(heavier["stresses"][0], "szz") - real_at(proved["stresses"][0], "szz")) > 1e-4);
}

TEST_CASE("stresses on cells agree to a percent, and their errors have the right size") {
  const Json proved = fields_of({"--certify"}), cells = fields_of({"--method", "variational"});
  for (const std::size_t i : {0u, 2u}) {
    for (const char* key : {"sxx", "szz", "von_mises"}) {
      const Json &a = cells["stresses"][i], &b = proved["stresses"][i];
      CHECK(real_at(a, key) == doctest::Approx(real_at(b, key)).epsilon(0.01));
      CHECK(error_at(a, key) < 0.5 * std::abs(real_at(b, "szz")));
    }
  }
  double sum = 0;
  for (const Json& force : cells["nodal_forces"]) sum += real_at(force, "normal");
  CHECK(sum == doctest::Approx(2).epsilon(1e-13));
}

TEST_CASE("reduced data have no stress out of the plane, no von Mises stress and no gradient") {
  const Json stress = fields_of({}, reduced)["stresses"][0];
  CHECK(value_of(stress.at("syy")).is_null());
  CHECK(value_of(stress.at("von_mises")).is_null());
  CHECK(value_of(stress.at("displacement_gradient").at("dux_dx")).is_null());
  CHECK(real_at(stress, "largest_shear") > 0);
}

TEST_CASE("the largest stress: its place, its depth, and where there is no bound") {
  const Json largest = fields_of({"--max-stress"}).at("largest_stress");
  CHECK(largest.at("depth") == "0.02");
  REQUIRE(largest.at("unbounded_at").size() == 3);
  CHECK(value_of(largest.at("unbounded_at")[1]) == "0.1");
  CHECK(real_at(largest, "z") >= 0.02);
  const Json deeper = fields_of({"--max-stress", "--depth", "1/10"}).at("largest_stress");
  CHECK(real_at(deeper, "z") >= 0.1);
  CHECK(real_at(deeper, "von_mises") < real_at(largest, "von_mises"));
  const std::string text = out_of(run_alone({"solve", "-", "--max-stress"}, coated));
  CHECK(holds(text, "largest von Mises stress\n  inf                   next to x = -1\n"));
  CHECK(holds(text, "(depths from 0.02)"));
  const std::string csv = out_of(run_alone({"solve", "-", "--max-stress", "--format", "csv"}, coated));
  CHECK(csv.starts_with("depth,von_mises,x,z,over,von_mises_error,x_error,z_error\n0.02,"));
}

TEST_CASE("the largest stress of averages: finite, in every format, and larger over a shorter window") {
  const Json average = fields_of({"--max-stress", "--over", "0.1"}).at("largest_stress").at("average");
  CHECK(average.at("over") == "0.1");
  CHECK(error_at(average, "von_mises") < 1e-9);
  const Json shorter = fields_of({"--max-stress", "--over", "0.01"}).at("largest_stress").at("average");
  CHECK(real_at(shorter, "von_mises") > real_at(average, "von_mises"));
  CHECK_FALSE(fields_of({"--max-stress"}).at("largest_stress").contains("average"));
  const std::string text = out_of(run_alone({"solve", "-", "--max-stress", "--over", "0.1"}, coated));
  CHECK(holds(text, "\nlargest von Mises stress of averages over 0.1 along x\n"));
  const auto csv = lines(out_of(run_alone(words("solve - --max-stress --over 0.1 --format csv"), coated)));
  REQUIRE(csv.size() == 3);
  CHECK(csv[2].starts_with("0," + std::string(value_of(average.at("von_mises")))));
  CHECK(holds(csv[2], ",0.1,"));
}

TEST_CASE("with a proof the text calls the largest stress a lower bound") {
  // The largest stress below the middle of a smooth contact without friction, at the surface under friction, and beside
  // edges.
  const std::string smooth =
      "load = 0.1\n[half_space]\npoisson = 0.3\nyoung = 1\n[friction]\nvalues = [0]\n"
      "[indenter]\nprofile = \"x^2/2\"\n";
  for (const auto& [problem, place] :
       {std::pair(smooth, "z = 0."), {replaced(smooth, "[0]", "[0.9]"), "z = 2e-15"}, {coated, "z = 0.02"}}) {
    CAPTURE(problem);
    const Json found = fields_of({"--max-stress"}, problem).at("largest_stress");
    const Json proved = fields_of({"--max-stress", "--certify"}, problem).at("largest_stress");
    CHECK(proved.at("proved") == "lower bound");
    CHECK_FALSE(found.contains("proved"));
    CHECK(keys(proved.at("von_mises")) == "mid rad");
    CHECK(real_at(proved, "von_mises") == doctest::Approx(real_at(found, "von_mises")).epsilon(1e-5));
    CHECK(number(proved.at("von_mises")) <= number(found.at("von_mises")) * (1 + 1e-12_r));
    const std::string text = out_of(run_alone({"solve", "-", "--max-stress", "--certify"}, problem));
    CHECK(holds(text, place));
    CHECK(holds(text, "  proved of this place; that no other one has more is not\n"));
  }
}

TEST_CASE("fields that the problem or the method does not have are refused") {
  check_refused(
      run_alone({"solve", "-", "--max-stress"}, reduced),
      "command line: --max-stress: no von Mises stress; it needs the half-space's poisson in place of gamma; '-'");
  const TemporaryFolder folder{{"p.toml", coated}, {"points.csv", "0,1\n"}};
  check_refused(folder.run({"solve", "p.toml", "--certify", "--method", "variational", "--stress-at", "points.csv"}),
                "command line: --certify: method without proved stresses and nodal forces; with them it goes with "
                "closed-form and riemann-hilbert; '--method variational'");
}

TEST_CASE("both directions: the fields of the other one are those of a file with that direction") {
  const TemporaryFolder folder;
  folder.write("p.csv", "0.1,0.1\n-0.5,0.2\n");
  const std::string points = (folder.path() / "p.csv").string();
  for (const Arguments& field : {Arguments{"--stress-at", points}, words("--max-stress --depth 0.1")}) {
    const Arguments options = joined(field, {"--format", "csv"});
    const auto both = lines(out_of(run_example("two_coatings_forward.toml", joined(options, {"--both-directions"}))));
    const auto backward = lines(out_of(run_example("two_coatings_backward.toml", options)));
    const std::size_t rows = backward.size() - 1;
    REQUIRE(both.size() == 1 + 2 * rows);
    for (std::size_t k = 1; k <= rows; ++k) {
      CHECK(both[rows + k] == "-x," + backward[k]);
      CHECK(both[k] != "+x," + backward[k]);  // the control
    }
  }
}
