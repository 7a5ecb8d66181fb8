// steadyslide-check: proves contact solutions again, only from their certificate.

#include <cstdio>
#include <ctime>
#include <exception>
#include <string>

#include "checker/cells.hpp"
#include "checker/krawczyk.hpp"
#include "checker/periodic.hpp"
#include "checker/reader.hpp"
#include "checker/signs.hpp"

namespace {

using namespace steadyslide::checker;

constexpr const char* usage =
    "usage: steadyslide-check --problem FILE.toml CERTIFICATE\n"
    "       steadyslide-check CERTIFICATE\n"
    "       steadyslide-check --version\n"
    "\n"
    "Proves again what a certificate of 'steadyslide solve --certify' claims, and that it is one for the problem in the file.\n"
    "Without --problem the certificate's own copy of the problem is believed: it may be another problem than yours.\n"
    "\n"
    "Exit code: 0 if all is proved, 1 if something is not, 2 if a file or the command line breaks a rule, or a file cannot\n"
    "be read.\n";

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }  // CPU time since the start

void prove(const Cells& cells) {
  const std::size_t intervals = prove_cells(cells);
  std::printf("%zu cells\n  proved: the energy is at most %s, the gap is high enough on %zu intervals\n",
              cells.weights.size(), Ball(cells.energy, 64).middle().text().c_str(), intervals);
  std::printf("proved: load shares and effective friction of the solution lie in the intervals claimed (%.2f s)\n",
              seconds());
}

void prove(const Certificate& certificate) {
  const ReducedProblem problem(certificate.problem, certificate.origin, certificate.unit);
  for (const Box& box : certificate.boxes) {
    const auto& [from, to] = box.loads;
    std::printf("load %s\n", from == to ? from.text().c_str() : (from.text() + " to " + to.text()).c_str());
    const std::size_t unknowns = box.V.list().size();
    const Krawczyk zero = prove_zero(problem, box, certificate.bits);
    if (unknowns > 0) {
      std::printf(
          "  proved: one zero of the conditions in the box, %zu unknowns, contraction %.2g, integrals to 2^-%ld\n",
          unknowns, zero.contraction, static_cast<long>(zero.bits));
    } else {
      std::printf("  proved: the contact has no unknown\n");
    }
    const Signs signs = prove_signs(problem, zero.image, zero.bits);
    std::printf("  proved: t < 0 in the contact on %zu intervals, gap > 0 off it on %zu, integrals to 2^-%ld\n",
                signs.in_contact, signs.in_gaps, static_cast<long>(signs.bits));
  }
  const bool one_load = certificate.problem.loads.from == certificate.problem.loads.to;
  // The uniqueness theorem of docs/theory.md covers every problem that the reader accepts.
  std::printf("proved: %s a solution of the contact problem, the only one by the uniqueness theorem (%.2f s)\n",
              one_load ? "the box contains" : "for every load its box contains", seconds());
}

void prove(const Periodic& claim) {
  const PeriodicProof proof = prove_periodic(claim);
  std::printf("period %s\n  proved: one zero of the conditions in the box, contraction %.2g\n",
              claim.problem.period.text().c_str(), proof.contraction);
  std::printf("  proved: t < 0 in the contact on %zu intervals, gap > 0 off it on %zu\n", proof.in_contact,
              proof.in_gap);
  std::printf(
      "proved: the box contains a solution of the contact problem, with the friction and centre claimed (%.2f s)\n",
      seconds());
}

/// Checks if the certificate is for the problem in that file. For an empty name it does nothing.
void compare(const Problem& problem, const std::string& file) {
  if (file.empty()) return;
  const std::string differs = problem.difference(Problem::of_file(file));
  if (!differs.empty()) throw Unproved(file + ": not the certificate's problem; it differs in " + differs);
  std::printf("the problem is that of %s\n", one_line(file).c_str());
}

int run(int count, char** arguments) {
  const auto refuse = [](const char* what, const std::string& value) {
    throw Malformed("command line", what, "steadyslide-check --problem FILE.toml CERTIFICATE", value);
  };
  std::string file, problem;
  for (int k = 1; k < count; ++k) {
    const std::string word = arguments[k];
    if (word == "--help" || word == "-h") {
      std::fputs(usage, stdout);
      return 0;
    }
    if (word == "--version") {
      std::puts("steadyslide-check " STEADYSLIDE_VERSION);
      return 0;
    }
    if (word == "--problem" && k + 1 < count && problem.empty()) {
      problem = arguments[++k];
    } else if (file.empty() && !word.starts_with("--")) {
      file = word;
    } else {
      refuse("unknown argument", word);
    }
  }
  if (file.empty()) refuse("no certificate", "none");
  const Reader document = Reader::of_json(read_file(file), file);
  const auto check = [&](const auto& certificate) {
    compare(certificate.problem, problem);
    prove(certificate);
  };
  const std::size_t kind =
      document.has("kind") ? document["kind"].choice({"cells", "periodic", "solution", "loads"}) : 2;
  if (kind == 0) check(Cells::of_certificate(document));
  if (kind == 1) check(Periodic::of_certificate(document));
  if (kind > 1) check(Certificate::read(document));
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  try {
    return run(count, arguments);
  } catch (const Malformed& error) {
    std::fprintf(stderr, "steadyslide-check: %s\n", one_line(error.what()).c_str());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "steadyslide-check: not proved: %s\n", one_line(error.what()).c_str());
    return 1;
  }
}
