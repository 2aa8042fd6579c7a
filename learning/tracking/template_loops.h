// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "learning/tracking/processor.h"

namespace pacer::tracking {

/// The loops in which appearance models spend their time. All numbers are whole, and exact. Counts
/// are whole lanes; what pads them is zero.
struct TemplateLoops {
  /// sum_i (a[i] - b[i])^2, for at most 32,768 values.
  std::uint32_t (*squared_distance)(const std::uint8_t* a, const std::uint8_t* b,
                                    std::size_t count);

  /// to += weight * row.
  void (*add_scaled)(double weight, const float* row, std::size_t count, double* to);

  /// to += in * added - out * removed.
  void (*exchange)(float in, const float* added, float out, const float* removed, std::size_t count,
                   double* to);

  /// Where row[i] < least[i]: least[i] = row[i], and at[i] = number.
  void (*lower)(const double* row, double number, std::size_t count, double* least, double* at);
};

/// The loops for one kind of processor, below processor_kinds().
[[nodiscard]] const TemplateLoops& template_loops(std::size_t kind) noexcept;
/// The widest that this processor can run.
[[nodiscard]] const TemplateLoops& template_loops() noexcept;

}  // namespace pacer::tracking
