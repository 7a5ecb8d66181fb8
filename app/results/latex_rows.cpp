#include "app/results/latex_rows.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace steadyslide::app {
namespace {

/// "1.5e-30" as 1.5 \cdot 10^{-30}, any other number as it is; empty if the text is no number.
std::string number_for_math_mode(const std::string& text) {
  if (text.empty() || text.find_first_not_of("0123456789+-.e") != std::string::npos) return "";
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  return fmt::format("{} \\cdot 10^{{{}}}", text.substr(0, e), text.substr(e + 1));
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '_' || c == '%' || c == '&' || c == '#' || c == '$' || c == '{' || c == '}') result += '\\';
    result += c;
  }
  return result;
}

std::string cell_text(const std::string& text) {
  const std::string number = number_for_math_mode(text);
  return number.empty() ? escaped(text) : "$" + number + "$";
}

/// The page is made as wide as the table: the columns are measured by their longest cell.
class LatexRows final : public RowWriter {
 public:
  LatexRows(std::vector<Column> columns, Output& output) : columns_(std::move(columns)), output_(output) {
    for (const Column& column : columns_) longest_.push_back(column.name.size());
  }

  void row(const std::vector<Cell>& cells) override {
    for (std::size_t k = 0; k < cells.size(); ++k) {
      std::string shown;
      std::size_t length = 0;
      const auto add = [&](const std::string& text) {
        shown += (shown.empty() ? "" : ", ") + (columns_[k].is_latex ? "$" + text + "$" : cell_text(text));
        length += text.size() + 2;
      };
      if (const auto* text = std::get_if<std::string>(&cells[k])) {
        add(*text);
      } else {
        for (const std::string& text : std::get<std::vector<std::string>>(cells[k])) add(text);
      }
      longest_[k] = std::max(longest_[k], length);
      body_ += shown + (k + 1 < cells.size() ? " & " : " \\\\\n");
    }
  }

  void end() override {
    std::size_t characters = 0;
    for (const std::size_t length : longest_) characters += length + 3;
    const double width = std::clamp(2.1 * static_cast<double>(characters), 170.0, 5000.0);
    std::string header;
    for (const Column& column : columns_) header += (header.empty() ? "" : " & ") + escaped(column.name);
    output_.write(
        fmt::format("\\documentclass{{article}}\n"
                    "\\usepackage{{longtable}}\n"
                    "\\setlength{{\\textwidth}}{{{0:.0f}mm}}\n"
                    "\\setlength{{\\paperwidth}}{{{1:.0f}mm}}\n"
                    "\\setlength{{\\pdfpagewidth}}{{{1:.0f}mm}}\n"
                    "\\setlength{{\\oddsidemargin}}{{-5mm}}\n"
                    "\\setlength{{\\LTleft}}{{0pt}}\n"
                    "\\begin{{document}}\n"
                    "\\begin{{longtable}}{{{2}}}\n"
                    "{3} \\\\ \\hline\n"
                    "\\endhead\n",
                    width, width + 40, std::string(columns_.size(), 'l'), header));
    output_.write(body_);
    output_.write("\\end{longtable}\n\\end{document}\n");
  }

 private:
  std::vector<Column> columns_;
  Output& output_;
  std::vector<std::size_t> longest_;
  std::string body_;
};

}  // namespace

std::unique_ptr<RowWriter> make_latex_rows(std::vector<Column> columns, Output& output) {
  return std::make_unique<LatexRows>(std::move(columns), output);
}

}  // namespace steadyslide::app
