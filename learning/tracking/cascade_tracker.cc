// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/cascade_tracker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace pacer::tracking {
namespace {

constexpr int kAspectSide = 64;  // samples
constexpr double kRoom = 1.15;   // of a region around a long target
constexpr double kSlack = 1.3;   // of the pyramid: the target may move before it is looked at again
constexpr double kLeastConfidence = 1e-3;  // of a target that is not lost
constexpr double kLeastScale = 0.1;
constexpr double kMostScale = 10.0;

bool lies_in(const Similarity& pose, const cv::Mat1b& image) {
  return pose.x >= 0.0 && pose.y >= 0.0 && pose.x < image.cols && pose.y < image.rows;
}

Similarity rescaled(Similarity pose, double by) {
  pose.scale = std::clamp(pose.scale * by, kLeastScale, kMostScale);
  return pose;
}

/// `pose` in pixels a sample of a patch whose samples are `unit` apart on the first target.
Similarity in_samples(Similarity pose, double unit) {
  pose.scale *= unit;
  return pose;
}

/// The outline of what lies up to `across` and `down` from a pose, pixels of its frame.
void outline(const Similarity& pose, double across, double down, Tone tone,
             Annotations& annotations) {
  const auto corner = [&](double u, double v) {
    const Similarity at = pose.moved(u * across, v * down);
    return PixelPoint{.x = static_cast<float>(at.x), .y = static_cast<float>(at.y)};
  };
  const std::array corners = {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    annotations.lines.push_back(
        {.from = corners[i], .to = corners[(i + 1) % corners.size()], .tone = tone});
  }
}

}  // namespace

CascadeTracker::CascadeTracker(const CascadeConfig& config, std::uint64_t seed)
    : config_(config),
      random_(Random(seed).fork("cascade")),
      memory_(config.memory),
      search_patch_(GradientFeatures::kSide),
      aspect_patch_(kAspectSide) {
  config.validate();
}

Similarity CascadeTracker::placed(const cv::Mat1b& image, Similarity pose) const {
  const double across = 0.5 * width_ * pose.scale;
  const double down = 0.5 * height_ * pose.scale;
  pose.x = std::clamp(pose.x, -across, image.cols - 1.0 + across);
  pose.y = std::clamp(pose.y, -down, image.rows - 1.0 + down);
  return pose;
}

void CascadeTracker::look_around(const cv::Mat1b& image, const Similarity& pose,
                                 FeatureMap& spectrum) {
  const Similarity sampled = in_samples(pose, search_unit_);
  if (!pyramid_.covers(sampled, search_patch_.side)) {
    pyramid_.take(image, sampled, search_patch_.side, kSlack);
  }
  pyramid_.sample(sampled, search_patch_);
  features_.describe(search_patch_, spectrum);
  transform(spectrum);
}

void CascadeTracker::look_at(const cv::Mat1b& image, const Similarity& pose) {
  const Similarity sampled = in_samples(pose, aspect_unit_);
  if (!pyramid_.covers(sampled, kAspectSide)) {
    pyramid_.take(image, sampled, kAspectSide, kSlack);
  }
  pyramid_.sample(sampled, aspect_patch_);
}

void CascadeTracker::begin(const Picture& picture, const Box& target) {
  width_ = target.width;
  height_ = target.height;
  pose_ = {.x = target.x, .y = target.y, .scale = 1.0, .angle = 0.0};
  side_ = std::sqrt(target.area());
  const double longest = kRoom * std::max(width_, height_);
  search_unit_ = std::max(config_.search_side * side_, longest) / GradientFeatures::kSide;
  aspect_unit_ = std::max(config_.aspect_side * side_, longest) / kAspectSide;

  filter_.emplace(config_.filter, width_ / cell(), height_ / cell());
  trainer_.emplace(config_.predictor, width_ / aspect_unit_, height_ / aspect_unit_, random_);
  pyramid_.forget();
  look_around(picture.grey, pose_, spectrum_);
  filter_->learn(spectrum_, 1.0);
  first_answer_ = std::max(filter_->locate(spectrum_).value, 1e-6);  // of a flat picture: none
  usual_ = first_answer_;
  look_at(picture.grey, pose_);
  memory_.clear(config_.predictor.side * config_.predictor.side);
  memory_.remember(*trainer_, aspect_patch_, 0);
  matched_ = 0;
  likeness_ = 1.0F;
  doubtful_ = 0;
  lost_ = false;
  larger_ = false;
  place_ = 0;
}

