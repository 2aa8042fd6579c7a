// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace pacer::report {

/// A run of inline text on a page, escaped as it is made: whatever a name holds, it is shown and
/// never obeyed. Plain strings convert; pieces join with `+`.
class Text {
 public:
  Text() = default;
  Text(std::string_view plain);  // NOLINT(google-explicit-constructor): plain text is the rule
  Text(const std::string& plain) : Text(std::string_view(plain)) {}  // NOLINT
  Text(const char* plain) : Text(std::string_view(plain)) {}         // NOLINT

  [[nodiscard]] static Text strong(std::string_view plain);
  [[nodiscard]] static Text code(std::string_view plain);
  [[nodiscard]] static Text muted(std::string_view plain);
  /// A small dot of a colour `#rrggbb`, as charts use it for a policy. Throws
  /// std::invalid_argument for anything else.
  [[nodiscard]] static Text swatch(std::string_view colour);
  /// A link to a place on the page (`#id`) or to a file beside it (a relative path). Pages open
  /// without a network: throws std::invalid_argument for an address with a scheme or a host.
  [[nodiscard]] static Text link(std::string_view plain, std::string_view target);

  Text& operator+=(const Text& other);
  [[nodiscard]] friend Text operator+(Text left, const Text& right) { return left += right; }

  [[nodiscard]] const std::string& html() const noexcept { return html_; }    ///< safe markup
  [[nodiscard]] const std::string& plain() const noexcept { return plain_; }  ///< as given
  [[nodiscard]] bool empty() const noexcept { return html_.empty(); }

 private:
  std::string html_;
  std::string plain_;
};

}  // namespace pacer::report
