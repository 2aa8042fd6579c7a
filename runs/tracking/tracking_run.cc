// SPDX-License-Identifier: Apache-2.0
#include "runs/tracking/tracking_run.h"

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace pacer {
namespace {

using nlohmann::json;

json to_json(const std::optional<Robustness>& robustness) {
  if (!robustness) return nullptr;
  return {robustness->runs, robustness->success, robustness->precision};
}

std::optional<Robustness> robustness_from(const json& value) {
  if (value.is_null()) return std::nullopt;
  return Robustness{.runs = value.at(0), .success = value.at(1), .precision = value.at(2)};
}

}  // namespace

double TrackingRun::fps() const noexcept {
  if (tracks.size() < 2 || update_s <= 0.0) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(tracks.size() - 1) / update_s;
}

std::string to_bytes(const TrackingRun& run) {
  std::vector<double> tracks;
  for (const tracking::Track& track : run.tracks) {
    tracks.insert(tracks.end(),
                  {track.box.x, track.box.y, track.box.width, track.box.height, track.confidence});
  }
  const json value = {{"tracker", run.tracker},
                      {"target", run.target},
                      {"first", run.first},
                      {"pictures", run.pictures},
                      {"tracks", tracks},
                      {"start_s", run.start_s},
                      {"update_s", run.update_s},
                      {"failures", run.failures},
                      {"temporal", to_json(run.temporal)},
                      {"spatial", to_json(run.spatial)},
                      {"tracker_error", run.tracker_error},
                      {"sequence_error", run.sequence_error},
                      {"whole", run.whole}};
  const std::vector<std::uint8_t> packed = json::to_cbor(value);
  return {packed.begin(), packed.end()};
}

TrackingRun tracking_run_from(std::string_view bytes) try {
  const json value = json::from_cbor(bytes.begin(), bytes.end());
  TrackingRun run{.tracker = value.at("tracker"),
                  .target = value.at("target"),
                  .first = value.at("first"),
                  .pictures = value.at("pictures"),
                  .tracks = {},
                  .start_s = value.at("start_s"),
                  .update_s = value.at("update_s"),
                  .failures = value.at("failures"),
                  .temporal = robustness_from(value.at("temporal")),
                  .spatial = robustness_from(value.at("spatial")),
                  .tracker_error = value.at("tracker_error"),
                  .sequence_error = value.at("sequence_error"),
                  .whole = value.at("whole")};
  const auto tracks = value.at("tracks").get<std::vector<double>>();
  for (std::size_t i = 0; i + 4 < tracks.size(); i += 5) {
    run.tracks.push_back({.box = {tracks[i], tracks[i + 1], tracks[i + 2], tracks[i + 3]},
                          .confidence = tracks[i + 4]});
  }
  return run;
} catch (const json::exception&) {
  throw std::invalid_argument("bytes that are no tracking run");
}

}  // namespace pacer
