// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/rules_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <fstream>
#include <istream>
#include <limits>
#include <ostream>
#include <sstream>
#include <string>
#include <system_error>
#include <tuple>
#include <vector>

#include "core/check.h"
#include "core/output_file.h"

namespace pacer::affordance {
namespace {

/// Takes a text character by character and builds the database, a line at a time.
class TransactionParser {
 public:
  explicit TransactionParser(std::string_view name) : name_(name) {}

  void take(char c) {
    if (c >= '0' && c <= '9') {
      number_ = number_ < 0 ? c - '0' : number_ * 10 + (c - '0');
      if (number_ > largest()) {
        fail((has_type_ ? "an item is above " : "the action type is above ") +
             std::to_string(largest()));
      }
    } else if (c == ' ' || c == '\t' || c == '\r') {
      end_number();
    } else if (c == '\n') {
      end_line();
    } else {
      fail("a line must be `TYPE ITEM ITEM ...` in decimal numbers, but has " + shown(c));
    }
  }

  TransactionDatabase finish() {
    end_line();
    return std::move(database_);
  }

 private:
  static constexpr std::size_t kMostItems = std::numeric_limits<Item>::max() + std::size_t{1};

  [[nodiscard]] int largest() const noexcept {
    return has_type_ ? std::numeric_limits<Item>::max() : std::numeric_limits<ActionType>::max();
  }

  void end_number() {
    if (number_ < 0) return;
    if (!has_type_) {
      type_ = static_cast<ActionType>(number_);
      has_type_ = true;
    } else {
      if (items_.size() == kMostItems) fail("more than 65536 items");
      items_.push_back(static_cast<Item>(number_));
    }
    number_ = -1;
  }

  void end_line() {
    end_number();
    if (has_type_) {
      std::sort(items_.begin(), items_.end());
      items_.erase(std::unique(items_.begin(), items_.end()), items_.end());
      constexpr std::size_t kMost = std::numeric_limits<std::uint32_t>::max();
      if (database_.items.size() + items_.size() > kMost || database_.size() + 1 >= kMost) {
        fail("the transactions up to here are more than can be mined at once");
      }
      if (!items_.empty()) database_.item_count = std::max(database_.item_count, items_.back() + 1);
      database_.type_count = std::max(database_.type_count, type_ + 1);
      database_.add(items_, type_, static_cast<std::uint32_t>(database_.size()));
    }
    items_.clear();
    has_type_ = false;
    ++line_;
  }

  static std::string shown(char c) {
    if (c > ' ' && c <= '~') return std::string("`") + c + "`";
    constexpr std::string_view kDigits = "0123456789abcdef";
    const auto byte = static_cast<unsigned char>(c);
    return std::string("the byte 0x") + kDigits[byte / 16] + kDigits[byte % 16];
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw UsageError(std::string(name_) + ":" + std::to_string(line_) + ": " + what);
  }

  std::string_view name_;
  TransactionDatabase database_;
  std::vector<Item> items_;
  std::size_t line_ = 1;
  int number_ = -1;  ///< being read; none if negative
  bool has_type_ = false;
  ActionType type_ = 0;
};

std::string reason(int error) { return std::generic_category().message(error); }

}  // namespace

TransactionDatabase read_transactions(std::istream& in, std::string_view name) {
  TransactionParser parser(name);
  std::vector<char> block(1 << 16);
  while (in.read(block.data(), static_cast<std::streamsize>(block.size())), in.gcount() > 0) {
    std::for_each_n(block.begin(), in.gcount(), [&](char c) { parser.take(c); });
  }
  if (in.bad()) throw std::runtime_error(std::string(name) + ": reading failed part of the way");
  return parser.finish();
}

TransactionDatabase read_transactions(const std::filesystem::path& file) {
  if (std::filesystem::is_directory(file)) {
    throw UsageError(file.string() + ": is a folder; name a text file of transactions");
  }
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) throw UsageError(file.string() + ": cannot be read: " + reason(errno));
  return read_transactions(in, file.string());
}

void write_rules(std::ostream& out, std::span<const Rule> rules) {
  std::vector<const Rule*> sorted;
  sorted.reserve(rules.size());
  for (const Rule& rule : rules) sorted.push_back(&rule);
  std::stable_sort(sorted.begin(), sorted.end(), [](const Rule* a, const Rule* b) {
    return std::tie(a->type, a->items) < std::tie(b->type, b->items);
  });
  std::array<char, 32> digits;
  const auto put = [&](auto... number) {
    const auto [end, error] =
        std::to_chars(digits.data(), digits.data() + digits.size(), number...);
    out.write(digits.data(), end - digits.data());
  };
  for (const Rule* rule : sorted) {
    put(int{rule->type});
    for (const Item item : rule->items) {
      out.put(' ');
      put(int{item});
    }
    out.put(' ');
    put(rule->count);
    out.put(' ');
    put(rule->confidence(), std::chars_format::fixed, 6);
    out.put('\n');
  }
}

void write_rules(const std::filesystem::path& file, std::span<const Rule> rules) {
  OutputFile output(file);
  std::ostringstream text;
  write_rules(text, rules);
  output.write(text.view());
  output.keep();
}

}  // namespace pacer::affordance
