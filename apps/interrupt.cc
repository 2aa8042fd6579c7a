// SPDX-License-Identifier: Apache-2.0
#include "apps/interrupt.h"

#include <csignal>

namespace pacer {
namespace {

std::stop_source& source() {
  static std::stop_source only;
  return only;
}

void on_signal(int signal) {
  source().request_stop();  // no callbacks are registered: it sets an atomic flag
  std::signal(signal, SIG_DFL);
}

}  // namespace

std::stop_token stop_on_interrupt() {
  std::stop_token token = source().get_token();
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  return token;
}

}  // namespace pacer
