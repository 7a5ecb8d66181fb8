#include "proofs_checks/kit/transport.hpp"

#include <cstring>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace steadyslide::proofs_checks {
namespace {

// What a record consists of is said once: pass() hands its members to an archive, which writes or reads them.

template <class Archive>
void pass(Archive& archive, ExactIdentity& e) {
  archive(e.detail, e.identities);
}
template <class Archive>
void pass(Archive& archive, Agreement& e) {
  archive(e.what, e.routes, e.worst, e.tolerance, e.cases, e.effective, e.required, e.detail);
}
template <class Archive>
void pass(Archive& archive, ConvergenceRate& e) {
  archive(e.what, e.measured, e.error_bar, e.expected, e.tolerance, e.detail);
}
template <class Archive>
void pass(Archive& archive, Counterexample& e) {
  archive(e.where, e.detail);
}
template <class Archive>
void pass(Archive& archive, BeyondCalculation& e) {
  archive(e.reason, e.consequences);
}
template <class Archive>
void pass(Archive& archive, ProofNode& node) {
  archive(node.fact.word, node.fact.things, node.by, node.words, node.from);
}
/// The text of the proof is the claim's.
template <class Archive>
void pass(Archive& archive, CheckedProof& e) {
  archive(e.nodes, e.gap);
}
template <class Archive>
void pass(Archive& archive, ControlReport& control) {
  archive(control.name, control.refuted, control.detail);
}
template <class Archive>
void pass(Archive& archive, Report& report) {
  archive(report.verdict, report.evidence, report.note, report.controls, report.seconds);
}

template <class T>
constexpr bool is_plain = std::is_arithmetic_v<T> || std::is_enum_v<T>;

class Writer {
 public:
  template <class... Members>
  void operator()(Members&... members) {
    (one(members), ...);
  }
  std::string bytes;

 private:
  template <class T>
  void one(T& value) {
    if constexpr (is_plain<T>) {
      bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    } else {
      pass(*this, value);
    }
  }
  void one(std::string& text) {
    std::size_t size = text.size();
    one(size);
    bytes += text;
  }
  template <class T>
  void one(std::vector<T>& values) {
    std::size_t size = values.size();
    one(size);
    for (T& value : values) one(value);
  }
  void one(Evidence& evidence) {
    std::size_t index = evidence.index();
    one(index);
    std::visit([this](auto& alternative) { one(alternative); }, evidence);
  }
};

class Reader {
 public:
  explicit Reader(std::string_view bytes) : left_(bytes) {}

  template <class... Members>
  void operator()(Members&... members) {
    (one(members), ...);
  }
  bool at_end() const { return left_.empty(); }

 private:
  std::string_view taken(std::size_t size) {
    if (size > left_.size()) throw std::invalid_argument("a report breaks off");
    const std::string_view result = left_.substr(0, size);
    left_.remove_prefix(size);
    return result;
  }
  template <class T>
  void one(T& value) {
    if constexpr (is_plain<T>) {
      std::memcpy(&value, taken(sizeof value).data(), sizeof value);
    } else {
      pass(*this, value);
    }
  }
  void one(std::string& text) {
    std::size_t size = 0;
    one(size);
    text = taken(size);
  }
  template <class T>
  void one(std::vector<T>& values) {
    std::size_t size = 0;
    one(size);
    for (; size > 0; --size) one(values.emplace_back());
  }
  void one(Evidence& evidence) {
    std::size_t index = 0;
    one(index);
    choose(evidence, index, std::make_index_sequence<std::variant_size_v<Evidence>>());
    std::visit([this](auto& alternative) { one(alternative); }, evidence);
  }
  template <std::size_t... All>
  static void choose(Evidence& evidence, std::size_t index, std::index_sequence<All...>) {
    const bool known = ((index == All && (evidence.emplace<All>(), true)) || ...);
    if (!known) throw std::invalid_argument("a report has evidence of an unknown kind");
  }

  std::string_view left_;
};

}  // namespace

std::string to_bytes(const Report& report) {
  Writer writer;
  pass(writer, const_cast<Report&>(report));  // a writer changes nothing
  return std::move(writer.bytes);
}

Report report_from(std::string_view bytes, const Claim& claim) {
  Report report{claim, Verdict::undecided, {}, {}, {}, 0};
  Reader reader(bytes);
  pass(reader, report);
  if (!reader.at_end()) throw std::invalid_argument("a report goes on behind its end");
  for (Evidence& e : report.evidence) {
    if (auto* proof = std::get_if<CheckedProof>(&e)) proof->text = claim.proof;
  }
  return report;
}

}  // namespace steadyslide::proofs_checks
