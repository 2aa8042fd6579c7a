// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "core/demonstration.h"
#include "core/marking.h"
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

/// The same with the lead's box in each frame, as recorded by the simulated car: for those who are
/// given boxes, and say so. The box is that of `privileged.lead_box`, where at least kMarkedFrom of
/// the lead can be seen (`privileged.lead_visible`).
class MarkedRecording final : public MarkedDemonstration {
 public:
  /// Throws like RecordedDemonstration, and UsageError where nobody recorded the lead's box.
  explicit MarkedRecording(const std::filesystem::path& root);

  [[nodiscard]] std::size_t episode_count() const override { return plain_.episode_count(); }
  [[nodiscard]] double frame_rate_hz() const override { return plain_.frame_rate_hz(); }
  [[nodiscard]] ImageSize image_size() const override { return plain_.image_size(); }
  [[nodiscard]] std::string fingerprint() const override { return plain_.fingerprint(); }
  [[nodiscard]] std::unique_ptr<DemonstrationStream> open(std::size_t episode) const override {
    return plain_.open(episode);
  }
  [[nodiscard]] std::unique_ptr<MarkedStream> open_marked(std::size_t episode) const override;

 private:
  RecordedDemonstration plain_;
  Dataset dataset_;
};

}  // namespace pacer::dataset
