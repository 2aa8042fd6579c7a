// SPDX-License-Identifier: Apache-2.0
#include "learning/baselines/supervised_model.h"

#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/check.h"
#include "learning/baselines/detector_training.h"
#include "learning/baselines/marked_reading.h"
#include "learning/picture_view.h"
#include "learning/read_episodes.h"

namespace pacer::baselines {
namespace {

constexpr std::size_t kMostPictures = 200;  // that the detector learns from
constexpr std::uint64_t kEvery = 5;         // frames that the map learns from one of
constexpr double kOnTarget = 0.3;           // overlap from which a detection is the target's

std::string body(const SupervisedModel& model) {
  ByteWriter out;
  model.origin.write(out);
  model.detector.write(out);
  model.driving.write(out);
  return out.bytes();
}

SupervisedModel read_body(std::string_view bytes) {
  ByteReader in(bytes);
  SupervisedModel model;
  model.origin = Origin::read(in);
  model.detector = WaldBoost::read(in);
  model.driving = BoxDriving::read(in);
  sane(in.rest().empty(), "something follows the loss");
  return model;
}

/// Pictures of one episode, evenly spread over it, however long it is: `most` at most, two or more.
class SpreadPictures {
 public:
  explicit SpreadPictures(std::size_t most) : most_(most) {}

  void offer(const Frame& frame, const Box& target) {
    if (seen_++ % every_ != 0) return;
    MarkedPicture picture{.grey = {}, .target = target};
    cv::cvtColor(rgb_view(frame), picture.grey, cv::COLOR_RGB2GRAY);
    pictures_.push_back(std::move(picture));
    if (pictures_.size() <= most_) return;
    for (std::size_t i = 0; 2 * i < pictures_.size(); ++i) {
      if (i > 0) pictures_[i] = std::move(pictures_[2 * i]);
    }
    pictures_.resize((pictures_.size() + 1) / 2);
    every_ *= 2;
  }
  [[nodiscard]] std::vector<MarkedPicture>& pictures() noexcept { return pictures_; }

 private:
  std::size_t most_;
  std::uint64_t seen_ = 0;
  std::uint64_t every_ = 1;
  std::vector<MarkedPicture> pictures_;
};

}  // namespace

std::string to_bytes(const SupervisedModel& model) {
  return sealed(SupervisedModel::kFile, body(model));
}

SupervisedModel supervised_from_bytes(std::string_view bytes, std::string_view source) {
  return unsealed(SupervisedModel::kFile, bytes, source, read_body);
}

SupervisedPolicy::SupervisedPolicy(std::shared_ptr<const SupervisedModel> model)
    : model_(std::move(model)),
      detector_(model_->detector, model_->origin.image_size),
      response_(model_->driving) {}

Command SupervisedPolicy::act(const Observation& observation, Annotations& annotations) {
  model_->origin.require_size(observation.frame);
  const std::optional<Detection> found = detector_.detect(observation.frame);
  return response_.respond(found ? std::optional(found->box) : std::nullopt, observation.frame,
                           annotations);
}

std::unique_ptr<Policy> SupervisedPolicyModel::make(
    const Random& /*random*/, std::unique_ptr<TargetPointer> /*pointer*/) const {
  return std::make_unique<SupervisedPolicy>(model());
}

SupervisedModel train_supervised(const MarkedDemonstration& demonstration,
                                 const LossConfig& when_lost, const Random& random,
                                 const TrainingOptions& options, TrainingReport& report) {
  const std::size_t episodes = demonstration.episode_count();
  const PictureShares shares = picture_shares(episodes, kMostPictures);
  std::vector<SpreadPictures> spread(episodes, SpreadPictures(shares.each));
  const MarkedReading reading =
      read_marked(demonstration, options, "pictures", [&](std::size_t episode) -> EpisodeVisit {
        if (episode % shares.stride != 0) return [](const MarkedStep&) {};
        return [&pictures = spread[episode]](const MarkedStep& step) {
          if (step.target) pictures.offer(*step.step.frame, *step.target);
        };
      });
  report.episodes = reading.episodes;
  report.frames = reading.frames;
  report.marked = reading.marked;

  std::vector<MarkedPicture> pictures;
  for (SpreadPictures& episode : spread) {
    std::ranges::move(episode.pictures(), std::back_inserter(pictures));
  }
  if (options.progress) options.progress("detector", 0.0);
  SupervisedModel model;
  model.origin = Origin::of(demonstration, options.scenario);
  model.origin.mean = reading.mean;
  if (options.stop.stop_requested()) throw TrainingStopped();
  model.detector = train_detector(pictures, random.fork("detector"));
  if (options.stop.stop_requested()) throw TrainingStopped();

  // What is detected is what it will drive by. Where a detection is not the target, the person
  // who marked it says so: it is not learnt from, as in 6.1.2.
  std::vector<std::vector<BoxExample>> examples(episodes);
  std::vector<std::uint64_t> asked(episodes);
  (void)read_marked(demonstration, options, "detections", [&](std::size_t e) -> EpisodeVisit {
    return [&, e, detector = std::make_shared<Detector>(model.detector, model.origin.image_size)](
               const MarkedStep& step) {
      if (step.step.frame->index % kEvery != 0 || !step.target) return;
      ++asked[e];
      const std::optional<Detection> found = detector->detect(*step.step.frame);
      if (!found || overlap(found->box, *step.target) < kOnTarget) return;
      examples[e].push_back({.box = found->box, .command = step.step.command});
    };
  });
  std::vector<BoxExample> all;
  double of = 0.0;
  for (std::size_t e = 0; e < episodes; ++e) {
    all.insert(all.end(), examples[e].begin(), examples[e].end());
    of += static_cast<double>(asked[e]);
  }
  if (all.empty()) {
    throw UsageError(
        "the detector finds the target nowhere in its own demonstration; record more of it");
  }
  model.driving = {.action = fit_box_action(all), .when_lost = when_lost};
  report.facts = {{"weak_classifiers", static_cast<double>(model.detector.weak.size())},
                  {"pictures", static_cast<double>(pictures.size())},
                  {"found", static_cast<double>(all.size()) / of}};
  return model;
}

}  // namespace pacer::baselines
