// SPDX-License-Identifier: Apache-2.0
#include "apps/interrupt.h"

#include <time.h>

#include <csignal>

namespace pacer {
namespace {

std::stop_source& source() {
  static std::stop_source only;
  return only;
}

/// Seconds of a clock that only goes forward.
double now() {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void on_signal(int signal) {
  static volatile double first = 0.0;
  constexpr double kSameWish = 1.0;  // s: `timeout` signals the process, then its whole group
  if (!source().stop_requested()) {
    source().request_stop();  // no callbacks are registered: it sets an atomic flag
    first = now();
  } else if (now() - first > kSameWish) {  // whoever insists is obeyed
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

}  // namespace

std::stop_token stop_on_interrupt() {
  std::stop_token token = source().get_token();
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  return token;
}

}  // namespace pacer
