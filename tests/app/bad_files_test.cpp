// Bad problem files: the whole message and the exit code of each, and no output file.

#include "app/command_line.hpp"

using namespace steadyslide::testing;

namespace {

struct BadFile {
  std::string text;
  std::string message;  ///< after "steadyslide: bad.toml:"
};

const std::string half_space = "[half_space]\npoisson = \"0.3\"\n";
const std::string friction = "[friction]\nvalues = [\"0.2\"]\n";
const std::string indenter = "[indenter]\nprofile = \"0\"\n";
const std::string body = "load = \"1\"\n" + half_space;  // lines 1 to 3
const std::string body_and_friction = body + friction;   // lines 1 to 5
const std::string number_rule = "a number is written like 2, -0.25, 1e-3 or 1/3";
const std::string shape_rule = "an indenter has exactly one of profile, pieces, samples";
const std::string trace_rule = "it names a file, relative to the problem file";
const std::string type_rule = "a number is a string, an integer or a decimal";
const std::string gamma_rule = "with half_space.gamma the data are reduced and this is left out";

const std::vector<BadFile> bad_files{
    // No TOML.
    {"load = ",
     "1: not TOML; a problem file is written in TOML; Error while parsing key-value pair: encountered "
     "end-of-file"},
    {"load = \"1\"\nload = \"2\"\n",
     "2: not TOML; a problem file is written in TOML; Error while parsing key-value "
     "pair: cannot redefine existing string 'load'"},
    {"load = \"1\n",
     "1: not TOML; a problem file is written in TOML; Error while parsing string: unescaped "
     "control characters other than TAB (U+0009) are explicitly prohibited"},
    // Keys.
    {"", "1: load: missing; a problem has a load; absent"},
    {"load = \"1\"\n", "1: half_space: missing; the table is required; absent"},
    {"lode = \"1\"\n",
     "1: unknown key; the keys of a problem file are load, load_at, sliding, half_space, friction, "
     "indenter; 'lode'"},
    {body + "poison = 1\n" + friction + indenter,
     "4: unknown key; the keys of half_space are poisson, young, plane, gamma; 'poison'"},
    {body_and_friction + "jump = []\n" + indenter, "6: unknown key; the keys of friction are values, jumps; 'jump'"},
    {body_and_friction + indenter + "\n\"two\\nlines\" = 1\n",
     "9: unknown key; the keys of indenter are support, profile, pieces, samples, elastic; 'two\\x0alines'"},
    {body + "[friction]\n" + indenter, "4: friction.values: missing; friction has values; absent"},
    {body + indenter, "1: friction: missing; the table is required; absent"},
    {body_and_friction, "1: indenter: missing; the table is required; absent"},
    {"load = 1\nhalf_space = 3\n", "2: half_space: wrong type; it is a table; an integer"},
    {"load = 1\n[half_space]\nyoung = 2\n" + friction + indenter,
     "2: half_space.poisson: missing; half_space has poisson or gamma; absent"},
    // Numbers.
    {"load = \"one\"\n", "1: load: not a number; " + number_rule + "; 'one'"},
    {"load = \"\"\n", "1: load: not a number; " + number_rule + "; ''"},
    {"load = \"1 \"\n", "1: load: not a number; " + number_rule + "; '1 '"},
    {"load = \"0x10\"\n", "1: load: not a number; " + number_rule + "; '0x10'"},
    {"load = \"1/0\"\n", "1: load: division by zero; the denominator of a number is not zero; '1/0'"},
    {"load = \"1e401\"\n", "1: load: exponent out of range; a decimal exponent is at most 400 in size; '1e401'"},
    {"load = \"" + std::string(401, '1') + "\"\n",
     "1: load: number too long; a number has at most 400 characters; 401 characters"},
    {"load = true\n", "1: load: wrong type; " + type_rule + "; a boolean"},
    {"load = 2020-01-01\n", "1: load: wrong type; " + type_rule + "; a date or time"},
    {"load = [1]\n", "1: load: wrong type; " + type_rule + "; an array"},
    {"load = nan\n", "1: load: not a number; " + number_rule + "; 'nan'"},
    {"load = inf\n", "1: load: not a number; " + number_rule + "; 'inf'"},
    {"load = \"0\"\n" + half_space + friction + indenter, "1: load: load out of range; the load is positive; 0"},
    {"load = \"-1/3\"\n" + half_space + friction + indenter, "1: load: load out of range; the load is positive; -1/3"},
    // The body.
    {"load = 1\n[half_space]\npoisson = 0.5\n" + friction + indenter,
     "3: half_space.poisson: Poisson's ratio out of range; it lies in ]-1, 1/2[; 0.5"},
    {"load = 1\n[half_space]\npoisson = -1\n" + friction + indenter,
     "3: half_space.poisson: Poisson's ratio out of range; it lies in ]-1, 1/2[; -1"},
    {body + "young = 0\n" + friction + indenter,
     "4: half_space.young: Young's modulus out of range; it is positive; 0"},
    {body + "plane = \"bending\"\n" + friction + indenter,
     "4: half_space.plane: unknown plane; it is strain or stress; 'bending'"},
    {body + "plane = 1\n" + friction + indenter, "4: half_space.plane: wrong type; it is a string; an integer"},
    {"load = 1\n[half_space]\ngamma = 1\n" + friction + indenter,
     "3: half_space.gamma: coupling constant out of range; it lies in ]-1, 1[; 1"},
    {body + "gamma = \"2/7\"\n" + friction + indenter,
     "3: half_space.poisson: conflicting key; " + gamma_rule + "; present"},
    {"load = 1\n[half_space]\nyoung = 2\ngamma = \"2/7\"\n" + friction + indenter,
     "3: half_space.young: conflicting key; " + gamma_rule + "; present"},
    {"load = 1\n[half_space]\ngamma = \"2/7\"\n" + friction + indenter + "elastic = {poisson = 0, young = 1}\n",
     "8: indenter.elastic: conflicting key; " + gamma_rule + "; present"},
    {"load = 1\nsliding = \"left\"\n" + half_space + friction + indenter,
     "2: sliding: unknown direction; it is +x or -x; 'left'"},
    // Friction.
    {body + "[friction]\nvalues = [\"0.2\", \"-0.1\"]\njumps = [0]\n" + indenter,
     "5: friction.values[1]: negative friction coefficient; a friction coefficient is at least 0; -0.1"},
    {body + "[friction]\nvalues = [\n  0.2,\n  \"x\"\n]\njumps = [0]\n" + indenter,
     "7: friction.values[1]: not a number; " + number_rule + "; 'x'"},
    {body + "[friction]\nvalues = []\n" + indenter,
     "5: friction.values: no friction value; there is at least one; 0 values"},
    {body + "[friction]\nvalues = 0.2\n" + indenter,
     "5: friction.values: wrong type; it is an array of numbers; a decimal number"},
    {body + "[friction]\nvalues = [1, 2]\n" + indenter,
     "4: friction.jumps: wrong number of jumps; there is one jump fewer than friction values; 2 values, 0 jumps"},
    {body + "[friction]\nvalues = [1, 2, 3]\njumps = [0.5, 0]\n" + indenter,
     "6: friction.jumps[1]: jumps not in order; jumps increase from left to right; 0 after 0.5"},
    {body + "[friction]\nvalues = [1, 2]\njumps = [1]\n" + indenter,
     "6: friction.jumps[0]: jump outside the support; jumps lie in ]-1, 1[; 1"},
    {"load = 1\nload_at = 2\n" + half_space + friction + indenter,
     "2: load_at: load outside the support; the load acts in ]-1, 1[; 2"},
    // The indenter.
    {body_and_friction + "[indenter]\n", "6: indenter: no profile; " + shape_rule + "; none"},
    {body_and_friction + indenter + "samples = \"trace.csv\"\n",
     "8: indenter.samples: conflicting key; " + shape_rule + "; profile and samples"},
    {body_and_friction + "[indenter]\nsamples = 3\n", "7: indenter.samples: wrong type; it is a string; an integer"},
    {body_and_friction + "[indenter]\nsamples = \"none.csv\"\n",
     "7: indenter.samples: no such trace; " + trace_rule + "; none.csv: cannot be read: No such file or directory"},
    {body_and_friction + "[indenter]\nsamples = \"\"\n",
     "7: indenter.samples: no such trace; " + trace_rule + "; : cannot be read: No such file or directory"},
    {body_and_friction + "[indenter]\nsamples = \".\"\n",
     "7: indenter.samples: no such trace; " + trace_rule + "; .: cannot be read: Is a directory"},
    {body_and_friction + "[indenter]\nsamples = \"-\"\n",
     "7: indenter.samples: no such trace; " + trace_rule + "; ./-: cannot be read: No such file or directory"},
    {body_and_friction + "[indenter]\nsamples = \"bad.toml\\u0000\"\n",
     "7: indenter.samples: no such trace; " + trace_rule + "; 'bad.toml\\x00'"},
    {body_and_friction + indenter + "support = [0]\n",
     "8: indenter.support: wrong number of ends; a support is [left, right]; 1 entries"},
    {body_and_friction + indenter + "support = [1, -1]\n",
     "8: indenter.support: support of no length; left is less than right; 1, -1"},
    {body_and_friction + "[indenter]\nprofile = \"x^2 +\"\n",
     "7: indenter.profile: missing value at character 6; expected a number, x or (; 'x^2 +'"},
    {body_and_friction + "[indenter]\nprofile = \"(x^64)^64\"\n",
     "7: indenter.profile: degree too high at character 7; the degree of a profile is at most 64; '(x^64)^64'"},
    {body_and_friction + "[indenter]\nprofile = [0]\n", "7: indenter.profile: wrong type; it is a string; an array"},
    {body_and_friction + "[indenter]\npieces = []\n",
     "7: indenter.pieces: no piece; an indenter has at least one; 0 pieces"},
    {body_and_friction + "[indenter]\npieces = [1]\n",
     "7: indenter.pieces[0]: wrong type; a piece is a table {to, profile}; an integer"},
    {body_and_friction + "[indenter]\npieces = [{to = 1}]\n",
     "7: indenter.pieces[0].profile: missing; a piece has a profile; absent"},
    {body_and_friction + "[indenter]\npieces = [{to = 0, profile = \"x\"}]\n",
     "7: indenter.pieces[0].to: pieces do not fill the support; the last piece ends at the support's right end; 0, not "
     "1"},
    {body_and_friction + "[indenter]\npieces = [\n{to = 0, profile = \"x\"},\n{to = 0, profile = \"x\"},\n{to = 1, "
                         "profile = \"x\"}]\n",
     "9: indenter.pieces[1].to: piece of no length; pieces follow each other from left to right, each with a positive "
     "length; from 0 to 0"},
    {body_and_friction + "[indenter]\npieces = [{to = 0, profile = \"x\"}, {to = 1, profile = \"-x\"}]\nelastic = "
                         "{poisson = 0, young = 1}\n",
     "7: indenter.pieces: elastic indenter with a wedge or a step; the profile of an elastic indenter is smooth; at x "
     "= 0"},
    {body_and_friction + indenter + "elastic = {poisson = 0.7, young = 1}\n",
     "8: indenter.elastic.poisson: Poisson's ratio out of range; it lies in ]-1, 1/2[; 0.7"},
    {body_and_friction + indenter + "elastic = {poisson = 0.2}\n",
     "8: indenter.elastic.young: missing; an elastic indenter has its own Young's modulus; absent"},
};

}  // namespace

