// SPDX-License-Identifier: Apache-2.0
#include "runs/shared_counter.h"

#include <sys/mman.h>

#include <cerrno>
#include <new>
#include <system_error>

namespace pacer {

static_assert(std::atomic<std::uint64_t>::is_always_lock_free, "shared between processes");

SharedCounter::SharedCounter() {
  void* page = ::mmap(nullptr, sizeof(std::atomic<std::uint64_t>), PROT_READ | PROT_WRITE,
                      MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (page == MAP_FAILED) throw std::system_error(errno, std::generic_category(), "mmap");
  value_ = new (page) std::atomic<std::uint64_t>(0);
}

SharedCounter::~SharedCounter() { ::munmap(value_, sizeof *value_); }

}  // namespace pacer
