// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace pacer::baselines {

/// Pictures as nearest neighbours are looked for among them: standardised, in steps of 1/32 of the
/// standard deviation, so that distances are whole numbers.
struct PictureTable {
  std::size_t pixels = 0;           ///< of each, above 0
  std::vector<std::int8_t> values;  ///< one picture after the other

  [[nodiscard]] std::size_t size() const noexcept { return values.size() / pixels; }
  [[nodiscard]] std::span<const std::int8_t> picture(std::size_t i) const {
    return std::span(values).subspan(i * pixels, pixels);
  }
};

/// SmallPicture::standardised() in those steps, clamped to what eight bits hold: nearly four
/// standard deviations.
void quantise(std::span<const float> standardised, std::span<std::int8_t> steps) noexcept;

/// Squared Euclidean distance of two pictures of the same size, of 30,000 pixels at most.
[[nodiscard]] std::int32_t squared_distance(std::span<const std::int8_t> a,
                                            std::span<const std::int8_t> b) noexcept;

/// The nearest of pictures that are offered one by one; among equals, the first. Allocates nothing
/// after construction.
class Nearest {
 public:
  struct Neighbour {
    std::int32_t distance = 0;  ///< squared
    std::uint32_t index = 0;    ///< of the picture
    friend bool operator==(const Neighbour&, const Neighbour&) = default;
  };

  explicit Nearest(std::size_t most) : most_(most) { found_.reserve(most); }

  void clear() noexcept { found_.clear(); }
  void offer(const Neighbour& neighbour) noexcept;
  /// Offers every picture of `table`, and returns what was found.
  [[nodiscard]] std::span<const Neighbour> search(const PictureTable& table,
                                                  std::span<const std::int8_t> picture) noexcept;
  /// The nearest first, `most` of them at most.
  [[nodiscard]] std::span<const Neighbour> found() const noexcept { return found_; }

 private:
  std::size_t most_;
  std::vector<Neighbour> found_;
};

}  // namespace pacer::baselines
