// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <malloc.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>

#include "learning/exemplar/percept.h"
#include "tests/learning/exemplar/painted.h"

// Every way to memory, Eigen's included, ends in one of these.
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define PACER_COUNTED
namespace {
std::atomic<long> allocations{0};
}
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) {
  ++allocations;
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  ++allocations;
  return __libc_calloc(count, size);
}
void* realloc(void* old, std::size_t size) {
  ++allocations;
  return __libc_realloc(old, size);
}
void* memalign(std::size_t alignment, std::size_t size) {
  ++allocations;
  return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  ++allocations;
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** to, std::size_t alignment, std::size_t size) {
  ++allocations;
  *to = __libc_memalign(alignment, size);
  return *to == nullptr ? ENOMEM : 0;
}
}
#endif

namespace pacer::exemplar {
namespace {

TEST(BalloonFinder, AllocatesNothingAfterTheFirstFrameOfASize) {
#ifdef PACER_COUNTED
  BalloonFinder finder;
  std::vector<Frame> frames;
  for (std::uint64_t i = 0; i < 6; ++i) frames.push_back(testing::noise({320, 240}, Random(i)));
  Frame room = testing::wall({320, 240});
  testing::fill_ball(room, 100.0, 60.0, 30.0, testing::kRedRubber);
  testing::fill_ball(room, 200.0, 60.0, 20.0, testing::kGreenRubber);
  frames.push_back(room);
  for (int stripe = 0; stripe < 320; stripe += 4) {  // as many blobs as there can be
    for (int y = 0; y < 240; y += 4) {
      testing::fill_rectangle(room, stripe, y, 4, 4,
                              (stripe + y) % 8 == 0 ? testing::kRedRubber : testing::kGreenRubber);
    }
  }
  frames.push_back(room);
  (void)finder.find(testing::wall({320, 240}));
  const long before = allocations;
  for (const Frame& frame : frames) (void)finder.find(frame);
  EXPECT_EQ(allocations - before, 0);
#else
  GTEST_SKIP() << "allocations are counted where glibc makes them, without a sanitizer";
#endif
}

}  // namespace
}  // namespace pacer::exemplar
