// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/bit_loops.h"

#include <algorithm>

#ifdef __x86_64__
#include <immintrin.h>
#endif

namespace pacer::affordance {
namespace {

using Word = std::uint64_t;

[[gnu::always_inline]] inline void append_words(const Compression& how, const Word* from,
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

[[gnu::always_inline]] inline std::size_t select_counts(const std::uint32_t* counts,
                                                        std::size_t rows, std::uint32_t least,
                                                        std::uint32_t* selected) {
  std::size_t found = 0;
  for (std::size_t row = 0; row < rows; row += 8) {
    std::uint32_t any = 0;  // mostly none
    for (std::size_t lane = 0; lane < 8; ++lane) any |= counts[row + lane] >= least ? 1U : 0U;
    if (any == 0) continue;
    for (std::size_t lane = 0; lane < 8; ++lane) {
      selected[found] = static_cast<std::uint32_t>(row + lane);
      found += counts[row + lane] >= least ? 1 : 0;
    }
  }
  return found;
}

struct AnyProcessor {
  static void add_shared(const Word* mask, const Word* bits, std::size_t stride, std::size_t words,
                         std::size_t rows, std::uint32_t* counts) {
    for (std::size_t w = 0; w < words; ++w, bits += stride) {
      if (mask[w] == 0) continue;
      for (std::size_t row = 0; row < rows; ++row) {
        counts[row] += static_cast<std::uint32_t>(std::popcount(mask[w] & bits[row]));
      }
    }
  }
  static void append(const Compression& how, const Word* from, const std::uint32_t* rows,
                     std::size_t count, int filled, Word* to, Word* next) {
    append_words(how, from, rows, count, filled, to, next);
  }
  static std::size_t select(const std::uint32_t* counts, std::size_t rows, std::uint32_t least,
                            std::uint32_t* selected) {
    return select_counts(counts, rows, least, selected);
  }
};

#ifdef __x86_64__
#define PACER_TARGET [[gnu::target("avx2,popcnt")]]

struct Avx2 {
  static bool here() { return __builtin_cpu_supports("avx2"); }

  // The set bits of each byte: two look-ups of four bits (Mula).
  PACER_TARGET static __m256i byte_counts(__m256i bits) {
    const __m256i table = _mm256_setr_epi8(0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4,  //
                                           0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4);
    const __m256i low = _mm256_set1_epi8(15);
    return _mm256_add_epi8(
        _mm256_shuffle_epi8(table, _mm256_and_si256(bits, low)),
        _mm256_shuffle_epi8(table, _mm256_and_si256(_mm256_srli_epi16(bits, 4), low)));
  }

  PACER_TARGET static void add_shared(const Word* mask, const Word* bits, std::size_t stride,
                                      std::size_t words, std::size_t rows, std::uint32_t* counts) {
    constexpr std::size_t kFit = 31;  // words of eight bits a byte that a byte's sum holds
    for (std::size_t row = 0; row < rows; row += 4) {
      __m256i sums = _mm256_setzero_si256();
      for (std::size_t w = 0; w < words;) {
        __m256i bytes = _mm256_setzero_si256();
        for (const std::size_t end = std::min(w + kFit, words); w < end; ++w) {
          const auto* const at = reinterpret_cast<const __m256i*>(bits + w * stride + row);
          const __m256i all = _mm256_set1_epi64x(static_cast<long long>(mask[w]));
          bytes =
              _mm256_add_epi8(bytes, byte_counts(_mm256_and_si256(_mm256_loadu_si256(at), all)));
        }
        sums = _mm256_add_epi64(sums, _mm256_sad_epu8(bytes, _mm256_setzero_si256()));
      }
      alignas(32) std::array<Word, 4> lanes;
      _mm256_store_si256(reinterpret_cast<__m256i*>(lanes.data()), sums);
      for (std::size_t lane = 0; lane < 4; ++lane) {
        counts[row + lane] += static_cast<std::uint32_t>(lanes[lane]);
      }
    }
  }

  PACER_TARGET static void append(const Compression& how, const Word* from,
                                  const std::uint32_t* rows, std::size_t count, int filled,
                                  Word* to, Word* next) {
    append_words(how, from, rows, count, filled, to, next);
  }
  PACER_TARGET static std::size_t select(const std::uint32_t* counts, std::size_t rows,
                                         std::uint32_t least, std::uint32_t* selected) {
    return select_counts(counts, rows, least, selected);
  }
};

#undef PACER_TARGET
#define PACER_TARGET [[gnu::target("avx512f,avx512vl,avx512vpopcntdq,popcnt")]]

struct Avx512 {
  static bool here() {
    return __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512vpopcntdq");
  }

  template <std::size_t kBlocks>
  PACER_TARGET static void add_blocks(const Word* mask, const Word* bits, std::size_t stride,
                                      std::size_t words, std::uint32_t* counts) {
    __m512i sums[kBlocks];
    for (__m512i& sum : sums) sum = _mm512_setzero_si512();
    for (std::size_t w = 0; w < words; ++w, bits += stride) {
      const __m512i all = _mm512_set1_epi64(static_cast<long long>(mask[w]));
      for (std::size_t block = 0; block < kBlocks; ++block) {
        const __m512i held = _mm512_loadu_si512(bits + 8 * block);
        sums[block] =
            _mm512_add_epi64(sums[block], _mm512_popcnt_epi64(_mm512_and_si512(all, held)));
      }
    }
    for (std::size_t block = 0; block < kBlocks; ++block) {
      auto* const to = reinterpret_cast<__m256i*>(counts + 8 * block);
      _mm256_storeu_si256(to, _mm256_add_epi32(_mm256_loadu_si256(to),
                                               _mm512_maskz_cvtepi64_epi32(0xff, sums[block])));
    }
  }

  PACER_TARGET static void add_shared(const Word* mask, const Word* bits, std::size_t stride,
                                      std::size_t words, std::size_t rows, std::uint32_t* counts) {
    std::size_t row = 0;
    for (; row + 32 <= rows; row += 32) {
      add_blocks<4>(mask, bits + row, stride, words, counts + row);
    }
    for (; row < rows; row += 8) add_blocks<1>(mask, bits + row, stride, words, counts + row);
  }

  PACER_TARGET static void append(const Compression& how, const Word* from,
                                  const std::uint32_t* rows, std::size_t count, int filled,
                                  Word* to, Word* next) {
    append_words(how, from, rows, count, filled, to, next);
  }
  PACER_TARGET static std::size_t select(const std::uint32_t* counts, std::size_t rows,
                                         std::uint32_t least, std::uint32_t* selected) {
    return select_counts(counts, rows, least, selected);
  }
};

#undef PACER_TARGET
#endif

struct Kinds {
  std::array<BitLoops, 3> loops{
      {{AnyProcessor::add_shared, AnyProcessor::append, AnyProcessor::select}}};
  std::size_t count = 1;

  Kinds() noexcept {
#ifdef __x86_64__
    __builtin_cpu_init();
    if (Avx2::here()) loops[count++] = {Avx2::add_shared, Avx2::append, Avx2::select};
    if (Avx512::here()) loops[count++] = {Avx512::add_shared, Avx512::append, Avx512::select};
#endif
  }
};

const Kinds& kinds() noexcept {
  static const Kinds all;
  return all;
}

}  // namespace

Compression::Compression(std::uint64_t mask) noexcept : selected(mask) {
  Word right = ~mask << 1;  // bits to the right of each that are not selected
  for (std::size_t step = 0; step < moves.size(); ++step) {
    Word parity = right;
    for (int shift = 1; shift < 64; shift *= 2) parity ^= parity << shift;
    moves[step] = parity & mask;
    mask = (mask ^ moves[step]) | (moves[step] >> (1U << step));
    right &= ~parity;
  }
}

std::size_t bit_loop_count() noexcept { return kinds().count; }
const BitLoops& bit_loops(std::size_t kind) noexcept { return kinds().loops[kind]; }
const BitLoops& fastest_bit_loops() noexcept { return kinds().loops[kinds().count - 1]; }

}  // namespace pacer::affordance
