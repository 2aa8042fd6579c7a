// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/lag.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/check.h"
#include "core/parallel.h"
#include "learning/affordance/median.h"
#include "learning/affordance/perception.h"
#include "learning/affordance/train.h"
#include "learning/read_episodes.h"

namespace pacer::affordance {
namespace {

/// Holds back pictures until their answer has come.
class AnsweredStream final : public DemonstrationStream {
 public:
  AnsweredStream(std::unique_ptr<DemonstrationStream> steps, std::size_t lag)
      : steps_(std::move(steps)), waiting_(lag + 1) {}

  const DemonstratedStep* next() override {
    while (const DemonstratedStep* step = steps_->next()) {
      waiting_[read_++ % waiting_.size()] = *step->frame;
      if (read_ < waiting_.size()) continue;
      // The slot that will be written next holds the oldest.
      answered_ = {.frame = &waiting_[read_ % waiting_.size()], .command = step->command};
      return &answered_;
    }
    return nullptr;
  }

 private:
  std::unique_ptr<DemonstrationStream> steps_;
  std::vector<Frame> waiting_;  // a ring: picture n is in n modulo its size
  std::size_t read_ = 0;
  DemonstratedStep answered_;
};

/// The `first` episode and every `stride`-th after it, so that what was learnt can be held against
/// what was not.
class SomeEpisodes final : public Demonstration {
 public:
  SomeEpisodes(const Demonstration& demonstration, std::size_t first, std::size_t stride)
      : demonstration_(demonstration), first_(first), stride_(stride) {}
  std::size_t episode_count() const override {
    return (demonstration_.episode_count() - first_ + stride_ - 1) / stride_;
  }
  double frame_rate_hz() const override { return demonstration_.frame_rate_hz(); }
  ImageSize image_size() const override { return demonstration_.image_size(); }
  std::string fingerprint() const override { return demonstration_.fingerprint(); }
  std::unique_ptr<DemonstrationStream> open(std::size_t episode) const override {
    return demonstration_.open(stride_ * episode + first_);
  }

 private:
  const Demonstration& demonstration_;
  std::size_t first_;
  std::size_t stride_;
};

/// Some pictures of an episode, and every command that was sent.
struct Watched {
  std::vector<Command> sent;          // of every frame
  std::vector<std::size_t> pictures;  // which frames
  std::vector<Features> features;     // one each
  std::vector<char> matched;          // one each: whether a rule does
  std::vector<Command> called_for;    // one each, where one does: what a model makes of it
};

/// Keeps every other, the first among them.
template <class Value>
void halve(std::vector<Value>& values) {
  for (std::size_t i = 0; 2 * i < values.size(); ++i) std::swap(values[i], values[2 * i]);
  values.resize((values.size() + 1) / 2);
}

/// Takes the features of at most `most` pictures, evenly spaced.
Watched watch(TrainingSteps<DemonstrationStream>& steps, const FeatureConfig& config,
              std::size_t most) {
  Watched watched;
  FeatureExtractor extractor(config);
  std::size_t every = 2;
  while (const DemonstratedStep* step = steps.next()) {
    if (watched.sent.size() % every == 0) {
      if (watched.pictures.size() == most) {
        halve(watched.pictures);
        halve(watched.features);
        every *= 2;
      }
      if (watched.sent.size() % every == 0) {
        watched.pictures.push_back(watched.sent.size());
        extractor.extract(*step->frame, watched.features.emplace_back());
      }
    }
    watched.sent.push_back(step->command);
  }
  return watched;
}

/// The plain median of what the rules that match predict (6.6.2).
void answer(const Model& model, Watched& watched) {
  Perception perception(model);
  std::vector<Weighted> values;
  watched.matched.assign(watched.pictures.size(), 0);
  watched.called_for.resize(watched.pictures.size());
  for (std::size_t i = 0; i < watched.pictures.size(); ++i) {
    perception.look(watched.features[i]);
    const std::span<const Vote> votes = perception.match();
    if (votes.empty()) continue;
    const auto median_of = [&](double Command::*component) {
      values.clear();
      for (const Vote& vote : votes) values.push_back({.value = vote.action.*component});
      return weighted_median(values);
    };
    watched.matched[i] = 1;
    watched.called_for[i] = {.steering = median_of(&Command::steering),
                             .throttle = median_of(&Command::throttle)};
  }
}

/// The square of the correlation of `a` and `b`; 0 where they fall as one rises, or one is
/// constant.
double explained(const std::vector<double>& a, const std::vector<double>& b) {
  const auto count = static_cast<double>(a.size());
  double mean_a = 0.0;
  double mean_b = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    mean_a += a[i] / count;
    mean_b += b[i] / count;
  }
  double ab = 0.0;
  double aa = 0.0;
  double bb = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (a[i] - mean_a) * (b[i] - mean_b);
    aa += (a[i] - mean_a) * (a[i] - mean_a);
    bb += (b[i] - mean_b) * (b[i] - mean_b);
  }
  return ab > 0.0 && aa > 0.0 && bb > 0.0 ? ab * ab / (aa * bb) : 0.0;
}

