// SPDX-License-Identifier: Apache-2.0
#include "runs/report/text.h"

#include <algorithm>
#include <cctype>

#include "core/check.h"
#include "runs/report/escape.h"

namespace pacer::report {
namespace {

/// A relative path as an address: everything but unreserved characters and slashes is encoded.
std::string percent_encoded(std::string_view path) {
  constexpr std::string_view kHex = "0123456789ABCDEF";
  std::string out;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80 &&
        (std::isalnum(byte) != 0 || std::string_view("-._~/").find(c) != std::string_view::npos)) {
      out += c;
    } else {
      out += '%';
      out += kHex[byte >> 4U];
      out += kHex[byte & 15U];
    }
  }
  return out;
}

}  // namespace

Text::Text(std::string_view plain) : html_(escape_html(plain)), plain_(plain) {}

Text Text::strong(std::string_view plain) {
  Text text(plain);
  text.html_ = "<strong>" + text.html_ + "</strong>";
  return text;
}

Text Text::code(std::string_view plain) {
  Text text(plain);
  text.html_ = "<code>" + text.html_ + "</code>";
  return text;
}

Text Text::muted(std::string_view plain) {
  Text text(plain);
  text.html_ = "<span class=\"muted\">" + text.html_ + "</span>";
  return text;
}

Text Text::swatch(std::string_view colour) {
  const bool valid = colour.size() == 7 && colour.front() == '#' &&
                     std::all_of(colour.begin() + 1, colour.end(), [](char c) {
                       return std::isxdigit(static_cast<unsigned char>(c)) != 0;
                     });
  require(valid, "swatch: want a colour #rrggbb, got " + std::string(colour));
  Text text;
  text.html_ = "<i class=\"swatch\" style=\"background:" + std::string(colour) + "\"></i>";
  return text;
}

Text Text::link(std::string_view plain, std::string_view target) {
  const bool fragment = target.starts_with('#');
  const std::string_view first = target.substr(0, target.find('/'));
  require(!target.empty() &&
              (fragment || (!target.starts_with('/') && first.find(':') == std::string_view::npos)),
          "link: want #id or a relative path, got " + std::string(target));
  Text text(plain);
  const std::string address =
      fragment ? "#" + percent_encoded(target.substr(1)) : percent_encoded(target);
  text.html_ = "<a href=\"" + address + "\">" + text.html_ + "</a>";
  return text;
}

Text& Text::operator+=(const Text& other) {
  html_ += other.html_;
  plain_ += other.plain_;
  return *this;
}

}  // namespace pacer::report
