// SPDX-License-Identifier: Apache-2.0
// Private to the module: a line of a text that is not trusted.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace pacer::dataset {

/// One line of an annotation, read number by number from the left. Commas, blanks and tabs part
/// the numbers, one comma at most between two.
class AnnotationLine {
 public:
  /// `text` and `file` outlive it. Lines count from 1.
  AnnotationLine(std::string_view text, std::string_view file, std::size_t number) noexcept
      : left_(text), file_(file), number_(number) {}

  /// Takes `mark` away when it comes next, blanks before it included.
  [[nodiscard]] bool take(char mark) noexcept;
  /// There is something left beside blanks.
  [[nodiscard]] bool more() noexcept;
  /// The next number, which may be NaN or infinite; none at the line's end. Fails on anything else.
  [[nodiscard]] std::optional<double> next();
  /// Throws std::runtime_error: the file, the line, and why.
  [[noreturn]] void fail(std::string_view why) const;

 private:
  void skip_blanks() noexcept;

  std::string_view left_;
  std::string_view file_;
  std::size_t number_;
};

/// Hands the lines of `text` to `see` as AnnotationLine, in order. CRLF ends a line as LF does; a
/// byte order mark and empty lines at the end are passed over. Throws std::runtime_error for an
/// empty line between others, and for more than `most` lines.
template <class See>
void for_each_line(std::string_view text, std::string_view file, std::size_t most, See&& see) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  constexpr std::string_view kBlank = " \t\r\n";
  if (text.starts_with(kMark)) text.remove_prefix(kMark.size());
  text = text.substr(0, text.find_last_not_of(kBlank) + 1);
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = text.find('\n');
    const std::string_view whole = text.substr(0, end);
    const std::string_view line = whole.substr(0, whole.find_last_not_of(kBlank) + 1);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    AnnotationLine one(line, file, number);
    if (line.empty()) one.fail("is empty; write NaN,NaN,NaN,NaN where the target is absent");
    if (number > most) one.fail("one line too many; no more than " + std::to_string(most));
    see(one);
  }
}

}  // namespace pacer::dataset
