#include "app/sweep/row_file.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "app/embedded.hpp"

namespace steadyslide::app {
namespace {

/// True if FILE will be a regular file, not a device.
bool becomes_file(const std::optional<std::string>& name) {
  if (!name) return false;
  std::error_code unknown;
  const std::filesystem::file_status status = std::filesystem::status(*name, unknown);
  return !std::filesystem::exists(status) || std::filesystem::is_regular_file(status);
}

}  // namespace

RowFile::RowFile(const SweepWanted& wanted, const SweepTable& table) : wanted_(wanted) {
  if (!becomes_file(wanted.output)) {
    if (wanted.resume) {
      throw bad_command_line("--resume: nothing to resume", "it goes on with FILE.part of --output FILE",
                             wanted.output.value_or("standard output"));
    }
    output_.emplace(wanted.output);
    text_ = table.header();
    return;
  }
  const Output writable(wanted.output);  // checked before the first row, not after the last one
  const std::string title = fmt::format("# steadyslide {}, sweep {:016x}\n", version, table.fingerprint());
  part_.emplace(*wanted.output, title, table.header(), wanted.resume);
  const std::string before = part_->table();
  for (std::size_t at = before.find('\n') + 1; at < before.size();) {
    const std::size_t end = before.find('\n', at) + 1;
    const std::string_view row = std::string_view(before).substr(at, end - at);
    if (rows_ >= table.size() || !row.starts_with(table.beginning(rows_))) {
      throw Failure(ExitCode::bad_input,
                    fmt::format("{}.part:{}: not the row of its problem; rows are those of the sweep, in "
                                "order, each once; {}",
                                *wanted.output, rows_ + 3, excerpt(row.substr(0, row.size() - 1))));
    }
    count(row);
    at = end;
  }
}

void RowFile::count(std::string_view row) {
  ++rows_;
  if (!is_failed(row)) return;
  if (++failures_ == 1) first_failure_ = rows_;
}

void RowFile::add(const std::string& row) {
  count(row);
  if (part_) return part_->add(row);
  text_ += row;
  if (wanted_.written_as) return;
  output_->write(text_);
  output_->flush();
  text_.clear();
}

void RowFile::finish() {
  if (part_) {
    text_ = part_->table();
    output_.emplace(wanted_.output);
  }
  output_->write(wanted_.written_as ? wanted_.written_as(text_) : text_);
  output_->commit();
  if (part_) part_->remove();
}

}  // namespace steadyslide::app
