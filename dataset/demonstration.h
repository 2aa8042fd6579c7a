// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "core/demonstration.h"
#include "dataset/reader.h"

namespace pacer::dataset {

/// A dataset as learning sees it: frames, and the `action` that was sent. No other column is read
/// from the files, `privileged.*` least of all.
class RecordedDemonstration final : public Demonstration {
 public:
  /// Throws like Dataset, and UsageError when its `action` is not steering and throttle.
  explicit RecordedDemonstration(const std::filesystem::path& root);

  [[nodiscard]] std::size_t episode_count() const override;
  [[nodiscard]] double frame_rate_hz() const override;
  [[nodiscard]] ImageSize image_size() const override;
  [[nodiscard]] std::string fingerprint() const override;  ///< reads all files
  [[nodiscard]] std::unique_ptr<DemonstrationStream> open(std::size_t episode) const override;

 private:
  Dataset dataset_;
};

}  // namespace pacer::dataset
