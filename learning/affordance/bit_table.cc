// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/bit_table.h"

#include <algorithm>
#include <array>
#include <bit>

namespace pacer::affordance {
namespace {

using Word = BitTable::Word;

[[gnu::always_inline]] inline void add_shared_bits(const Word* mask, const Word* bits,
                                                   std::size_t stride, std::size_t words,
                                                   std::size_t rows, std::uint32_t* counts) {
  for (std::size_t row = 0; row < rows; row += 8) {
    std::array<Word, 8> sums{};
    const Word* at = bits + row;
    for (std::size_t w = 0; w < words; ++w, at += stride) {
      for (std::size_t lane = 0; lane < 8; ++lane) {
        sums[lane] += static_cast<Word>(std::popcount(mask[w] & at[lane]));
      }
    }
    for (std::size_t lane = 0; lane < 8; ++lane) {
      counts[row + lane] += static_cast<std::uint32_t>(sums[lane]);
    }
  }
}

// The bits of a word that a mask selects, moved together at the low end, in six steps that depend
// on the mask alone (Warren, Hacker's Delight, 7-4).
struct Compression {
  explicit Compression(Word mask) noexcept : selected(mask), count(std::popcount(mask)) {
    Word zeros = ~mask << 1;  // counted to the right of each bit, modulo 2
    for (std::size_t step = 0; step < moves.size(); ++step) {
      Word parity = zeros;
      for (int shift = 1; shift < 64; shift *= 2) parity ^= parity << shift;
      moves[step] = parity & mask;
      mask = (mask ^ moves[step]) | (moves[step] >> (1U << step));
      zeros &= ~parity;
    }
  }
  Word selected;
  int count;
  std::array<Word, 6> moves{};
};

[[gnu::always_inline]] inline void append_compressed(const Compression& how, const Word* from,
                                                     const std::uint32_t* rows, std::size_t count,
                                                     int filled, Word* to, Word* next) {
  for (std::size_t i = 0; i < count; ++i) {
    Word x = from[rows[i]] & how.selected;
    for (unsigned step = 0; step < 6; ++step) {
      const Word moved = x & how.moves[step];
      x = (x ^ moved) | (moved >> (1U << step));
    }
    to[i] |= x << filled;
    if (next != nullptr) next[i] = x >> (64 - filled);
  }
}

// These two loops are where mining spends its time, so they are compiled for several processors and
// chosen at start. All give the same numbers.
struct Loops {
  decltype(&add_shared_bits) add_shared;
  decltype(&append_compressed) append;
};

#define PACER_LOOPS(name, target)                                                                  \
  struct name {                                                                                    \
    target static void add_shared(const Word* mask, const Word* bits, std::size_t stride,          \
                                  std::size_t words, std::size_t rows, std::uint32_t* counts) {    \
      add_shared_bits(mask, bits, stride, words, rows, counts);                                    \
    }                                                                                              \
    target static void append(const Compression& how, const Word* from, const std::uint32_t* rows, \
                              std::size_t count, int filled, Word* to, Word* next) {               \
      append_compressed(how, from, rows, count, filled, to, next);                                 \
    }                                                                                              \
  }

PACER_LOOPS(AnyProcessor, );
#ifdef __x86_64__
PACER_LOOPS(WithPopcount, [[gnu::target("popcnt")]]);
PACER_LOOPS(WithAvx2, [[gnu::target("avx2,popcnt")]]);
PACER_LOOPS(WithAvx512, [[gnu::target("avx512f,avx512vl,avx512vpopcntdq,popcnt")]]);
#endif
#undef PACER_LOOPS

Loops loops_of_this_processor() {
#ifdef __x86_64__
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512vpopcntdq")) {
    return {WithAvx512::add_shared, WithAvx512::append};
  }
  if (__builtin_cpu_supports("avx2")) return {WithAvx2::add_shared, WithAvx2::append};
  if (__builtin_cpu_supports("popcnt")) return {WithPopcount::add_shared, WithPopcount::append};
#endif
  return {AnyProcessor::add_shared, AnyProcessor::append};
}

const Loops kLoops = loops_of_this_processor();

}  // namespace

void BitTable::reset(std::size_t rows, std::size_t columns) {
  rows_ = rows;
  columns_ = columns;
  stride_ = padded_rows(rows);
  bits_.assign(words() * stride_, 0);
}

void BitTable::copy_row(std::size_t row, std::vector<Word>& to) const {
  to.resize(words());
  for (std::size_t w = 0; w < to.size(); ++w) to[w] = word(row, w);
}

void BitTable::add_shared(std::span<const Word> mask, std::size_t first, std::size_t last,
                          std::size_t rows, std::vector<std::uint32_t>& counts) const {
  kLoops.add_shared(mask.data() + first, bits_.data() + first * stride_, stride_, last - first,
                    padded_rows(rows), counts.data());
}

void BitTable::project(const BitTable& from, std::span<const std::uint32_t> rows,
                       std::span<const Word> mask) {
  std::size_t columns = 0;
  for (const Word word : mask) columns += static_cast<std::size_t>(std::popcount(word));
  reset(rows.size(), columns);
  std::size_t at = 0;
  for (std::size_t w = 0; w < mask.size(); ++w) {
    if (mask[w] == 0) continue;
    const Compression how(mask[w]);
    const int filled = static_cast<int>(at % 64);
    Word* const to = bits_.data() + at / 64 * stride_;
    Word* const next = filled + how.count > 64 ? to + stride_ : nullptr;
    kLoops.append(how, from.bits_.data() + w * from.stride_, rows.data(), rows.size(), filled, to,
                  next);
    at += static_cast<std::size_t>(how.count);
  }
}

}  // namespace pacer::affordance