PoseChange CascadeTracker::refine() {
  PoseChange change = PoseChange::Zero();
  trainer_->observe(aspect_patch_, change, seen_);
  matched_ = memory_.match(seen_);
  const Aspect& aspect = memory_[matched_];
  likeness_ = aspect.likeness(seen_);
  PoseChange best = change;
  for (int round = 0; round < config_.rounds; ++round) {
    change += trainer_->predict(aspect, seen_);
    trainer_->observe(aspect_patch_, change, seen_);
    const float likeness = aspect.likeness(seen_);
    if (likeness > likeness_) {
      likeness_ = likeness;
      best = change;
    }
  }
  return best;
}

CascadeTracker::Sighting CascadeTracker::locate(const cv::Mat1b& image, const Similarity& pose,
                                                FeatureMap& spectrum) {
  look_around(image, pose, spectrum);
  const Peak peak = filter_->locate(spectrum);
  return {.pose = placed(image, pose.moved(peak.x * cell(), peak.y * cell())),
          .answer = peak.value};
}

CascadeTracker::Sighting CascadeTracker::search(const cv::Mat1b& image) {
  const Sighting here = locate(image, pose_, spectrum_);
  if (here.answer >= config_.doubtful * usual_) return here;
  Sighting best = here;
  const double stride = side_ * pose_.scale;
  for (const double down : {-stride, 0.0, stride}) {
    for (const double across : {-stride, 0.0, stride}) {
      Similarity there = pose_;
      there.x += across;
      there.y += down;
      if ((across == 0.0 && down == 0.0) || !lies_in(there, image)) continue;
      const Sighting other = locate(image, there, spectrum_);
      if (other.answer > best.answer) best = other;
    }
  }
  return best.answer >= config_.beside * here.answer ? best : here;
}

bool CascadeTracker::worth_trying(const Similarity& proposed, const Similarity& found) const {
  const double shift = std::hypot(proposed.x - found.x, proposed.y - found.y);
  const double change = std::max(std::abs(std::log(proposed.scale / found.scale)),
                                 std::abs(proposed.angle - found.angle));
  return shift > config_.least_shift * cell() * found.scale || change > config_.least_change;
}

double CascadeTracker::trust() const {
  const double likeness = static_cast<double>(likeness_);
  return std::clamp((likeness - config_.unlike) / (config_.alike - config_.unlike), 0.0, 1.0);
}

bool CascadeTracker::recognised(double answer) const {
  return answer >= config_.recognised * usual_;
}

Similarity CascadeTracker::choose(const cv::Mat1b& image, const Sighting& found) {
  look_at(image, found.pose);
  const PoseChange change = refine() * static_cast<float>(trust());
  if (static_cast<double>(likeness_) > config_.unlike) {
    // What the aspect proposes has to please the filter, which knows the background too.
    Similarity proposed =
        placed(image, found.pose.moved(static_cast<double>(change[kAcross]) * aspect_unit_,
                                       static_cast<double>(change[kDown]) * aspect_unit_));
    proposed = rescaled(proposed, std::exp(config_.gain * static_cast<double>(change[kLogScale])));
    proposed.angle += config_.gain * static_cast<double>(change[kAngle]);
    if (worth_trying(proposed, found.pose)) {
      look_around(image, proposed, spectrum_);
      if (filter_->answer(spectrum_) >= config_.better * found.answer) return proposed;
    }
  }
  // Larger and smaller in turn: a target grows for longer than a picture.
  larger_ = !larger_;
  const double step = larger_ ? config_.rescale : 1.0 / config_.rescale;
  const Sighting other = locate(image, rescaled(found.pose, step), spectrum_);
  return other.answer >= config_.rescale_better * found.answer ? other.pose : found.pose;
}

double CascadeTracker::settle(const cv::Mat1b& image, const Sighting& sighted) {
  // Once more with the target in the middle of its region, whose border is faded: answers compare.
  const Sighting found = locate(image, sighted.pose, centred_);
  pose_ = choose(image, found);
  const double moved = std::hypot(pose_.x - sighted.pose.x, pose_.y - sighted.pose.y);
  const bool seen = pose_.scale == sighted.pose.scale && pose_.angle == sighted.pose.angle &&
                    moved <= config_.still * cell() * pose_.scale;
  if (!seen) look_around(image, pose_, centred_);
  return found.answer;
}

