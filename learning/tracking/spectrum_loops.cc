// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/spectrum_loops.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace pacer::tracking {
namespace {

constexpr std::size_t kStride = FeatureMap::kStride;

/// exp(-2 pi i n / kGrid), made before any tracker is: trackers are not made by static
/// initialisers.
const std::array<std::complex<float>, kGrid> kTwiddles = [] {
  std::array<std::complex<float>, kGrid> twiddles;
  for (std::size_t n = 0; n < kGrid; ++n) {
    const double angle = -2.0 * std::numbers::pi * static_cast<double>(n) / double{kGrid};
    twiddles[n] = {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
  }
  return twiddles;
}();

/// Where entry i goes when the digits of i (4, 4, 2) are reversed.
constexpr std::array<std::size_t, kGrid> kReversed = [] {
  std::array<std::size_t, kGrid> reversed{};
  for (std::size_t i = 0; i < kGrid; ++i) {
    reversed[i] = i / 8 + 4 * (i / 2 % 4) + 16 * (i % 2);
  }
  return reversed;
}();

PACER_INLINE void turn(ComplexLanes& x, std::complex<float> by) {
  const FloatLanes re = x.re * by.real() - x.im * by.imag();
  x.im = x.re * by.imag() + x.im * by.real();
  x.re = re;
}

/// x = a + b and y = a - b; x and y may be a and b.
PACER_INLINE void add_and_subtract(const ComplexLanes& a, const ComplexLanes& b, ComplexLanes& x,
                                   ComplexLanes& y) {
  const FloatLanes re = a.re - b.re;
  const FloatLanes im = a.im - b.im;
  x.re = a.re + b.re;
  x.im = a.im + b.im;
  y.re = re;
  y.im = im;
}

/// Four numbers become their transform; kBack: the other way, unscaled.
template <bool kBack>
PACER_INLINE void butterfly4(ComplexLanes& a, ComplexLanes& b, ComplexLanes& c, ComplexLanes& d) {
  add_and_subtract(a, c, a, c);
  add_and_subtract(b, d, b, d);
  const FloatLanes re = d.re;  // b - d turns by a right angle: by -i, or back by i
  d.re = kBack ? -d.im : d.im;
  d.im = kBack ? re : -re;
  add_and_subtract(a, b, a, b);  // the first and the third
  add_and_subtract(c, d, c, d);  // the second and the fourth
  std::swap(b, c);
}

/// The transform of a line of kGrid = 4 x 4 x 2 numbers a lane, decimated in time: `line` is in
/// reversed order and is overwritten; the transform goes in order to `into`, `stride` apart (with
/// stride 1, `into` may be `line`).
template <bool kBack>
PACER_INLINE void transform_line(ComplexLanes* line, ComplexLanes* into, std::size_t stride) {
  const auto twiddle = [](std::size_t n) {
    return kBack ? std::conj(kTwiddles[n % kGrid]) : kTwiddles[n % kGrid];
  };
  for (std::size_t i = 0; i < kGrid; i += 4) {
    butterfly4<kBack>(line[i], line[i + 1], line[i + 2], line[i + 3]);
  }
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t i = k; i < kGrid; i += 16) {
      if (k > 0) {
        turn(line[i + 4], twiddle(2 * k));
        turn(line[i + 8], twiddle(4 * k));
        turn(line[i + 12], twiddle(6 * k));
      }
      butterfly4<kBack>(line[i], line[i + 4], line[i + 8], line[i + 12]);
    }
  }
  for (std::size_t k = 0; k < 16; ++k) {
    if (k > 0) turn(line[k + 16], twiddle(k));
    add_and_subtract(line[k], line[k + 16], into[k * stride], into[(k + 16) * stride]);
  }
}

template <bool kBack>
PACER_INLINE void transform_row(ComplexLanes* row) {
  std::array<ComplexLanes, kGrid> line;
  for (std::size_t i = 0; i < kGrid; ++i) line[kReversed[i]] = row[i];
  transform_line<kBack>(line.data(), row, 1);
}

template <bool kBack>
PACER_INLINE void transform_column(ComplexLanes* column, std::size_t first, std::size_t last) {
  std::array<ComplexLanes, kGrid> line;
  for (std::size_t i = 0; i < kGrid; ++i) {
    line[kReversed[i]] = i >= first && i < last ? column[i * kStride] : ComplexLanes();
  }
  transform_line<kBack>(line.data(), column, kStride);
}

PACER_INLINE void forward_body(ComplexLanes* cells, const CellRange& filled) {
  for (std::size_t r = filled.first_row; r < filled.last_row; ++r) {
    transform_row<false>(cells + r * kStride);
  }
  for (std::size_t c = 0; c < kGrid; ++c) {
    transform_column<false>(cells + c, filled.first_row, filled.last_row);
  }
}

PACER_INLINE void back_body(ComplexLanes* cells, const CellRange& wanted) {
  for (std::size_t c = 0; c < kGrid; ++c) transform_column<true>(cells + c, 0, kGrid);
  constexpr float kScale = 1.0F / float{kGrid * kGrid};
  for (std::size_t r = 0; r < kGrid; ++r) {
    ComplexLanes* const row = cells + r * kStride;
    const bool in = r >= wanted.first_row && r < wanted.last_row;
    if (in) transform_row<true>(row);
    for (std::size_t c = 0; c < kGrid; ++c) {
      if (in && c >= wanted.first_column && c < wanted.last_column) {
        row[c].re *= kScale;
        row[c].im *= kScale;
      } else {
        row[c] = ComplexLanes();
      }
    }
  }
}

