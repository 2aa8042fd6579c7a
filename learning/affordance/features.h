// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/frame.h"
#include "learning/affordance/feature_kind.h"

namespace pacer::affordance {

/// Which features are looked for, and kept (6.5): a prior on where the target can be and how large
/// its details are.
struct FeatureConfig {
  double top = 0.35;       ///< share of the picture's height, from the top, that is not looked at
  double max_size = 6.0;   ///< pixels, the diameter that OpenCV calls a SIFT keypoint's size; of
                           ///< other kinds what is as large (feature_detector.cc)
  int budget = 500;        ///< features a frame of each kind, the clearest
  double contrast = 0.04;  ///< SIFT's contrast threshold
  double edge = 10.0;      ///< SIFT's edge threshold
  int octave_layers = 3;   ///< SIFT's layers an octave
  /// Of sift, orb, akaze, brisk and blob, those that are mixed (6.8): features of all of them fill
  /// one grid, with words of their own.
  std::vector<std::string> kinds = {"sift"};

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("top", top);
    visit("max_size_px", max_size);
    visit("budget", budget);
    visit("contrast", contrast);
    visit("edge", edge);
    visit("octave_layers", octave_layers);
    visit("kinds", kinds);
  }
};

/// Where features are: structure of arrays, ascending by x.
struct Poses {
  std::vector<float> x, y;   ///< pixels
  std::vector<float> size;   ///< pixels, diameter
  std::vector<float> angle;  ///< radians in [0, 2 pi], from +x towards +y

  [[nodiscard]] std::size_t count() const noexcept { return x.size(); }
  void clear() {
    x.clear();
    y.clear();
    size.clear();
    angle.clear();
  }
  void add(float px, float py, float diameter, float direction) {
    x.push_back(px);
    y.push_back(py);
    size.push_back(diameter);
    angle.push_back(direction);
  }
};

inline constexpr int kDescriptorSize = 128;

/// The features of one frame.
struct Features {
  Poses poses;
  std::vector<std::uint8_t> kinds;        ///< one each: which of FeatureConfig::kinds it is of
  std::vector<std::uint8_t> descriptors;  ///< count x kDescriptorSize; 0 behind shorter ones

  [[nodiscard]] std::size_t count() const noexcept { return poses.count(); }
  [[nodiscard]] std::span<const std::uint8_t> descriptor(std::size_t i) const noexcept {
    return {descriptors.data() + i * kDescriptorSize, kDescriptorSize};
  }
};

/// Finds features within the region the configuration keeps. Holds buffers: one a thread.
class FeatureExtractor {
 public:
  /// Throws std::invalid_argument when `config` is not valid.
  explicit FeatureExtractor(const FeatureConfig& config);
  ~FeatureExtractor();
  FeatureExtractor(FeatureExtractor&&) noexcept;
  FeatureExtractor& operator=(FeatureExtractor&&) noexcept;

  /// Replaces `features` by those of `frame`. The same pixels: the same features.
  void extract(const Frame& frame, Features& features);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pacer::affordance
