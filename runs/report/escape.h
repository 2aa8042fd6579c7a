// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

namespace pacer::report {

/// `text` for use between tags or inside a quoted attribute: markup characters become entities,
/// bytes that are no UTF-8 and control characters become U+FFFD.
[[nodiscard]] std::string escape_html(std::string_view text);

/// `value` for use inside a `<script>` element: valid JSON in which nothing can end the element.
/// NaN and infinities become null, bytes that are no UTF-8 become U+FFFD.
[[nodiscard]] std::string escape_json(const nlohmann::json& value);

/// `bytes` in base 64 with padding (RFC 4648, section 4).
[[nodiscard]] std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace pacer::report
