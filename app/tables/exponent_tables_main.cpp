// exponent-tables [-o DIR]: writes exponents.md, exponents.tex and exponents.csv into DIR (default: the current
// folder). The exit code is 2 for a wrong command line, 3 for a file that cannot be written.

#include <cstdio>
#include <exception>
#include <string>
#include <string_view>

#include "app/tables/exponent_tables.hpp"
#include "app/terminal/output.hpp"

int main(int argc, char** argv) {
  using namespace steadyslide::app;
  std::string directory = ".";
  if (argc == 3 && std::string_view(argv[1]) == "-o") {
    directory = argv[2];
  } else if (argc != 1) {
    std::fprintf(stderr, "usage: %s [-o DIR]\n", argv[0]);
    return 2;
  }
  try {
    for (const auto& [file, text] : exponent_documents()) write_whole(directory + "/" + file, text);
    return 0;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s: %s\n", argv[0], e.what());
    return 3;
  }
}
