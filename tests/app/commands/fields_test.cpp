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
double error(const Json& number) { return std::stod(text_of(number.back())); }
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
  CHECK(real_at(largest, "depth") == 0.02);
  REQUIRE(largest.at("unbounded_at").size() == 3);
  CHECK(real(largest.at("unbounded_at")[1]) == 0.1);
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
  CHECK(average.at("over") == 0.1);
  CHECK(error_at(average, "von_mises") < 1e-9);
  const Json shorter = fields_of({"--max-stress", "--over", "0.01"}).at("largest_stress").at("average");
  CHECK(real_at(shorter, "von_mises") > real_at(average, "von_mises"));
  CHECK_FALSE(fields_of({"--max-stress"}).at("largest_stress").contains("average"));
  const std::string text = out_of(run_alone({"solve", "-", "--max-stress", "--over", "0.1"}, coated));
  CHECK(holds(text, "\nlargest von Mises stress of averages over 0.1 along x\n"));
  const auto csv = lines(out_of(run_alone(words("solve - --max-stress --over 0.1 --format csv"), coated)));
  REQUIRE(csv.size() == 3);
  CHECK(csv[2].starts_with("0," + text_of(value_of(average.at("von_mises")))));
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

TEST_CASE("stresses at the surface are those of the traction, and the limits of stresses below it") {
  const TemporaryFolder folder{{"p.toml", coated}, {"points.csv", "0.5,0\n0.5,1e-9\n1.5,0\n-1,0\n"}};
  const Json json = Json::parse(
      out_of(folder.run({"solve", "p.toml", "--stress-at", "points.csv", "--at", "0.5", "--format", "json"})));
  const Json &surface = json["stresses"][0], &below = json["stresses"][1], &sample = json["samples"][0];
  CHECK(surface["z"] == 0);
  CHECK(real_at(surface, "szz") == real_at(sample, "traction"));
  CHECK(real_at(surface, "sxz") == -real_at(sample, "shear"));
  for (const char* key : {"sxx", "szz", "sxz", "syy", "von_mises", "largest_shear"}) {
    CHECK(real_at(surface, key) == doctest::Approx(real_at(below, key)).epsilon(1e-6));
  }
  CHECK(real_at(json["stresses"][2], "szz") == 0);
  CHECK(value_of(json["stresses"][3]["szz"]) == "-inf");
  CHECK(value_of(json["stresses"][3]["von_mises"]).is_null());
}

TEST_CASE("displacements: u at the surface, its sign, its zero, and both directions") {
  const TemporaryFolder folder{{"p.toml", coated}, {"points.csv", "x,z\n0,0\n0.5,0\n-2,0\n0.5,0.25\n0.5,0.251\n"}};
  const Arguments files{"solve", "p.toml", "--displacement-at", "points.csv"};
  for (const char* method : {"auto", "riemann-hilbert", "variational"}) {
    CAPTURE(method);
    const Json json = Json::parse(out_of(folder.run(
        joined(files, {"--method", method, "--at=0,0.5,-2", "--stress-at", "points.csv", "--format", "json"}))));
    const Json &moved = json["displacements"], &stress = json["stresses"];
    REQUIRE(moved.size() == 5);
    for (const std::size_t k : {0U, 1U, 2U}) {
      const double u = real_at(json["samples"][k], "u");
      CHECK(std::abs(real_at(moved[k], "uz") + u) <=
            error_at(moved[k], "uz") + error_at(json["samples"][k], "u") + 1e-14);
    }
    CHECK(real_at(moved[0], "ux") == 0);
    // The gradient of the stresses, by a difference.
    for (const auto& [key, slope] : {std::pair("ux", "dux_dz"), {"uz", "duz_dz"}}) {
      const double difference = (real_at(moved[4], key) - real_at(moved[3], key)) / 0.001;
      CHECK(difference == doctest::Approx(real_at(stress[3]["displacement_gradient"], slope)).epsilon(0.02));
    }
  }
  const auto rows = lines(out_of(folder.run(joined(files, {"--format", "csv", "--both-directions"}))));
  REQUIRE(rows.size() == 11);
  CHECK(rows[0] == "sliding,x,z,ux,uz,ux_error,uz_error");
  CHECK(rows[2].starts_with("+x,0.5,0,"));
  CHECK(rows[7].starts_with("-x,0.5,0,"));
  CHECK(rows[2].substr(2) != rows[7].substr(2));
  CHECK(holds(out_of(folder.run(files)), "displacements of the body (along x, into the body; 0 where u is 0)\n  x "));
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
