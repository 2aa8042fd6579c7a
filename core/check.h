// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <source_location>
#include <stdexcept>
#include <string>
#include <string_view>

namespace pacer {

/// What a user asked for makes no sense: a wrong key, a file of another kind. One line that says
/// what, where and what to do. The command ends with status 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Ends the program when `condition`, a promise of our own code, is broken.
void check(bool condition, std::string_view promise,
           std::source_location where = std::source_location::current());

/// For `validate()`: throws std::invalid_argument with `message` unless `condition`.
inline void require(bool condition, const std::string& message) {
  if (!condition) throw std::invalid_argument(message);
}

/// Validates a config's section; what it throws gains the section's name.
template <class Section>
void validate_section(const char* name, const Section& section) {
  try {
    section.validate();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string(name) + "." + error.what());
  }
}

}  // namespace pacer
