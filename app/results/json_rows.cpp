#include "app/results/json_rows.hpp"

#include <nlohmann/json.hpp>

namespace steadyslide::app {
namespace {

using Json = nlohmann::ordered_json;

class JsonRows final : public RowWriter {
 public:
  JsonRows(std::vector<Column> columns, Output& output) : columns_(std::move(columns)), output_(output) {}

  void row(const std::vector<Cell>& cells) override {
    Json object;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      std::visit([&](const auto& value) { object[columns_[k].name] = Json(value); }, cells[k]);
      if (cells[k] == Cell("")) object[columns_[k].name] = nullptr;
    }
    output_.write((first_ ? "[\n  " : ",\n  ") + object.dump());
    first_ = false;
  }

  void end() override { output_.write(first_ ? "[]\n" : "\n]\n"); }

 private:
  std::vector<Column> columns_;
  Output& output_;
  bool first_ = true;
};

}  // namespace

std::unique_ptr<RowWriter> make_json_rows(std::vector<Column> columns, Output& output) {
  return std::make_unique<JsonRows>(std::move(columns), output);
}

}  // namespace steadyslide::app
