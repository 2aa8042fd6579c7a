// SPDX-License-Identifier: Apache-2.0
#include "learning/baselines/ridge_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/check.h"
#include "core/parallel.h"
#include "learning/baselines/small_picture.h"

namespace pacer::baselines {
namespace {

// What is chosen from.
constexpr int kGreyWidths[] = {12, 16, 24, 32, 40};  // pixels; heights follow the frame's shape
constexpr ImageSize kHogSizes[] = {{32, 24}, {48, 40}, {64, 48}};
constexpr double kRidges[] = {0.01, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0};

std::string body(const RidgeModel& model) {
  ByteWriter out;
  model.origin.write(out);
  out.value(static_cast<std::uint8_t>(model.features.kind));
  out.value(static_cast<std::int32_t>(model.features.size.width));
  out.value(static_cast<std::int32_t>(model.features.size.height));
  out.value(model.ridge);
  out.value(model.action.bias.steering);
  out.value(model.action.bias.throttle);
  out.sequence(std::span<const float>(model.action.steering));
  out.sequence(std::span<const float>(model.action.throttle));
  return out.bytes();
}

RidgeModel read_body(std::string_view bytes) {
  ByteReader in(bytes);
  RidgeModel model;
  model.origin = Origin::read(in);
  const auto kind = in.value<std::uint8_t>();
  sane(kind <= static_cast<std::uint8_t>(PictureKind::kHog), "kind of features");
  model.features.kind = static_cast<PictureKind>(kind);
  model.features.size.width = in.value<std::int32_t>();
  model.features.size.height = in.value<std::int32_t>();
  constexpr int kMostSide = 512;  // pixels
  sane(std::max(model.features.size.width, model.features.size.height) <= kMostSide,
       "size of the small picture");
  model.features.validate(model.origin.image_size);
  model.ridge = in.value<double>();
  sane(std::isfinite(model.ridge) && model.ridge > 0.0, "ridge");
  model.action.bias.steering = in.value<double>();
  model.action.bias.throttle = in.value<double>();
  sane(std::isfinite(model.action.bias.steering) && std::isfinite(model.action.bias.throttle),
       "bias");
  const std::size_t inputs = PictureFeatures(model.features, model.origin.image_size).count();
  for (std::vector<float>* weights : {&model.action.steering, &model.action.throttle}) {
    *weights = in.sequence<float>();
    sane(weights->size() == inputs, "number of weights");
    sane(std::ranges::all_of(*weights, [](float w) { return std::isfinite(w); }), "weights");
  }
  sane(in.rest().empty(), "something follows the weights");
  return model;
}

std::vector<FeatureChoice> choices(PictureKind kind, ImageSize frame) {
  std::vector<FeatureChoice> choices;
  if (kind == PictureKind::kHog) {
    for (const ImageSize& size : kHogSizes) choices.push_back({.kind = kind, .size = size});
  } else {
    for (const int width : kGreyWidths) {
      choices.push_back({.kind = kind, .size = small_size(width, frame)});
    }
  }
  std::erase_if(choices, [&](const FeatureChoice& choice) {
    return choice.size.width > frame.width || choice.size.height > frame.height;
  });
  if (choices.empty()) {
    throw UsageError(
        fmt::format("frames of {} x {} are too small to learn from", frame.width, frame.height));
  }
  return choices;
}

/// The sums of every fold, of one choice of features.
using FoldSums = std::vector<RegressionSums>;

/// How well each ridge does on the folds held out in turn.
std::vector<Trial> try_ridges(const FoldSums& folds, const RegressionSums& all,
                              const FeatureChoice& choice, const TrainingOptions& options) {
  constexpr std::size_t kCount = std::size(kRidges);
  std::vector<std::array<double, 2>> errors(folds.size() * kCount);
  parallel_for(errors.size(), options.jobs, [&](std::size_t i) {
    if (options.stop.stop_requested()) throw TrainingStopped();
    const RegressionSums& held_out = folds[i / kCount];
    if (held_out.count() == 0.0) return;
    RegressionSums rest = all;
    rest -= held_out;
    const Eigen::Vector2d error = held_out.squared_error(rest.fit(kRidges[i % kCount]));
    errors[i] = {error.x(), error.y()};
  });
  const Eigen::Vector2d spread = all.spread();
  std::vector<Trial> trials;
  for (std::size_t r = 0; r < kCount; ++r) {
    std::array<double, 2> squared{};
    for (std::size_t f = 0; f < folds.size(); ++f) {
      squared[0] += errors[f * kCount + r][0];
      squared[1] += errors[f * kCount + r][1];
    }
    trials.push_back({.setting = fmt::format("{}, ridge {}", choice.text(), kRidges[r]),
                      .error = relative_error(squared, {spread.x(), spread.y()}, all.count())});
  }
  return trials;
}

}  // namespace

std::string to_bytes(const RidgeModel& model) { return sealed(RidgeModel::kFile, body(model)); }

RidgeModel ridge_from_bytes(std::string_view bytes, std::string_view source) {
  return unsealed(RidgeModel::kFile, bytes, source, read_body);
}

RidgePolicy::RidgePolicy(std::shared_ptr<const RidgeModel> model)
    : model_(std::move(model)), features_(model_->features, model_->origin.image_size) {}

Command RidgePolicy::act(const Observation& observation, Annotations& /*annotations*/) {
  model_->origin.require_size(observation.frame);
  return model_->action(features_.of(observation.frame));
}

std::string_view RidgePolicyModel::method() const {
  return model()->features.kind == PictureKind::kHog ? "ridge-hog" : "ridge";
}

std::unique_ptr<Policy> RidgePolicyModel::make(const Random& /*random*/,
                                               std::unique_ptr<TargetPointer> /*pointer*/) const {
  return std::make_unique<RidgePolicy>(model());
}

RidgeModel train_ridge(const Demonstration& demonstration, PictureKind kind,
                       const TrainingOptions& options, TrainingReport& report) {
  const Folds folds(demonstration);
  const std::vector<FeatureChoice> tried = choices(kind, demonstration.image_size());
  // Of each fold, features of its own, as it may be read on a thread of its own.
  std::vector<std::vector<PictureFeatures>> features(folds.count());
  std::vector<FoldSums> sums(tried.size());  // [choice][fold]
  for (std::size_t c = 0; c < tried.size(); ++c) {
    for (std::size_t f = 0; f < folds.count(); ++f) {
      features[f].emplace_back(tried[c], demonstration.image_size());
      sums[c].emplace_back(features[f][c].count());
    }
  }
  const Folds::Reading reading =
      folds.read(options, [&](std::size_t fold, const DemonstratedStep& step) {
        for (std::size_t c = 0; c < tried.size(); ++c) {
          sums[c][fold].add(features[fold][c].of(*step.frame), step.command);
        }
      });
  report.episodes = reading.episodes;
  report.frames = reading.frames;

  std::vector<RegressionSums> all;
  for (std::size_t c = 0; c < tried.size(); ++c) {
    all.emplace_back(features[0][c].count());
    for (RegressionSums& fold : sums[c]) {
      fold.finish();
      all[c] += fold;
    }
    all[c].finish();
    const std::vector<Trial> trials = try_ridges(sums[c], all[c], tried[c], options);
    report.trials.insert(report.trials.end(), trials.begin(), trials.end());
    if (options.progress) {
      options.progress("choosing", static_cast<double>(c + 1) / static_cast<double>(tried.size()));
    }
  }
  report.chosen = best_of(report.trials);
  const std::size_t choice = report.chosen / std::size(kRidges);
  RidgeModel model;
  model.origin = Origin::of(demonstration, options.scenario);
  model.origin.mean = reading.mean;
  model.features = tried[choice];
  model.ridge = kRidges[report.chosen % std::size(kRidges)];
  model.action = all[choice].fit(model.ridge);
  report.facts = {{"inputs", static_cast<double>(model.action.steering.size())}};
  return model;
}

}  // namespace pacer::baselines
