// SPDX-License-Identifier: Apache-2.0
#include "learning/baselines/nearest_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "core/check.h"
#include "core/parallel.h"

namespace pacer::baselines {
namespace {

// What is chosen from.
constexpr int kWidths[] = {12, 16, 24, 32};  // pixels; heights follow the frame's shape
constexpr std::size_t kNeighbours[] = {1, 3, 9, 27, 81, 243};
constexpr std::size_t kMostNeighbours = 243;

constexpr std::size_t kEvery = 5;  // frames held out that one is predicted of

/// What is kept of the frames of one fold.
struct Examples {
  std::vector<PictureTable> pictures;  // one for each width
  std::vector<Command> commands;
};

Command mean_of(std::span<const Nearest::Neighbour> neighbours, std::span<const Command> commands) {
  Command sum;
  for (const Nearest::Neighbour& neighbour : neighbours) {
    sum.steering += commands[neighbour.index].steering;
    sum.throttle += commands[neighbour.index].throttle;
  }
  const auto count = static_cast<double>(neighbours.size());
  return {.steering = sum.steering / count, .throttle = sum.throttle / count};
}

/// Squared errors of each number of neighbours, steering and throttle, over `count` predictions.
struct Errors {
  std::array<std::array<double, 2>, std::size(kNeighbours)> squared{};
  std::array<double, 2> sum{};     // of the commands
  std::array<double, 2> square{};  // likewise
  double count = 0.0;