TEST_CASE("bad problem files: message, exit code, no output") {
  for (const BadFile& bad : bad_files) {
    CAPTURE(bad.text);
    const TemporaryFolder folder;
    folder.write("bad.toml", bad.text);
    check_refused(run_program({"exponents", "bad.toml", "-o", "result"}, folder.path()), "bad.toml:" + bad.message);
    CHECK(folder.names() == std::vector<std::string>{"bad.toml"});
  }
}

TEST_CASE("bad input leaves the result of an earlier run alone") {
  const TemporaryFolder folder;
  folder.write("bad.toml", bad_files.front().text);
  folder.write("result", "earlier");
  CHECK(run_program({"solve", "bad.toml", "-o", "result"}, folder.path()).code == 2);
  CHECK(folder.read("result") == "earlier");
}

TEST_CASE("the standard input is called -") {
  check_refused(run_alone({"exponents", "-"}, "load = 0\n" + half_space + friction + indenter),
                "-:1: load: load out of range; the load is positive; 0");
}

TEST_CASE("files with what every file may have are read") {
  const std::string good = body_and_friction + indenter;
  const Finished plain = run_alone({"exponents", "-"}, good);
  CHECK(plain.code == 0);
  std::string crlf;
  for (const char c : good) crlf += c == '\n' ? "\r\n" : std::string(1, c);
  for (const std::string& same : {crlf, "\xef\xbb\xbf" + good, good.substr(0, good.size() - 1)}) {
    CHECK(run_alone({"exponents", "-"}, same).out == plain.out);
  }
}
