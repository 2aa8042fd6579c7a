// SPDX-License-Identifier: Apache-2.0
#include "dataset/demonstration.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

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

// What the simulated car calls them.
constexpr const char* kBox = "privileged.lead_box";          // left, top, right, bottom
constexpr const char* kVisible = "privileged.lead_visible";  // share

class BoxStream final : public MarkedStream {
 public:
  BoxStream(const Dataset& dataset, std::size_t episode)
      : reader_(dataset, episode, {std::string(kAction), kBox, kVisible}) {}

  const MarkedStep* next() override {
    const RecordedStep* recorded = reader_.next();
    if (recorded == nullptr) return nullptr;
    const std::span<const double> values = recorded->values;
    step_.step.frame = recorded->frame;
    step_.step.command = clamped({.steering = values[0], .throttle = values[1]});
    // Of pixel areas, as the simulated car has them: from -0.5 to size - 0.5.
    const Box box{.x = 0.5 * (values[2] + values[4]),
                  .y = 0.5 * (values[3] + values[5]),
                  .width = values[4] - values[2],
                  .height = values[5] - values[3]};
    step_.target.reset();
    if (values[6] >= kMarkedFrom && is_proper(box)) step_.target = box;
    return &step_;
  }

 private:
  EpisodeReader reader_;
  MarkedStep step_;
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

MarkedRecording::MarkedRecording(const std::filesystem::path& root) : plain_(root), dataset_(root) {
  for (const auto& [name, width] : {std::pair(kBox, std::size_t{4}), {kVisible, 1}}) {
    const auto& known = dataset_.info().features;
    const auto found = std::ranges::find(known, name, &Feature::name);
    if (found == known.end() || found->width != width) {
      throw UsageError(fmt::format(
          "{}: holds no {}, which this method is given; record with the simulated car, of a "
          "scenario with a lead such as scenarios/follow.yaml",
          root.string(), name));
    }
  }
}

std::unique_ptr<MarkedStream> MarkedRecording::open_marked(std::size_t episode) const {
  return std::make_unique<BoxStream>(dataset_, episode);
}

}  // namespace pacer::dataset
