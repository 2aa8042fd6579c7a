// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/random.h"
#include "dataset/files.h"
#include "dataset/recorder.h"
#include "dataset/writer.h"
#include "tests/support/scratch.h"

namespace pacer::dataset::testing {

using pacer::testing::Scratch;

inline DatasetSpec small_spec() {
  DatasetSpec spec;
  spec.image_size = {.width = 64, .height = 48};
  spec.signals = {{.name = "privileged.lead_box", .components = {"x", "y", "width", "height"}},
                  {.name = "privileged.lead_in_view", .components = {"fraction"}}};
  spec.scenario = "seed: 7\ncamera:\n  rate_hz: 25\n";
  return spec;
}

/// What happens at step `index` of episode `episode`: the same on every call.
struct MadeUpStep {
  Frame frame;
  std::vector<float> signals;
  Annotations annotations;
  Command wanted, sent;
  Pulses pulses;

  [[nodiscard]] Step step() const {
    return {.wanted = wanted,
            .sent = sent,
            .pulses = pulses,
            .driver = Driver::kTeacher,
            .signals = signals,
            .annotations = annotations};
  }
};

inline MadeUpStep made_up_step(const DatasetSpec& spec, std::int64_t episode, std::int64_t index) {
  Random random = Random(11)
                      .fork("episode", static_cast<std::uint64_t>(episode))
                      .fork("step", static_cast<std::uint64_t>(index));
  MadeUpStep made;
  made.frame.index = static_cast<std::uint64_t>(index);
  made.frame.time = Seconds{100.0 + static_cast<double>(index) / spec.rate_hz};
  made.frame.size = spec.image_size;
  // A bright square runs over a ramp: smooth, so that a codec keeps it.
  for (int y = 0; y < spec.image_size.height; ++y) {
    for (int x = 0; x < spec.image_size.width; ++x) {
      const auto left = static_cast<int>((4 * index + 16 * episode) % spec.image_size.width);
      const bool square = x >= left && x < left + 16 && y >= 16 && y < 32;
      made.frame.rgb.push_back(static_cast<std::uint8_t>(square ? 220 : 60 + x));
      made.frame.rgb.push_back(static_cast<std::uint8_t>(square ? 200 : 60 + y));
      made.frame.rgb.push_back(static_cast<std::uint8_t>(square ? 40 : 100));
    }
  }
  std::size_t width = 0;
  for (const SignalColumn& signal : spec.signals) width += signal.components.size();
  for (std::size_t i = 0; i < width; ++i) {
    made.signals.push_back(static_cast<float>(random.uniform(0.0, 64.0)));
  }
  made.wanted = {.steering = random.uniform(-1.0, 1.0), .throttle = random.uniform(-1.0, 1.0)};
  made.sent = {.steering = made.wanted.steering, .throttle = 0.5 * made.wanted.throttle};
  made.pulses = {.steering = Pulse{6000 + index}, .throttle = Pulse{5000 - index}};
  return made;
}

/// Records an episode whole, ready to be committed.
inline void record_episode(const std::filesystem::path& root, const DatasetSpec& spec,
                           std::int64_t episode, std::int64_t length) {
  EpisodeRecorder recorder(root, spec, episode);
  for (std::int64_t index = 0; index < length; ++index) {
    const MadeUpStep made = made_up_step(spec, episode, index);
    ASSERT_TRUE(recorder.write(made.frame, made.step()));
  }
  recorder.finish();
}

/// Records and commits episodes until there are `episodes`; episode i is `length` + i frames long.
inline void record_dataset(const std::filesystem::path& root, const DatasetSpec& spec,
                           std::int64_t episodes, std::int64_t length) {
  DatasetWriter writer(root, spec);
  for (writer.commit_finished(); writer.episodes() < episodes; writer.commit()) {
    record_episode(root, spec, writer.episodes(), length + writer.episodes());
  }
}

/// Every file below a folder with its bytes.
inline std::map<std::string, std::string> contents_of(const std::filesystem::path& root) {
  std::map<std::string, std::string> contents;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    const std::string name = entry.path().lexically_relative(root).generic_string();
    contents[name] = entry.is_directory() ? "/" : read_text(entry.path(), 1U << 30U);
  }
  return contents;
}

/// The names of the files that differ between two folders.
inline std::vector<std::string> differing_files(const std::filesystem::path& one,
                                                const std::filesystem::path& other) {
  auto left = contents_of(one);
  const auto right = contents_of(other);
  std::vector<std::string> differing;
  for (const auto& [name, bytes] : right) {
    const auto found = left.find(name);
    if (found == left.end() || found->second != bytes) differing.push_back(name);
    if (found != left.end()) left.erase(found);
  }
  for (const auto& [name, bytes] : left) differing.push_back(name);
  return differing;
}

}  // namespace pacer::dataset::testing
