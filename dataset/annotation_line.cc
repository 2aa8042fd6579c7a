// SPDX-License-Identifier: Apache-2.0
#include "dataset/annotation_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <stdexcept>

namespace pacer::dataset {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// The word that `text` begins with, fit to be shown: short, and nothing that a terminal obeys.
std::string shown(std::string_view text) {
  constexpr std::size_t kMost = 16;
  std::string word(text.substr(0, std::min(text.find_first_of(", \t"), kMost)));
  std::ranges::replace_if(
      word, [](char c) { return c < ' ' || c > '~'; }, '?');
  return word;
}

}  // namespace

void AnnotationLine::skip_blanks() noexcept {
  while (!left_.empty() && is_blank(left_.front())) left_.remove_prefix(1);
}

bool AnnotationLine::take(char mark) noexcept {
  skip_blanks();
  if (left_.empty() || left_.front() != mark) return false;
  left_.remove_prefix(1);
  return true;
}

bool AnnotationLine::more() noexcept {
  skip_blanks();
  return !left_.empty();
}

std::optional<double> AnnotationLine::next() {
  if (!more()) return std::nullopt;
  if (left_.front() == ',') fail("has a comma with no number before it");
  double value = 0.0;
  const char* const end = left_.data() + left_.size();
  const auto [rest, error] = std::from_chars(left_.data(), end, value);
  const bool ends = rest == end || *rest == ',' || is_blank(*rest);
  if (error == std::errc::invalid_argument || !ends) {
    fail(fmt::format("'{}' is no number", shown(left_)));
  }
  if (error == std::errc::result_out_of_range) value = std::numeric_limits<double>::infinity();
  left_.remove_prefix(static_cast<std::size_t>(rest - left_.data()));
  if (take(',') && !more()) fail("ends with a comma");
  return value;
}

void AnnotationLine::fail(std::string_view why) const {
  throw std::runtime_error(fmt::format("{}:{}: {}", file_, number_, why));
}

}  // namespace pacer::dataset
