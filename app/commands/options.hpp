#pragma once
// A command line, read.

#include <optional>
#include <string>
#include <vector>

namespace steadyslide::app {

enum class Format { text, json, csv, markdown, latex };
enum class Method { automatic, closed_form, riemann_hilbert, variational };

/// What every command takes.
struct CommonOptions {
  int digits = 16;
  Format format = Format::text;
  std::optional<std::string> output;  ///< absent: the standard output
};

struct ExponentsOptions {
  CommonOptions common;
  std::string problem;
  bool derivation = false;
};

struct TableOptions {
  CommonOptions common;
  std::string poisson;
  std::string rear;
  std::string front;
};

struct SolveOptions {
  CommonOptions common;
  std::string problem;
  Method method = Method::automatic;
  std::string at;          ///< a list; empty: none
  int samples = 0;         ///< 0: none
  std::string load_steps;  ///< a list; empty: the file's load
  int search_starts = 0;   ///< of a search for several solutions; 0: one solve
  std::optional<int> cells;
  std::optional<int> iterations;
};

struct VerifyOptions {
  CommonOptions common;
  bool list = false;
  bool quick = false;
  std::vector<std::string> claims;
  std::string group = {};  ///< empty: all places of the paper
  std::optional<unsigned long long> seed;
  std::optional<std::string> report = {};  ///< folder of the HTML report on the same run
};

struct FiguresOptions {
  std::string folder = ".";
  std::vector<std::string> figures;  ///< patterns of names; empty: all
};

struct ReportOptions {
  VerifyOptions verify;  ///< what is run; its format, output and list are not looked at
  std::string folder = ".";
};

}  // namespace steadyslide::app
