#include "model/body.hpp"

#include <string>

#include "model/invalid_data.hpp"

namespace steadyslide {

void check_symbols(const SymbolRow& row, const SymbolRow* before) {
  if (row.wave_number <= (before == nullptr ? Rational(0) : before->wave_number)) {
    throw InvalidData("symbol", "k: wrong order", "wave numbers are positive and increase", to_string(row.wave_number));
  }
  if (row.normal <= 0) throw InvalidData("symbol", "W: out of range", "it is positive", to_string(row.normal));
}

Body Body::layered(std::vector<Layer> layers, std::optional<Solid> base) {
  constexpr std::size_t most = 64;
  if (layers.empty() || layers.size() > most) {
    throw InvalidData("layers", "wrong number of layers", "there are 1 to " + std::to_string(most),
                      std::to_string(layers.size()) + " layers");
  }
  for (std::size_t k = 0; k < layers.size(); ++k) {
    if (layers[k].thickness > 0) continue;
    throw InvalidData("layers[" + std::to_string(k) + "].thickness", "thickness out of range", "it is positive",
                      to_string(layers[k].thickness));
  }
  Body body;
  body.layers_ = std::move(layers);
  body.base_ = std::move(base);
  return body;
}

Body Body::periodic(Rational period) {
  if (period <= 0) throw InvalidData("period", "period out of range", "it is positive", to_string(period));
  Body body;
  body.period_ = std::move(period);
  return body;
}

Body Body::of_symbols(std::vector<SymbolRow> rows) {
  if (rows.size() < 2) {
    throw InvalidData("symbol", "too few rows", "a table of symbols has at least 2 rows",
                      std::to_string(rows.size()) + " rows");
  }
  for (std::size_t k = 0; k < rows.size(); ++k) check_symbols(rows[k], k == 0 ? nullptr : &rows[k - 1]);
  Body body;
  body.symbols_ = std::make_shared<const std::vector<SymbolRow>>(std::move(rows));
  return body;
}

Body Body::scaled(const Rational& scale) const {
  Body body = *this;
  for (Layer& layer : body.layers_) layer.thickness *= scale;
  if (body.period_) *body.period_ *= scale;
  if (symbols_) {
    std::vector<SymbolRow> rows = *symbols_;
    for (SymbolRow& row : rows) row.wave_number /= scale;
    body.symbols_ = std::make_shared<const std::vector<SymbolRow>>(std::move(rows));
  }
  return body;
}

bool operator==(const Body& a, const Body& b) {
  const bool same_symbols = a.symbols_ && b.symbols_ ? *a.symbols_ == *b.symbols_ : a.symbols_ == b.symbols_;
  return same_symbols && a.layers_ == b.layers_ && a.base_ == b.base_ && a.period_ == b.period_;
}

}  // namespace steadyslide
