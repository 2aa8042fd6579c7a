// SPDX-License-Identifier: Apache-2.0
#include "apps/interrupt.h"

#include <signal.h>
#include <time.h>

#include <atomic>
#include <cstdint>

namespace pacer {
namespace {

std::stop_source& source() {
  static std::stop_source only;
  return only;
}

/// Nanoseconds of a clock that only goes forward.
std::int64_t now() {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

std::atomic<std::int64_t> first_signal{0};
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

void on_signal(int signal) {
  constexpr std::int64_t kSameWish = 1'000'000'000;  // `timeout` asks us, then our whole group
  std::int64_t before = 0;
  if (first_signal.compare_exchange_strong(before, now())) {
    source().request_stop();                // no callbacks are registered: it sets an atomic flag
  } else if (now() - before > kSameWish) {  // whoever insists is obeyed
    ::signal(signal, SIG_DFL);
    ::raise(signal);
  }
}

}  // namespace

std::stop_token stop_on_interrupt() {
  std::stop_token token = source().get_token();
  struct sigaction action {};
  action.sa_handler = on_signal;
  ::sigemptyset(&action.sa_mask);
  for (const int signal : {SIGINT, SIGTERM}) ::sigaddset(&action.sa_mask, signal);
  for (const int signal : {SIGINT, SIGTERM}) ::sigaction(signal, &action, nullptr);
  return token;
}

}  // namespace pacer
