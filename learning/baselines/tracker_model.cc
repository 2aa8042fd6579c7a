// SPDX-License-Identifier: Apache-2.0
#include "learning/baselines/tracker_model.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <vector>

#include "core/check.h"
#include "learning/baselines/marked_reading.h"
#include "learning/picture_view.h"

namespace pacer::baselines {
namespace {

constexpr double kOnTarget = 0.3;  // overlap from which a track is the target's

std::string body(const TrackerModel& model) {
  ByteWriter out;
  model.origin.write(out);
  out.text(model.tracker);
  model.driving.write(out);
  return out.bytes();
}

TrackerModel read_body(std::string_view bytes) {
  ByteReader in(bytes);
  TrackerModel model;
  model.origin = Origin::read(in);
  model.tracker = in.text();
  sane(std::ranges::count(tracking::trackers(), model.tracker, &tracking::TrackerKind::name) == 1,
       "a tracker that this program does not have");
  model.driving = BoxDriving::read(in);
  sane(in.rest().empty(), "something follows the loss");
  return model;
}

}  // namespace

std::string to_bytes(const TrackerModel& model) { return sealed(TrackerModel::kFile, body(model)); }

TrackerModel tracker_from_bytes(std::string_view bytes, std::string_view source) {
  return unsealed(TrackerModel::kFile, bytes, source, read_body);
}

FrameTracker::FrameTracker(std::string_view name, const Random& random) {
  const auto kind = std::ranges::find(tracking::trackers(), name, &tracking::TrackerKind::name);
  check(kind != tracking::trackers().end(), "a tracker is one of tracking::trackers()");
  tracker_ = kind->make(random.fork("tracker").next());
}

const tracking::Picture& FrameTracker::picture_of(const Frame& frame) {
  const cv::Mat rgb = rgb_view(frame);
  cv::cvtColor(rgb, picture_.bgr, cv::COLOR_RGB2BGR);
  cv::cvtColor(rgb, picture_.grey, cv::COLOR_RGB2GRAY);
  return picture_;
}

void FrameTracker::start(const Frame& frame, const Box& target) {
  tracker_->start(picture_of(frame), target);
}

std::optional<Box> FrameTracker::update(const Frame& frame) {
  const tracking::Track track = tracker_->update(picture_of(frame));
  if (track.confidence <= 0.0) return std::nullopt;
  return track.box;
}

TrackerPolicy::TrackerPolicy(std::shared_ptr<const TrackerModel> model, const Random& random,
                             std::unique_ptr<TargetPointer> pointer)
    : model_(std::move(model)),
      pointer_(std::move(pointer)),
      tracker_(model_->tracker, random),
      response_(model_->driving) {
  check(pointer_ != nullptr, "a tracker is shown its target");
}

Command TrackerPolicy::act(const Observation& observation, Annotations& annotations) {
  const Frame& frame = observation.frame;
  model_->origin.require_size(frame);
  std::optional<Box> box;
  if (started_) {
    box = tracker_.update(frame);
  } else if ((box = pointer_->point())) {
    tracker_.start(frame, *box);
    started_ = true;
  }
  return response_.respond(box, frame, annotations);
}

std::unique_ptr<Policy> TrackerPolicyModel::make(const Random& random,
                                                 std::unique_ptr<TargetPointer> pointer) const {
  if (pointer == nullptr) {
    throw UsageError(
        "a tracker is shown its target at the start, which the simulated car alone can do; set "
        "car=simulated");
  }
  return std::make_unique<TrackerPolicy>(model(), random, std::move(pointer));
}

TrackerModel train_tracker(const MarkedDemonstration& demonstration, const LossConfig& when_lost,
                           const Random& random, const TrainingOptions& options,
                           TrainingReport& report) {
  struct Episode {
    std::vector<BoxExample> examples;
    std::uint64_t starts = 0;
  };
  TrackerModel model;
  model.tracker = tracking::trackers().front().name;
  std::vector<Episode> found(demonstration.episode_count());
  const MarkedReading reading =
      read_marked(demonstration, options, "tracks", [&](std::size_t e) -> EpisodeVisit {
        // The same wherever the episode is read: its tracker's chances are its own.
        const auto tracker =
            std::make_shared<FrameTracker>(model.tracker, random.fork("episode", e));
        return [tracker, &episode = found[e], on = false](const MarkedStep& step) mutable {
          const Frame& frame = *step.step.frame;
          if (on) {
            const std::optional<Box> box = tracker->update(frame);
            if (!step.target) return;
            if (box && overlap(*box, *step.target) >= kOnTarget) {
              episode.examples.push_back({.box = *box, .command = step.step.command});
              return;
            }
          }
          if (!step.target) return;
          tracker->start(frame, *step.target);
          episode.examples.push_back({.box = *step.target, .command = step.step.command});
          ++episode.starts;
          on = true;
        };
      });
  report.episodes = reading.episodes;
  report.frames = reading.frames;
  report.marked = reading.marked;
  std::vector<BoxExample> all;
  std::uint64_t starts = 0;
  for (const Episode& episode : found) {
    all.insert(all.end(), episode.examples.begin(), episode.examples.end());
    starts += episode.starts;
  }
  model.origin = Origin::of(demonstration, options.scenario);
  model.origin.mean = reading.mean;
  model.driving = {.action = fit_box_action(all), .when_lost = when_lost};
  report.facts = {
      {"starts", static_cast<double>(starts)},
      {"tracked", static_cast<double>(all.size() - starts) / static_cast<double>(reading.marked)}};
  return model;
}

}  // namespace pacer::baselines
