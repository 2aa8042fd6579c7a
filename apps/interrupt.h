// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stop_token>

namespace pacer {

/// A token that the first Ctrl-C (or SIGTERM) stops; one that comes more than a second later ends
/// the program at once. Call it once, from main.
[[nodiscard]] std::stop_token stop_on_interrupt();

}  // namespace pacer
