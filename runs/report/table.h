// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "runs/report/interval.h"
#include "runs/report/text.h"

namespace pacer::report {

/// Whether a claim was met. `kOpen` is for what was not measured.
enum class Verdict : std::uint8_t { kHolds, kShort, kOpen };
/// The name that the page's style knows it by.
[[nodiscard]] std::string_view css_class(Verdict verdict);

/// Which values of a column are the better ones; the best of them is marked.
enum class Better : std::uint8_t { kNeither, kHigher, kLower };

struct Column {
  std::string heading;
  std::string unit = {};  ///< shown under the heading
  int decimals = 2;       ///< of real values and estimates; integers are shown whole
  double scale = 1.0;     ///< values are multiplied by it when shown: 100 for a fraction in %
  Better better = Better::kNeither;
};

/// What one place of a table holds: nothing, text, a whole number, a real one (NaN: a dash), an
/// estimate with its interval, or a verdict.
class Cell {
 public:
  using Value = std::variant<std::monostate, Text, std::int64_t, double, Estimate, Verdict>;

  Cell() = default;
  // NOLINTBEGIN(google-explicit-constructor): a row is written as a list of values
  Cell(Text text) : value_(std::move(text)) {}
  Cell(std::string_view text) : value_(Text(text)) {}
  Cell(const std::string& text) : value_(Text(text)) {}
  Cell(const char* text) : value_(Text(text)) {}
  Cell(std::integral auto number) : value_(static_cast<std::int64_t>(number)) {}
  Cell(double number) : value_(number) {}
  Cell(const Estimate& estimate) : value_(estimate) {}
  Cell(Verdict verdict) : value_(verdict) {}
  // NOLINTEND(google-explicit-constructor)

  [[nodiscard]] const Value& value() const noexcept { return value_; }

 private:
  Value value_;
};

struct Row {
  std::vector<Cell> cells;  ///< one a column; missing ones at the end are empty
  bool competes = true;     ///< false: a reference (the teacher, say) that is never marked best
};

struct Table {
  std::vector<Column> columns;
  std::vector<Row> rows;
  Text caption = {};
};

/// The table as HTML. Columns of estimates get a small drawing of the intervals on a common scale.
/// Throws std::invalid_argument when a row has more cells than there are columns.
[[nodiscard]] std::string html(const Table& table);

/// The same table for a README or a results page, in GitHub's Markdown; the best values are bold.
[[nodiscard]] std::string markdown(const Table& table);

}  // namespace pacer::report
