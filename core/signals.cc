// SPDX-License-Identifier: Apache-2.0
#include "core/signals.h"

#include <stdexcept>

namespace pacer {

std::size_t offset_of(std::span<const SignalColumn> columns, std::string_view name) {
  std::size_t offset = 0;
  for (const SignalColumn& column : columns) {
    if (column.name == name) return offset;
    offset += column.components.size();
  }
  throw std::runtime_error("this car has no signal \"" + std::string(name) + "\"");
}

}  // namespace pacer