bool CascadeTracker::is_back(const cv::Mat1b& image, const Similarity& where) {
  const Sighting found = locate(image, where, spectrum_);
  if (!recognised(found.answer)) return false;
  look_at(image, found.pose);
  (void)refine();
  if (static_cast<double>(likeness_) < config_.alike) return false;
  pose_ = found.pose;
  lost_ = false;
  doubtful_ = 0;
  return true;
}

bool CascadeTracker::look_elsewhere(const cv::Mat1b& image) {
  if (is_back(image, pose_)) return true;
  constexpr double kOverlap = 0.5;  // of one region with the next
  const double stride = kOverlap * search_unit_ * pose_.scale * GradientFeatures::kSide;
  const auto columns = static_cast<std::size_t>(std::ceil(image.cols / stride));
  const auto rows = static_cast<std::size_t>(std::ceil(image.rows / stride));
  for (int probe = 0; probe < config_.probes; ++probe) {
    place_ = (place_ + 1) % (columns * rows);
    Similarity there = pose_;
    const std::size_t row = place_ / columns;
    there.x = (static_cast<double>(place_ - row * columns) + 0.5) * stride;
    there.y = (static_cast<double>(row) + 0.5) * stride;
    if (is_back(image, there)) return true;
  }
  return false;
}

void CascadeTracker::learn(const cv::Mat1b& image, double answer) {
  if (!recognised(answer)) return;
  filter_->learn(centred_, config_.rate);
  memory_.use(matched_);
  const double likeness = static_cast<double>(likeness_);
  if (likeness < config_.new_aspect_below && likeness > config_.new_aspect_above) {
    look_at(image, pose_);
    memory_.remember(*trainer_, aspect_patch_, matched_);
  }
}

double CascadeTracker::judge(double answer) {
  const double evidence = config_.bias + config_.by_answer * answer / first_answer_;
  const double known = std::clamp(static_cast<double>(likeness_) / config_.familiar, 0.0, 1.0);
  const double confidence = known / (1.0 + std::exp(-evidence));
  usual_ += config_.habit * trust() * (answer - usual_);
  doubtful_ = confidence < config_.lost_below ? doubtful_ + 1 : 0;
  lost_ = doubtful_ >= config_.patience;
  return lost_ ? 0.0 : std::max(confidence, kLeastConfidence);
}

Track CascadeTracker::follow(const Picture& picture) {
  const cv::Mat1b& image = picture.grey;
  pyramid_.forget();
  double confidence = 0.0;
  if (!lost_ || look_elsewhere(image)) {
    const Sighting sighted = search(image);        // the longest range: wherever it went
    const double answer = settle(image, sighted);  // the shorter ones: position, scale, rotation
    learn(image, answer);
    confidence = judge(answer);
  }
  return {.box = {.x = pose_.x,
                  .y = pose_.y,
                  .width = width_ * pose_.scale,
                  .height = height_ * pose_.scale},
          .confidence = confidence};
}

void CascadeTracker::annotate(Annotations& annotations) const {
  if (!filter_) return;  // not started
  const double reach = 0.5 * search_unit_ * GradientFeatures::kSide;
  outline(pose_, reach, reach, lost_ ? Tone::kIgnored : Tone::kNeutral, annotations);
  outline(pose_, 0.5 * width_, 0.5 * height_, Tone::kMatched, annotations);  // turned as it is
  const int side = config_.predictor.side;
  for (std::size_t i = 0; i < memory_.size(); ++i) {
    PatchMark patch{.size = {side, side}, .grey = {}, .tone = Tone::kNeutral};
    const Eigen::VectorXf& reference = memory_[i].reference;
    const float low = reference.minCoeff();
    const float span = std::max(reference.maxCoeff() - low, 1e-6F);
    for (const float value : reference) {
      patch.grey.push_back(static_cast<std::uint8_t>(255.0F * (value - low) / span));
    }
    if (i == matched_) patch.tone = Tone::kMatched;
    annotations.patches.push_back(std::move(patch));
  }
}

}  // namespace pacer::tracking
