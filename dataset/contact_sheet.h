// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

#include "dataset/reader.h"

namespace pacer::dataset {

/// What a contact sheet shows.
struct ContactSheetOptions {
  int frames = 8;          ///< of each episode, evenly spaced, the first and the last among them
  int most_episodes = 12;  ///< evenly spaced, too, when the dataset has more
  int width = 1280;        ///< pixels

  /// Throws std::invalid_argument, naming the field.
  void validate() const;
};

/// A picture of a dataset: for each episode its number and length, some of its frames, and the
/// steering and throttle that were sent, over time. BGR, 8 bits, to be written with cv::imwrite.
/// Throws std::runtime_error, naming the file, when a recording cannot be read.
[[nodiscard]] cv::Mat contact_sheet(const Dataset& dataset,
                                    const ContactSheetOptions& options = {});

}  // namespace pacer::dataset
