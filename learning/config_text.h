// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/units.h"

namespace pacer {

/// A config as one "section.key=value" line a field, in the order of its fields. Numbers are
/// written so that they read back exactly; lists are of words, without commas.
class ConfigTextWriter {
 public:
  template <class Value>
  void operator()(const char* key, Value& value) {
    if constexpr (requires { value.fields(*this); }) {
      const std::string outer = prefix_;
      prefix_ += std::string(key) + ".";
      value.fields(*this);
      prefix_ = outer;
    } else {
      text_ += prefix_ + key + "=" + plain(value) + "\n";
    }
  }
  [[nodiscard]] const std::string& text() const noexcept { return text_; }

 private:
  static std::string plain(const std::string& value) { return value; }
  static std::string plain(const std::vector<std::string>& values) {
    std::string text;
    for (const std::string& value : values) text += (text.empty() ? "" : ",") + value;
    return text;
  }
  static std::string plain(bool value) { return value ? "true" : "false"; }
  static std::string plain(Seconds value) { return plain(value.count()); }
  template <class Number>
  requires std::is_arithmetic_v<Number>
  static std::string plain(Number value) {
    char buffer[64];
    const auto end = std::to_chars(buffer, buffer + sizeof(buffer), value).ptr;
    return {buffer, end};
  }

  std::string prefix_;
  std::string text_;
};

/// Reads such lines back: exactly the fields, in their order. Throws std::runtime_error naming the
/// field.
class ConfigTextReader {
 public:
  explicit ConfigTextReader(std::string_view text) : rest_(text) {}

  template <class Value>
  void operator()(const char* key, Value& value) {
    if constexpr (requires { value.fields(*this); }) {
      const std::string outer = prefix_;
      prefix_ += std::string(key) + ".";
      value.fields(*this);
      prefix_ = outer;
    } else {
      const std::string name = prefix_ + key;
      const std::string_view line = rest_.substr(0, rest_.find('\n'));
      rest_.remove_prefix(std::min(rest_.size(), line.size() + 1));
      if (!line.starts_with(name + "=")) throw std::runtime_error("no setting " + name);
      if (!parse(line.substr(name.size() + 1), value)) {
        throw std::runtime_error("setting " + name + " makes no sense");
      }
    }
  }

 private:
  static bool parse(std::string_view text, std::string& value) {
    value = text;
    return true;
  }
  static bool parse(std::string_view text, std::vector<std::string>& values) {
    values.clear();
    while (!text.empty()) {
      const std::string_view one = text.substr(0, text.find(','));
      values.emplace_back(one);
      text.remove_prefix(std::min(text.size(), one.size() + 1));
    }
    return true;
  }
  static bool parse(std::string_view text, bool& value) {
    value = text == "true";
    return value || text == "false";
  }
  static bool parse(std::string_view text, Seconds& value) {
    double seconds = 0.0;
    const bool parsed = parse(text, seconds);
    value = Seconds{seconds};
    return parsed;
  }
  template <class Number>
  requires std::is_arithmetic_v<Number>
  static bool parse(std::string_view text, Number& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} && end == text.data() + text.size();
  }

  std::string_view rest_;
  std::string prefix_;
};

}  // namespace pacer
