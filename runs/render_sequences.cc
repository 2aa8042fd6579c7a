// SPDX-License-Identifier: Apache-2.0
#include "runs/render_sequences.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "core/check.h"
#include "dataset/files.h"
#include "dataset/sequence.h"
#include "runs/shared_counter.h"
#include "runs/worker_pool.h"

namespace pacer {
namespace {

namespace fs = std::filesystem;
using sim::SimulatedSequence;

constexpr const char* kDescription = "simulated.json";

std::vector<SimulatedSequence> chosen(const std::vector<std::string>& names) {
  const std::vector<SimulatedSequence>& all = sim::simulated_sequences();
  if (names.empty()) return all;
  std::vector<SimulatedSequence> found;
  for (const std::string& name : names) {
    const auto one = std::ranges::find(all, name, &SimulatedSequence::name);
    if (one == all.end()) {
      std::string known;
      for (const SimulatedSequence& each : all) known += (known.empty() ? "" : ", ") + each.name;
      throw UsageError(fmt::format("{}: no such sequence; there are {}", name, known));
    }
    if (std::ranges::find(found, name, &SimulatedSequence::name) == found.end()) {
      found.push_back(*one);
    }
  }
  return found;
}

nlohmann::ordered_json describe(const SimulatedSequence& sequence, std::uint64_t seed) {
  return {{"name", sequence.name},
          {"about", sequence.about},
          {"seed", seed},
          {"frames", sequence.frames},
          {"width", sequence.size.width},
          {"height", sequence.size.height}};
}

/// Whether `place` holds this very sequence. Throws UsageError when it holds something else.
bool is_there(const fs::path& place, const SimulatedSequence& sequence, std::uint64_t seed) {
  if (!fs::exists(place)) return false;
  const fs::path file = place / kDescription;
  const auto refuse = [&place](const std::string& what) {
    throw UsageError(
        fmt::format("{}: {}; name another folder, or remove it", place.string(), what));
  };
  if (!fs::exists(file)) refuse("is there, and no simulated sequence");
  const nlohmann::json found =
      nlohmann::json::parse(dataset::read_text(file), nullptr, /*allow_exceptions=*/false);
  const nlohmann::json wanted = describe(sequence, seed);
  if (!found.is_object()) refuse(fmt::format("its {} is damaged", kDescription));
  for (const char* key : {"name", "frames", "width", "height", "seed"}) {
    if (!found.contains(key) || found[key] != wanted[key]) {
      refuse(fmt::format("holds a sequence of another {}", key));
    }
  }
  return true;
}

/// Renders aside and moves what is finished into its place.
void render(const SimulatedSequence& sequence, std::uint64_t seed, const fs::path& folder,
            SharedCounter& counter) {
  const fs::path aside = folder / (".unfinished-" + sequence.name);
  fs::remove_all(aside);  // of a run that was killed
  dataset::SequenceWriter writer(aside);
  sim::render_sequence(sequence, seed, [&](const Frame& frame, const Box& truth) {
    writer.write(frame, truth);
    counter.add(1);
    return true;
  });
  writer.close();
  dataset::write_text(aside / kDescription, describe(sequence, seed).dump(2) + "\n");
  dataset::move(aside, folder / sequence.name);
  dataset::sync(folder);
}

}  // namespace

RenderSequencesReport render_sequences(const std::vector<std::string>& names, std::uint64_t seed,
                                       const fs::path& folder, const RunControl& control) {
  const auto start = std::chrono::steady_clock::now();
  const std::vector<SimulatedSequence> wanted = chosen(names);
  dataset::make_folder(folder);
  const dataset::FolderLock lock(folder);
  RenderSequencesReport report;
  std::vector<std::uint32_t> missing;
  std::uint64_t frames = 0;
  for (std::uint32_t i = 0; i < wanted.size(); ++i) {
    const SimulatedSequence& sequence = wanted[i];
    report.sequences.push_back({sequence, is_there(folder / sequence.name, sequence, seed)});
    if (report.sequences.back().was_there) continue;
    missing.push_back(i);
    frames += static_cast<std::uint64_t>(sequence.frames);
  }
  // The longest work first, so that no worker is left alone with it at the end.
  std::ranges::stable_sort(missing, std::greater{}, [&wanted](std::uint32_t i) {
    const SimulatedSequence& one = wanted[i];
    return static_cast<std::int64_t>(one.frames) * one.size.width * one.size.height;
  });

  SharedCounter counter;
  const auto tick = [&] { control.progress(counter.value(), frames, "frames rendered"); };
  tick();
  report.whole = run_in_workers(
      control.jobs, missing,
      [&](std::uint32_t i) {
        render(wanted[i], seed, folder, counter);
        return std::string();
      },
      [](std::uint32_t, const std::string&) {}, control.stop, tick);
  tick();
  std::erase_if(report.sequences, [&folder](const RenderedSequence& one) {
    return !fs::exists(folder / one.sequence.name);
  });
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace pacer