/// How well the answers explain the commands sent at each lag up to `longest`. Every lag is
/// measured on the same pictures.
void measure(const std::vector<Watched>& episodes, std::size_t longest, FoundLag& found) {
  found.explained.clear();
  for (std::size_t lag = 0; lag <= longest; ++lag) {
    double sum = 0.0;
    for (double Command::*component : {&Command::steering, &Command::throttle}) {
      std::vector<double> called_for;
      std::vector<double> sent;
      for (const Watched& episode : episodes) {
        for (std::size_t i = 0; i < episode.pictures.size(); ++i) {
          const std::size_t frame = episode.pictures[i];
          if (frame + longest >= episode.sent.size()) break;
          if (episode.matched[i] == 0) continue;
          called_for.push_back(episode.called_for[i].*component);
          sent.push_back(episode.sent[frame + lag].*component);
        }
      }
      found.pictures = sent.size();
      sum += explained(called_for, sent);
    }
    found.explained.push_back(0.5 * sum);
  }
  found.frames =
      static_cast<int>(std::ranges::max_element(found.explained) - found.explained.begin());
}

}  // namespace

AnsweredDemonstration::AnsweredDemonstration(const Demonstration& demonstration, int lag)
    : demonstration_(demonstration), lag_(lag) {
  check(lag >= 0, "a command answers a picture that has been seen");
}

std::size_t longest_lag(double frame_rate_hz) {
  constexpr double kRounding = 1e-9;  // of a frame
  return static_cast<std::size_t>(std::floor(kLongestLag.count() * frame_rate_hz + kRounding));
}

std::unique_ptr<DemonstrationStream> AnsweredDemonstration::open(std::size_t episode) const {
  if (lag_ == 0) return demonstration_.open(episode);
  return std::make_unique<AnsweredStream>(demonstration_.open(episode),
                                          static_cast<std::size_t>(lag_));
}

FoundLag find_lag(const Demonstration& demonstration, const AffordanceConfig& config,
                  const Random& random, const TrainingOptions& options) {
  constexpr std::size_t kEnough = 1500;  // pictures to learn from, and to measure on
  constexpr int kMostRounds = 4;
  constexpr std::size_t kLeastPictures = 50;
  if (demonstration.episode_count() < 2) {
    throw UsageError(
        "transactions.lag_s: to find the lag takes two episodes at least, one to learn from and "
        "one to hold it against; record more, or give the lag in seconds");
  }
  const std::size_t longest = longest_lag(demonstration.frame_rate_hz());
  AffordanceConfig modest = config;
  modest.transactions.lag = "0";
  modest.transactions.most_frames =
      std::min(static_cast<int>(kEnough), config.transactions.most_frames);
  TrainingOptions telling = options;
  if (options.progress) {
    telling.progress = [&](std::string_view stage, double share) {
      options.progress("lag: " + std::string(stage), share);
    };
  }
  const PictureShares shares = picture_shares(demonstration.episode_count() / 2, kEnough);
  const SomeEpisodes rest(demonstration, 1, 2 * shares.stride);
  std::vector<Watched> watched(rest.episode_count());
  read_episodes(rest, telling, "pictures", [&](std::size_t episode, auto& steps) {
    watched[episode] = watch(steps, config.features, shares.each);
  });

  FoundLag found;
  while (found.rounds < kMostRounds) {
    const int before = found.frames;
    ++found.rounds;
    const AnsweredDemonstration answered(demonstration, before);
    const Model model = train(SomeEpisodes(answered, 0, 2), modest, random, telling).model;
    parallel_for(watched.size(), options.jobs,
                 [&](std::size_t episode) { answer(model, watched[episode]); });
    measure(watched, longest, found);
    if (found.pictures < kLeastPictures) {
      throw UsageError("transactions.lag_s: rules match in " + std::to_string(found.pictures) +
                       " pictures only, too few to find the lag; record more, or give the lag in "
                       "seconds");
    }
    found.settled = found.frames == before;
    if (found.settled) break;
  }
  return found;
}

SettledLag settle_lag(const Demonstration& demonstration, const AffordanceConfig& config,
                      const Random& random, const TrainingOptions& options) {
  config.validate();
  const double rate_hz = demonstration.frame_rate_hz();
  SettledLag settled{.frames = 0, .found = {}, .config = config};
  if (const std::optional<Seconds> given = config.transactions.given_lag()) {
    settled.frames = static_cast<int>(std::lround(given->count() * rate_hz));
    return settled;
  }
  settled.found = find_lag(demonstration, config, random.fork("lag"), options);
  settled.frames = settled.found->frames;
  std::array<char, 32> digits{};
  const double seconds =
      std::min(kLongestLag.count(), static_cast<double>(settled.frames) / rate_hz);
  settled.config.transactions.lag.assign(
      digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), seconds).ptr);
  return settled;
}

}  // namespace pacer::affordance
