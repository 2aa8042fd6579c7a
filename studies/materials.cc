// SPDX-License-Identifier: Apache-2.0
#include "studies/materials.h"

#include <fmt/format.h>
#include <sched.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

#include "core/hash.h"
#include "runs/collect.h"
#include "runs/render_sequences.h"
#include "runs/train.h"

namespace pacer {
namespace {

std::uint64_t hash_of_this_program() {
  std::ifstream program("/proc/self/exe", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(program), {}};
  return fnv1a(bytes);
}

/// Copies a folder; `to` is there whole or not at all.
void copy_whole(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::filesystem::path aside = to;
  aside += ".copying";
  std::filesystem::remove_all(aside);
  std::filesystem::copy(from, aside, std::filesystem::copy_options::recursive);
  std::filesystem::rename(aside, to);
}

}  // namespace

Materials::Materials(const StudyContext& context)
    : context_(context), program_(hash_of_this_program()) {}

std::filesystem::path Materials::place(const std::string& kind, const std::string& made_of) const {
  std::filesystem::create_directories(context_.cache);
  return context_.cache / fmt::format("{}-{:016x}", kind, fnv1a(made_of, program_));
}

std::filesystem::path Materials::recording(Purpose purpose, std::uint64_t episodes) const {
  const std::string made_of =
      fmt::format("{} {}", static_cast<int>(purpose), to_yaml(context_.scenario));
  // A folder for each number of episodes: a study must not see more than it asked for. A longer
  // recording begins with the shorter one, and goes on from a copy of it.
  const auto folder_of = [&](std::uint64_t count) {
    return place(fmt::format("drives-{}", count), made_of);
  };
  std::filesystem::path folder = folder_of(episodes);
  if (!std::filesystem::exists(folder)) {
    for (std::uint64_t shorter = episodes; shorter > 1;) {
      if (!std::filesystem::exists(folder_of(--shorter))) continue;
      copy_whole(folder_of(shorter), folder);
      break;
    }
  }
  if (!collect(context_.scenario, purpose, episodes, folder, context_.control).whole) {
    throw StudyStopped();
  }
  return folder;
}

std::filesystem::path Materials::model(std::uint64_t episodes, const std::string& name) const {
  return model(context_.scenario.affordance, episodes, name);
}

std::filesystem::path Materials::model(const affordance::AffordanceConfig& config,
                                       std::uint64_t episodes, const std::string& name) const {
  Scenario scenario = context_.scenario;
  scenario.affordance = config;
  std::filesystem::path file =
      place("model", fmt::format("{} {}", episodes, to_yaml(scenario))) / (name + ".model");
  if (!std::filesystem::exists(file)) {
    (void)train_affordance(scenario, recording(Purpose::kCollect, episodes), file,
                           context_.control);
  }
  return file;
}

std::filesystem::path Materials::baseline(const std::string& method, std::uint64_t episodes) const {
  std::filesystem::path file =
      place("baseline", fmt::format("{} {}", episodes, to_yaml(context_.scenario))) /
      (method + ".model");
  if (!std::filesystem::exists(file)) {
    (void)train_baseline(context_.scenario, method, recording(Purpose::kCollect, episodes), file,
                         context_.control);
  }
  return file;
}

std::filesystem::path Materials::exemplar_model(const exemplar::ExemplarConfig& config,
                                                std::uint64_t episodes,
                                                const std::string& name) const {
  Scenario scenario = context_.scenario;
  scenario.exemplar = config;
  std::filesystem::path file =
      place("exemplar", fmt::format("{} {}", episodes, to_yaml(scenario))) / (name + ".model");
  if (!std::filesystem::exists(file)) {
    (void)train_exemplar(scenario, recording(Purpose::kCollect, episodes), {}, file,
                         context_.control);
  }
  return file;
}

std::filesystem::path Materials::sequences(std::uint64_t seed) const {
  std::filesystem::path folder = place("sequences", std::to_string(seed));
  if (!render_sequences({}, seed, folder, context_.control).whole) {
    throw StudyStopped();
  }
  return folder;
}

std::string Materials::fingerprint() const {
  return fmt::format("{:016x}", fnv1a(to_yaml(context_.scenario), program_));
}

std::uint64_t Materials::minutes(double count) const {
  constexpr double kMinute = 60.0;  // seconds
  return std::max<std::uint64_t>(
      1,
      static_cast<std::uint64_t>(kMinute * count / context_.scenario.simulated.duration.count()));
}

struct OneCore::Saved {
  cpu_set_t set;
};

OneCore::OneCore(std::uint64_t which) : saved_(std::make_unique<Saved>()) {
  if (::sched_getaffinity(0, sizeof saved_->set, &saved_->set) != 0) {
    throw std::system_error(errno, std::generic_category(), "sched_getaffinity");
  }
  which %= static_cast<std::uint64_t>(CPU_COUNT(&saved_->set));
  int core = 0;
  while (!CPU_ISSET(core, &saved_->set) || which-- > 0) ++core;
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(core, &one);
  if (::sched_setaffinity(0, sizeof one, &one) != 0) {
    throw std::system_error(errno, std::generic_category(), "sched_setaffinity");
  }
}

OneCore::~OneCore() { ::sched_setaffinity(0, sizeof saved_->set, &saved_->set); }

}  // namespace pacer