PACER_INLINE void products_body(const ComplexLanes* a, const ComplexLanes* b,
                                std::complex<float>* sums) {
  std::array<ComplexLanes, kLanes / 2> real;
  std::array<ComplexLanes, kLanes / 2> imaginary;
  alignas(64) std::array<float, kLanes> real_sums;
  alignas(64) std::array<float, kLanes> imaginary_sums;
  for (std::size_t block = 0; block < kGrid * kGrid; block += kLanes) {
    const std::size_t first = block / kGrid * kStride + block % kGrid;
    for (std::size_t i = 0; i < kLanes / 2; ++i) {
      const ComplexLanes& x = a[first + i];
      const ComplexLanes& y = b[first + i];
      real[i].re = x.re * y.re + x.im * y.im;
      imaginary[i].re = x.re * y.im - x.im * y.re;
      const ComplexLanes& u = a[first + i + kLanes / 2];
      const ComplexLanes& v = b[first + i + kLanes / 2];
      real[i].im = u.re * v.re + u.im * v.im;
      imaginary[i].im = u.re * v.im - u.im * v.re;
    }
    sums_of(real, real_sums.data());
    sums_of(imaginary, imaginary_sums.data());
    for (std::size_t i = 0; i < kLanes; ++i) {
      sums[block + i] = {real_sums[i], imaginary_sums[i]};
    }
  }
}

PACER_INLINE void multiply_body(const std::complex<float>* factor, const ComplexLanes* map,
                                ComplexLanes* into) {
  for (std::size_t r = 0; r < kGrid; ++r) {
    for (std::size_t c = 0; c < kGrid; ++c) {
      ComplexLanes value = map[r * kStride + c];
      turn(value, factor[r * kGrid + c]);
      into[r * kStride + c] = value;
    }
  }
}

PACER_INLINE void blend_body(ComplexLanes* map, const ComplexLanes* other, float rate) {
  for (std::size_t i = 0; i < kGrid * kStride; ++i) {
    map[i].re += rate * (other[i].re - map[i].re);
    map[i].im += rate * (other[i].im - map[i].im);
  }
}

/// A plane's columns are lanes: two blocks of sixteen.
PACER_INLINE void plane_back_body(std::complex<float>* plane, float* into) {
  constexpr std::size_t kBlocks = kGrid / kLanes;
  std::array<ComplexLanes, kGrid> line;
  for (int pass = 0; pass < 2; ++pass) {
    std::array<std::complex<float>, kGrid * kGrid> turned;
    for (std::size_t block = 0; block < kBlocks; ++block) {
      for (std::size_t r = 0; r < kGrid; ++r) {
        ComplexLanes& values = line[kReversed[r]];
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
          values.re[lane] = plane[r * kGrid + block * kLanes + lane].real();
          values.im[lane] = plane[r * kGrid + block * kLanes + lane].imag();
        }
      }
      transform_line<true>(line.data(), line.data(), 1);
      for (std::size_t r = 0; r < kGrid; ++r) {
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
          turned[(block * kLanes + lane) * kGrid + r] = {line[r].re[lane], line[r].im[lane]};
        }
      }
    }
    for (std::size_t i = 0; i < kGrid * kGrid; ++i) plane[i] = turned[i];
  }
  for (std::size_t i = 0; i < kGrid * kGrid; ++i) {
    into[i] = plane[i].real() / float{kGrid * kGrid};
  }
}

#define PACER_SPECTRUM_LOOPS(Kind)                                                                \
  struct Kind {                                                                                   \
    PACER_TARGET static void forward(ComplexLanes* cells, const CellRange& filled) {              \
      forward_body(cells, filled);                                                                \
    }                                                                                             \
    PACER_TARGET static void back(ComplexLanes* cells, const CellRange& wanted) {                 \
      back_body(cells, wanted);                                                                   \
    }                                                                                             \
    PACER_TARGET static void products(const ComplexLanes* a, const ComplexLanes* b,               \
                                      std::complex<float>* sums) {                                \
      products_body(a, b, sums);                                                                  \
    }                                                                                             \
    PACER_TARGET static void multiply(const std::complex<float>* factor, const ComplexLanes* map, \
                                      ComplexLanes* into) {                                       \
      multiply_body(factor, map, into);                                                           \
    }                                                                                             \
    PACER_TARGET static void blend(ComplexLanes* map, const ComplexLanes* other, float rate) {    \
      blend_body(map, other, rate);                                                               \
    }                                                                                             \
    PACER_TARGET static void plane_back(std::complex<float>* plane, float* into) {                \
      plane_back_body(plane, into);                                                               \
    }                                                                                             \
    static constexpr SpectrumLoops kLoops{forward, back, products, multiply, blend, plane_back};  \
  }
#define PACER_TARGET
PACER_SPECTRUM_LOOPS(AnyProcessor);
#undef PACER_TARGET
#ifdef __x86_64__
#define PACER_TARGET [[gnu::target("avx2")]]
PACER_SPECTRUM_LOOPS(Avx2);
#undef PACER_TARGET
#define PACER_TARGET [[gnu::target(PACER_AVX512)]]
PACER_SPECTRUM_LOOPS(Avx512);
#undef PACER_TARGET
constexpr std::array<SpectrumLoops, kProcessorKinds> kKinds{AnyProcessor::kLoops, Avx2::kLoops,
                                                            Avx512::kLoops};
#else
constexpr std::array<SpectrumLoops, 1> kKinds{AnyProcessor::kLoops};
#endif

}  // namespace

const SpectrumLoops& spectrum_loops(std::size_t kind) noexcept { return kKinds[kind]; }
const SpectrumLoops& spectrum_loops() noexcept { return kKinds[processor_kinds() - 1]; }

}  // namespace pacer::tracking
