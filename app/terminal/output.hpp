#pragma once
// Where results go: the standard output, or a file that is written whole or not at all.

#include <optional>
#include <string>
#include <string_view>

namespace steadyslide::app {

/// Text is written to a temporary file beside FILE, which takes FILE's name when everything is on the disk. What is no
/// regular file (/dev/null, a pipe) is written directly. Every failure throws Failure with exit code 3.
class Output {
 public:
  explicit Output(const std::optional<std::string>& file);
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;
  /// Removes the temporary file unless everything was written.
  ~Output();

  void write(std::string_view text);
  /// Writes on what is kept so far.
  void flush();
  /// Call once, at the end: without it nothing remains.
  void commit();

 private:
  [[noreturn]] void fail(const std::string& what) const;

  std::string name_;
  std::string target_;
  std::string temporary_;
  int descriptor_ = 1;
  std::string buffer_;
};

/// Writes one text, whole, to FILE or the standard output.
void write_whole(const std::optional<std::string>& file, std::string_view text);

/// Makes a folder if need be: true if it is new. Throws Failure with exit code 3.
bool make_folder(const std::string& folder);

}  // namespace steadyslide::app
