// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace pacer {

static_assert(std::endian::native == std::endian::little, "model files are little-endian");

/// Numbers and sequences of them, one after the other, little-endian.
class ByteWriter {
 public:
  template <class Value>
  requires std::is_arithmetic_v<Value>
  void value(Value value) {
    char raw[sizeof(Value)];
    std::memcpy(raw, &value, sizeof(Value));
    bytes_.append(raw, sizeof(Value));
  }
  void text(std::string_view text) {
    value(static_cast<std::uint64_t>(text.size()));
    bytes_.append(text);
  }
  template <class Value>
  requires std::is_arithmetic_v<Value>
  void sequence(std::span<const Value> values) {
    value(static_cast<std::uint64_t>(values.size()));
    for (const Value one : values) value(one);
  }
  [[nodiscard]] const std::string& bytes() const noexcept { return bytes_; }

 private:
  std::string bytes_;
};

/// Reads them back from bytes that are not trusted: nothing is allocated before it is known to be
/// there. Throws std::runtime_error.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  template <class Value>
  requires std::is_arithmetic_v<Value>
  [[nodiscard]] Value value() {
    Value value;
    std::memcpy(&value, take(sizeof(Value)).data(), sizeof(Value));
    return value;
  }
  [[nodiscard]] std::string text() { return std::string(take(count(1))); }
  template <class Value>
  requires std::is_arithmetic_v<Value>
  [[nodiscard]] std::vector<Value> sequence() {
    const std::size_t size = count(sizeof(Value));
    std::vector<Value> values(size);
    const std::string_view raw = take(size * sizeof(Value));
    if (size > 0) std::memcpy(values.data(), raw.data(), raw.size());
    return values;
  }
  /// How many things follow, each of at least `least_size` bytes.
  [[nodiscard]] std::size_t count(std::size_t least_size) {
    const auto count = value<std::uint64_t>();
    if (count > rest_.size() / least_size) throw std::runtime_error("truncated");
    return static_cast<std::size_t>(count);
  }
  [[nodiscard]] std::string_view take(std::size_t size) {
    if (size > rest_.size()) throw std::runtime_error("truncated");
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return taken;
  }
  [[nodiscard]] std::string_view rest() const noexcept { return rest_; }

 private:
  std::string_view rest_;
};

}  // namespace pacer
