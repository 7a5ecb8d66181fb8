#pragma once
// The destination of results: the standard output, or a file that is written completely or not at all.

#include <optional>
#include <string>
#include <string_view>

namespace steadyslide::app {

/// Writes text to a temporary file beside FILE, and renames it to FILE when everything is on the disk. If FILE is not a
/// regular file (/dev/null, a pipe), writes to it directly. Every error throws Failure with exit code 3.
class Output {
 public:
  explicit Output(const std::optional<std::string>& file);
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;
  /// Removes the temporary file, unless commit() was called.
  ~Output();

  void write(std::string_view text);
  /// Writes the buffered text.
  void flush();
  /// Call once, at the end; otherwise no file remains.
  void commit();

 private:
  [[noreturn]] void fail(const std::string& what) const;

  std::string name_;
  std::string target_;
  std::string temporary_;
  int descriptor_ = 1;
  std::string buffer_;
};

/// Writes one complete text to FILE or to the standard output.
void write_whole(const std::optional<std::string>& file, std::string_view text);

/// Makes a folder if it does not exist. Returns true if it is new. Throws Failure with exit code 3.
bool make_folder(const std::string& folder);

}  // namespace steadyslide::app
