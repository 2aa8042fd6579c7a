// SPDX-License-Identifier: Apache-2.0
#include "runs/report/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/check.h"
#include "runs/report/escape.h"

namespace pacer::report {
namespace {

const Cell kEmpty;

const Cell& cell_at(const Row& row, std::size_t column) {
  return column < row.cells.size() ? row.cells[column] : kEmpty;
}

/// The number a cell competes with; none for text and for what was not measured.
std::optional<double> number_of(const Cell& cell) {
  std::optional<double> number;
  if (const auto* real = std::get_if<double>(&cell.value())) number = *real;
  if (const auto* whole = std::get_if<std::int64_t>(&cell.value())) {
    number = static_cast<double>(*whole);
  }
  if (const auto* estimate = std::get_if<Estimate>(&cell.value())) number = estimate->value;
  if (number && std::isnan(*number)) number.reset();
  return number;
}

std::string with_typeset_minus(std::string number) {
  if (number.starts_with('-')) number.replace(0, 1, "\xE2\x88\x92");  // U+2212
  return number;
}

std::string real(double value, const Column& column) {
  if (std::isnan(value)) return "\xE2\x80\x93";  // an en dash
  if (std::isinf(value)) return value < 0.0 ? "\xE2\x88\x92\xE2\x88\x9E" : "\xE2\x88\x9E";
  std::string text = fmt::format("{:.{}f}", value * column.scale, column.decimals);
  // No "-0.00": what rounds to zero has no sign.
  if (text.find_first_not_of("-0.") == std::string::npos && text.starts_with('-')) text.erase(0, 1);
  return with_typeset_minus(std::move(text));
}

std::string whole(std::int64_t value) {
  std::string digits = std::to_string(value);
  for (std::size_t at = digits.size(); at > (value < 0 ? 4U : 3U);) {
    at -= 3;
    digits.insert(at, ",");
  }
  return with_typeset_minus(std::move(digits));
}

std::string interval(const Estimate& estimate, const Column& column) {
  return fmt::format("{} to {}", real(estimate.low, column), real(estimate.high, column));
}

std::string_view word(Verdict verdict) {
  switch (verdict) {
    case Verdict::kHolds:
      return "holds";
    case Verdict::kShort:
      return "falls short";
    case Verdict::kOpen:
      break;
  }
  return "not measured";
}

/// What a whole column tells about its cells.
struct ColumnView {
  bool numeric = false;
  std::optional<double> best;
  bool whiskers = false;
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

ColumnView view_of(const Table& table, std::size_t index) {
  const Better better = table.columns[index].better;
  ColumnView view;
  int estimates = 0;
  int competitors = 0;
  for (const Row& row : table.rows) {
    const Cell& cell = cell_at(row, index);
    const auto number = number_of(cell);
    const bool is_text = std::holds_alternative<Text>(cell.value());
    view.numeric |= number.has_value() && !is_text;
    if (const auto* estimate = std::get_if<Estimate>(&cell.value())) {
      view.numeric = true;
      if (std::isfinite(estimate->low) && std::isfinite(estimate->high)) {
        ++estimates;
        view.low = std::min(view.low, estimate->low);
        view.high = std::max(view.high, estimate->high);
      }
    }
    if (!number || !row.competes || better == Better::kNeither) continue;
    ++competitors;
    const bool first = !view.best;
    if (first || (better == Better::kHigher ? *number > *view.best : *number < *view.best)) {
      view.best = number;
    }
  }
  if (competitors < 2) view.best.reset();  // alone is not best
  view.whiskers = estimates > 1 && view.high > view.low;
  return view;
}

bool is_best(const Row& row, const Cell& cell, const ColumnView& view) {
  const auto number = number_of(cell);
  return row.competes && view.best && number && *number == *view.best;
}

/// The interval as a line with a dot, on the scale that the column's rows share.
std::string whisker(const Estimate& estimate, const ColumnView& view) {
  constexpr double kWidth = 84.0;
  const auto x = [&view](double value) {
    const double share = (value - view.low) / (view.high - view.low);
    return 4.0 + (kWidth - 8.0) * std::clamp(share, 0.0, 1.0);
  };
  return fmt::format(
      "<svg class=\"whisker\" viewBox=\"0 0 84 8\" aria-hidden=\"true\">"
      "<path class=\"rail\" d=\"M4 4H80\"/><path class=\"span\" d=\"M{:.1f} 4H{:.1f}\"/>"
      "<circle cx=\"{:.1f}\" cy=\"4\" r=\"3\"/></svg>",
      x(estimate.low), x(estimate.high), x(estimate.value));
}

std::string content(const Cell& cell, const Column& column, const ColumnView& view) {
  if (const auto* text = std::get_if<Text>(&cell.value())) return text->html();
  if (const auto* number = std::get_if<std::int64_t>(&cell.value())) return whole(*number);
  if (const auto* number = std::get_if<double>(&cell.value())) return real(*number, column);
  if (const auto* verdict = std::get_if<Verdict>(&cell.value())) {
    return fmt::format("<span class=\"verdict {}\">{}</span>", css_class(*verdict), word(*verdict));
  }
  if (const auto* estimate = std::get_if<Estimate>(&cell.value())) {
    std::string out = fmt::format("<span class=\"value\">{}</span>", real(estimate->value, column));
    if (std::isnan(estimate->value)) return out;
    if (std::isfinite(estimate->low) && std::isfinite(estimate->high)) {
      if (view.whiskers) out += whisker(*estimate, view);
      out += fmt::format("<span class=\"interval\">{}</span>", interval(*estimate, column));
    }
    return out;
  }
  return {};
}

void require_whole(const Table& table) {
  for (const Row& row : table.rows) {
    require(row.cells.size() <= table.columns.size(), "table: a row has more cells than columns");
  }
}

std::string markdown_escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\n' || c == '\r') {
      out += ' ';
      continue;
    }
    if (std::string_view("\\|`*_[]<>&#").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

std::string markdown_content(const Cell& cell, const Column& column) {
  if (const auto* text = std::get_if<Text>(&cell.value())) return markdown_escaped(text->plain());
  if (const auto* number = std::get_if<std::int64_t>(&cell.value())) return whole(*number);
  if (const auto* number = std::get_if<double>(&cell.value())) return real(*number, column);
  if (const auto* verdict = std::get_if<Verdict>(&cell.value())) return std::string(word(*verdict));
  if (const auto* estimate = std::get_if<Estimate>(&cell.value())) {
    return real(estimate->value, column);
  }
  return {};
}

}  // namespace

std::string_view css_class(Verdict verdict) {
  switch (verdict) {
    case Verdict::kHolds:
      return "holds";
    case Verdict::kShort:
      return "short";
    case Verdict::kOpen:
      break;
  }
  return "open";
}

std::string html(const Table& table) {
  require_whole(table);
  std::vector<ColumnView> views;
  for (std::size_t i = 0; i < table.columns.size(); ++i) views.push_back(view_of(table, i));

  std::string out = "<div class=\"table\"><table>";
  if (!table.caption.empty()) out += "<caption>" + table.caption.html() + "</caption>";
  out += "<thead><tr>";
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const Column& column = table.columns[i];
    out += fmt::format("<th scope=\"col\"{}>{}", views[i].numeric ? " class=\"number\"" : "",
                       escape_html(column.heading));
    std::string hint = escape_html(column.unit);
    if (column.better == Better::kHigher) hint += hint.empty() ? "↑" : " ↑";
    if (column.better == Better::kLower) hint += hint.empty() ? "↓" : " ↓";
    if (!hint.empty()) out += "<small>" + hint + "</small>";
    out += "</th>";
  }
  out += "</tr></thead><tbody>";
  for (const Row& row : table.rows) {
    out += row.competes ? "<tr>" : "<tr class=\"reference\">";
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      const Cell& cell = cell_at(row, i);
      std::string classes = views[i].numeric ? "number" : "";
      if (is_best(row, cell, views[i])) classes += " best";
      const bool heads_row = i == 0 && std::holds_alternative<Text>(cell.value());
      const std::string_view tag = heads_row ? "th scope=\"row\"" : "td";
      out += fmt::format("<{}{}>{}</{}>", tag, classes.empty() ? "" : " class=\"" + classes + "\"",
                         content(cell, table.columns[i], views[i]), heads_row ? "th" : "td");
    }
    out += "</tr>";
  }
  out += "</tbody></table></div>\n";
  return out;
}

std::string markdown(const Table& table) {
  require_whole(table);
  std::string head = "|";
  std::string rule = "|";
  std::vector<ColumnView> views;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const Column& column = table.columns[i];
    views.push_back(view_of(table, i));
    head += " " + markdown_escaped(column.heading) +
            (column.unit.empty() ? "" : ", " + markdown_escaped(column.unit)) + " |";
    rule += views.back().numeric ? "---:|" : "---|";
  }
  std::string out = head + "\n" + rule + "\n";
  for (const Row& row : table.rows) {
    out += "|";
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      const Cell& cell = cell_at(row, i);
      std::string text = markdown_content(cell, table.columns[i]);
      if (is_best(row, cell, views[i])) text = "**" + text + "**";
      const auto* estimate = std::get_if<Estimate>(&cell.value());
      if (estimate != nullptr && std::isfinite(estimate->low) && std::isfinite(estimate->high)) {
        text += " (" + interval(*estimate, table.columns[i]) + ")";
      }
      out += " " + text + " |";
    }
    out += "\n";
  }
  return out;
}

}  // namespace pacer::report
