#pragma once
// The keys of a problem file that describe a file of samples: its name, units, and other words.

#include <string>
#include <vector>

#include "library/problem_file/problem_reader.hpp"

namespace steadyslide::library {

/// Returns one of `words`, or `otherwise` if the field is absent. `what` is the error for other words.
std::string word(const ProblemReader& reader, const std::string& field, const std::string& what,
                 const std::vector<std::string>& words, const std::string& otherwise);

/// Returns m, mm, um or nm, or an empty text if the field is absent.
std::string length_unit(const ProblemReader& reader, const std::string& field);
/// Returns `from` as a multiple of `to`.
Rational unit_ratio(const std::string& from, const std::string& to);

/// Returns the field that names the file of samples: `field` itself if it is a text; `field`.file if it is a table with
/// some of `keys`.
std::string file_field(const ProblemReader& reader, const std::string& field,
                       std::initializer_list<std::string_view> keys);

/// True for a text of several lines: it is the table itself, not the name of a file.
inline bool is_table(const std::string& text) { return text.find('\n') != std::string::npos; }

struct SampleFile {
  std::string path;  ///< for a table inside the problem file "FILE:LINE: FIELD[]", without a problem file "FIELD[]"
  std::string text;
};
/// Returns the table in `field`, or the file that it names, relative to the folder of the problem file `beside`, or to the current folder
/// for the standard input. `kind` is the noun for the file in messages, "trace".
SampleFile read_samples(const ProblemReader& reader, const std::string& field, const std::string& beside,
                        const std::string& kind);

}  // namespace steadyslide::library
