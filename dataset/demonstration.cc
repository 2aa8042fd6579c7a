// SPDX-License-Identifier: Apache-2.0
#include "dataset/demonstration.h"

#include <fmt/format.h>

#include "core/check.h"

namespace pacer::dataset {
namespace {

class Stream final : public DemonstrationStream {
 public:
  Stream(const Dataset& dataset, std::size_t episode)
      : reader_(dataset, episode, {std::string(kAction)}) {}

  const DemonstratedStep* next() override {
    const RecordedStep* recorded = reader_.next();
    if (recorded == nullptr) return nullptr;
    step_.frame = recorded->frame;
    step_.command = clamped({.steering = recorded->values[0], .throttle = recorded->values[1]});
    return &step_;
  }

 private:
  EpisodeReader reader_;
  DemonstratedStep step_;
};

}  // namespace

RecordedDemonstration::RecordedDemonstration(const std::filesystem::path& root) : dataset_(root) {
  const Feature action = dataset_.features({std::string(kAction)}).front();
  if (action.width != 2) {
    throw UsageError(fmt::format("{}: its action has {} values, not steering and throttle",
                                 root.string(), action.width));
  }
}

std::size_t RecordedDemonstration::episode_count() const { return dataset_.episodes().size(); }
double RecordedDemonstration::frame_rate_hz() const { return dataset_.info().rate_hz; }
ImageSize RecordedDemonstration::image_size() const { return dataset_.info().image_size; }
std::string RecordedDemonstration::fingerprint() const { return dataset_.fingerprint(); }

std::unique_ptr<DemonstrationStream> RecordedDemonstration::open(std::size_t episode) const {
  return std::make_unique<Stream>(dataset_, episode);
}

}  // namespace pacer::dataset
