// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/processor.h"

namespace pacer::tracking {
namespace {

std::size_t count_kinds() noexcept {
#ifdef __x86_64__
  __builtin_cpu_init();
  if (!__builtin_cpu_supports("avx2")) return 1;
  const bool wide = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                    __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
                    __builtin_cpu_supports("avx512vnni");
  return wide ? 3 : 2;
#else
  return 1;
#endif
}

}  // namespace

std::size_t processor_kinds() noexcept {
  static const std::size_t count = count_kinds();
  return count;
}

}  // namespace pacer::tracking