  void operator+=(const Errors& other) {
    for (std::size_t stick = 0; stick < 2; ++stick) {
      for (std::size_t k = 0; k < squared.size(); ++k) squared[k][stick] += other.squared[k][stick];
      sum[stick] += other.sum[stick];
      square[stick] += other.square[stick];
    }
    count += other.count;
  }
};

/// Predicts every kEvery-th frame of `folds[held_out]` from the other folds' frames.
Errors errors_on(const std::vector<Examples>& folds, std::size_t held_out, std::size_t width,
                 const TrainingOptions& options) {
  PictureTable table{.pixels = folds[held_out].pictures[width].pixels, .values = {}};
  std::vector<Command> commands;
  for (std::size_t f = 0; f < folds.size(); ++f) {
    if (f == held_out) continue;
    const std::vector<std::int8_t>& values = folds[f].pictures[width].values;
    table.values.insert(table.values.end(), values.begin(), values.end());
    commands.insert(commands.end(), folds[f].commands.begin(), folds[f].commands.end());
  }
  Errors errors;
  if (commands.empty()) return errors;
  Nearest nearest(kMostNeighbours);
  const Examples& asked = folds[held_out];
  for (std::size_t i = 0; i < asked.commands.size(); i += kEvery) {
    if (options.stop.stop_requested()) throw TrainingStopped();
    const auto found = nearest.search(table, asked.pictures[width].picture(i));
    const std::array<double, 2> shown = {asked.commands[i].steering, asked.commands[i].throttle};
    for (std::size_t k = 0; k < std::size(kNeighbours); ++k) {
      const Command answer = mean_of(found.first(std::min(kNeighbours[k], found.size())), commands);
      errors.squared[k][0] += std::pow(answer.steering - shown[0], 2.0);
      errors.squared[k][1] += std::pow(answer.throttle - shown[1], 2.0);
    }
    for (std::size_t stick = 0; stick < 2; ++stick) {
      errors.sum[stick] += shown[stick];
      errors.square[stick] += shown[stick] * shown[stick];
    }
    errors.count += 1.0;
  }
  return errors;
}

std::string body(const NearestModel& model) {
  ByteWriter out;
  model.origin.write(out);
  out.value(static_cast<std::int32_t>(model.size.width));
  out.value(static_cast<std::int32_t>(model.size.height));
  out.value(static_cast<std::int32_t>(model.neighbours));
  out.sequence(std::span<const std::int8_t>(model.pictures.values));
  out.value(static_cast<std::uint64_t>(model.commands.size()));
  for (const Command& command : model.commands) {
    out.value(command.steering);
    out.value(command.throttle);
  }
  return out.bytes();
}

NearestModel read_body(std::string_view bytes) {
  ByteReader in(bytes);
  NearestModel model;
  model.origin = Origin::read(in);
  model.size.width = in.value<std::int32_t>();
  model.size.height = in.value<std::int32_t>();
  constexpr int kMostSide = 128;  // pixels
  for (const auto& [side, whole] : {std::pair(model.size.width, model.origin.image_size.width),
                                    {model.size.height, model.origin.image_size.height}}) {
    sane(side > 0 && side <= std::min(whole, kMostSide), "size of the small pictures");
  }
  model.neighbours = in.value<std::int32_t>();
  model.pictures.pixels =
      static_cast<std::size_t>(model.size.width) * static_cast<std::size_t>(model.size.height);
  model.pictures.values = in.sequence<std::int8_t>();
  const std::size_t count = in.count(2 * sizeof(double));
  sane(count > 0 && model.pictures.values.size() == count * model.pictures.pixels,
       "number of pictures");
  sane(model.neighbours >= 1 && static_cast<std::size_t>(model.neighbours) <= count,
       "number of neighbours");
  model.commands.resize(count);
  for (Command& command : model.commands) {
    command.steering = in.value<double>();
    command.throttle = in.value<double>();
    sane(command == clamped(command), "a command");
  }
  sane(in.rest().empty(), "something follows the commands");
  return model;
}

/// Leaves `most` of the folds' examples, evenly thinned over all of them.
void thin(std::vector<Examples>& folds, std::size_t frames, std::size_t most) {
  const std::size_t every = (frames + most - 1) / most;
  if (every == 1) return;
  std::size_t index = 0;
  for (Examples& fold : folds) {
    std::size_t left = 0;
    for (std::size_t i = 0; i < fold.commands.size(); ++i) {
      if (index++ % every != 0) continue;
      for (PictureTable& table : fold.pictures) {
        std::memmove(table.values.data() + left * table.pixels,
                     table.values.data() + i * table.pixels, table.pixels);
      }
      fold.commands[left++] = fold.commands[i];
    }
    fold.commands.resize(left);
    for (PictureTable& table : fold.pictures) table.values.resize(left * table.pixels);
  }
}

/// All folds' examples of the chosen width.
void keep(const std::vector<Examples>& folds, std::size_t width, NearestModel& model) {
  model.pictures.pixels = folds.front().pictures[width].pixels;
  for (const Examples& fold : folds) {
    const std::vector<std::int8_t>& values = fold.pictures[width].values;
    model.pictures.values.insert(model.pictures.values.end(), values.begin(), values.end());
    model.commands.insert(model.commands.end(), fold.commands.begin(), fold.commands.end());
  }
}

}  // namespace

std::string to_bytes(const NearestModel& model) { return sealed(NearestModel::kFile, body(model)); }

NearestModel nearest_from_bytes(std::string_view bytes, std::string_view source) {
  return unsealed(NearestModel::kFile, bytes, source, read_body);
}

NearestPolicy::NearestPolicy(std::shared_ptr<const NearestModel> model)
    : model_(std::move(model)),
      small_(model_->origin.image_size, model_->size),
      seen_(model_->pictures.pixels),
      nearest_(static_cast<std::size_t>(model_->neighbours)) {}

Command NearestPolicy::act(const Observation& observation, Annotations& /*annotations*/) {
  model_->origin.require_size(observation.frame);
  quantise(small_.standardised(observation.frame), seen_);
  return mean_of(nearest_.search(model_->pictures, seen_), model_->commands);
}

std::unique_ptr<Policy> NearestPolicyModel::make(const Random& /*random*/,
                                                 std::unique_ptr<TargetPointer> /*pointer*/) const {
  return std::make_unique<NearestPolicy>(model());
}

NearestModel train_nearest(const Demonstration& demonstration, const TrainingOptions& options,
                           TrainingReport& report, std::size_t most_pictures) {
  check(most_pictures >= 1, "a nearest neighbour is one of a picture at least");
  const Folds folds(demonstration);
  const ImageSize frame = demonstration.image_size();
  std::vector<ImageSize> sizes;
  for (const int width : kWidths) {
    if (width <= frame.width) sizes.push_back(small_size(width, frame));
  }
  if (sizes.empty()) {
    throw UsageError(
        fmt::format("frames of {} x {} are too small to learn from", frame.width, frame.height));
  }
  std::vector<std::vector<SmallPicture>> small(folds.count());
  std::vector<Examples> examples(folds.count());
  for (std::size_t f = 0; f < folds.count(); ++f) {
    for (const ImageSize& size : sizes) {
      small[f].emplace_back(frame, size);
      const auto pixels =
          static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
      examples[f].pictures.push_back({.pixels = pixels, .values = {}});
    }
  }
  const Folds::Reading reading =
      folds.read(options, [&](std::size_t fold, const DemonstratedStep& step) {
        for (std::size_t s = 0; s < sizes.size(); ++s) {
          PictureTable& table = examples[fold].pictures[s];
          table.values.resize(table.values.size() + table.pixels);
          quantise(small[fold][s].standardised(*step.frame),
                   std::span(table.values).last(table.pixels));
        }
        examples[fold].commands.push_back(step.command);
      });
  report.episodes = reading.episodes;
  report.frames = reading.frames;
  thin(examples, reading.frames, most_pictures);

  for (std::size_t s = 0; s < sizes.size(); ++s) {
    std::vector<Errors> errors(folds.count());
    parallel_for(errors.size(), options.jobs,
                 [&](std::size_t f) { errors[f] = errors_on(examples, f, s, options); });
    Errors all;
    for (const Errors& fold : errors) all += fold;
    std::array<double, 2> spread{};
    for (std::size_t stick = 0; stick < 2; ++stick) {
      spread[stick] = all.square[stick] - all.sum[stick] * all.sum[stick] / all.count;
    }
    for (std::size_t k = 0; k < std::size(kNeighbours); ++k) {
      report.trials.push_back(
          {.setting = fmt::format("{} x {}, {} neighbour{}", sizes[s].width, sizes[s].height,
                                  kNeighbours[k], kNeighbours[k] == 1 ? "" : "s"),
           .error = relative_error(all.squared[k], spread, all.count)});
    }
    if (options.progress) {
      options.progress("choosing", static_cast<double>(s + 1) / static_cast<double>(sizes.size()));
    }
  }
  report.chosen = best_of(report.trials);
  NearestModel model;
  model.origin = Origin::of(demonstration, options.scenario);
  model.origin.mean = reading.mean;
  const std::size_t size = report.chosen / std::size(kNeighbours);
  model.size = sizes[size];
  keep(examples, size, model);
  model.neighbours = static_cast<int>(
      std::min(kNeighbours[report.chosen % std::size(kNeighbours)], model.commands.size()));
  report.facts = {{"pictures", static_cast<double>(model.commands.size())}};
  return model;
}

}  // namespace pacer::baselines
