// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "learning/exemplar/percept.h"
#include "runs/report/picture.h"
#include "runs/worker_pool.h"
#include "studies/balloon_pictures.h"
#include "studies/blob_pictures.h"
#include "studies/materials.h"
#include "studies/mser_balloons.h"
#include "studies/studies.h"

namespace pacer {
namespace {

constexpr int kWorlds = 200;
constexpr int kPictures = 5;      // a world
constexpr int kLeastPixels = 30;  // of a balloon that is to be found
constexpr double kNear = 2.0;     // pixels, from its middle
constexpr int kTimed = 200;       // pictures that are timed, the first of each world
constexpr int kTimedMser = 20;    // the same of the baseline, which is slow

/// How many balloons there were and were found, red and green, and what else was named.
struct Tally {
  std::array<std::int64_t, 2> there{}, found{};
  std::int64_t there_moving = 0, found_moving = 0, falsely = 0;

  void add(const Tally& other) {
    for (std::size_t i = 0; i < 2; ++i) {
      there[i] += other.there[i];
      found[i] += other.found[i];
    }
    there_moving += other.there_moving;
    found_moving += other.found_moving;
    falsely += other.falsely;
  }
  [[nodiscard]] std::int64_t all_there() const { return there[0] + there[1]; }
  [[nodiscard]] std::int64_t all_found() const { return found[0] + found[1]; }
};

using Seen = std::optional<MserBalloons::Seen>;

Seen seen(const std::optional<exemplar::Blob>& blob) {
  if (!blob) return std::nullopt;
  return MserBalloons::Seen{.centroid = blob->centroid, .area = blob->area};
}

/// Scores one picture. `wrong` gains a line for what was missed or is no balloon.
Tally score(const BalloonPicture& picture, const std::array<Seen, 2>& named, std::string* wrong) {
  Tally tally;
  const std::array<const sim::BalloonSight*, 2> truths = {&picture.truth.red, &picture.truth.green};
  for (std::size_t i = 0; i < 2; ++i) {
    const sim::BalloonSight& truth = *truths[i];
    const char* const name = i == 0 ? "red" : "green";
    if (picture.truth.spoilt_rows == 0 && truth.pixels >= kLeastPixels) {
      const double apart = named[i] ? (named[i]->centroid - truth.centroid).norm() : 0.0;
      const bool found = named[i] && apart <= kNear;
      ++tally.there[i];
      tally.found[i] += found ? 1 : 0;
      tally.there_moving += picture.moving ? 1 : 0;
      tally.found_moving += picture.moving && found ? 1 : 0;
      if (!found && wrong != nullptr) {
        *wrong += named[i] ? fmt::format("{} {:.1f} px off ", name, apart)
                           : fmt::format("{} of {} px missed ", name, truth.pixels);
      }
    }
    if (named[i] && is_false_balloon(named[i]->centroid, named[i]->area, truth)) {
      ++tally.falsely;
      if (wrong != nullptr) *wrong += fmt::format("false {} ", name);
    }
  }
  return tally;
}

/// What one world brings home.
struct WorldResult {
  Tally ours, mser;
  std::vector<Frame> kept;         // the first picture, then those that went wrong
  std::vector<std::string> notes;  // what went wrong with each
};

nlohmann::json to_json(const Tally& tally) {
  return {tally.there[0],     tally.there[1],     tally.found[0], tally.found[1],
          tally.there_moving, tally.found_moving, tally.falsely};
}

Tally tally_from(const nlohmann::json& values) {
  Tally tally;
  const auto at = [&](std::size_t i) { return values.at(i).get<std::int64_t>(); };
  tally.there = {at(0), at(1)};
  tally.found = {at(2), at(3)};
  tally.there_moving = at(4);
  tally.found_moving = at(5);
  tally.falsely = at(6);
  return tally;
}

std::string to_bytes(const WorldResult& result) {
  const nlohmann::json head = {{"ours", to_json(result.ours)},
                               {"mser", to_json(result.mser)},
                               {"width", result.kept.front().size.width},
                               {"height", result.kept.front().size.height},
                               {"notes", result.notes}};
  std::string bytes = head.dump() + '\n';
  for (const Frame& frame : result.kept) bytes.append(frame.rgb.begin(), frame.rgb.end());
  return bytes;
}

WorldResult result_from(const std::string& bytes) {
  const std::size_t line = bytes.find('\n');
  const auto head = nlohmann::json::parse(bytes.substr(0, line));
  WorldResult result;
  result.ours = tally_from(head.at("ours"));
  result.mser = tally_from(head.at("mser"));
  result.notes = head.at("notes").get<std::vector<std::string>>();
  const ImageSize size{.width = head.at("width"), .height = head.at("height")};
  const std::size_t length =
      std::size_t{3} * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  for (std::size_t i = 0; i < result.notes.size(); ++i) {
    const auto* const first =
        reinterpret_cast<const std::uint8_t*>(bytes.data()) + line + 1 + i * length;
    Frame& frame = result.kept.emplace_back();
    frame.size = size;
    frame.rgb.assign(first, first + length);
  }
  return result;
}

/// Pictures of world `index`, each kind of room in its turn.
WorldResult look_about(const StudyContext& context, std::uint32_t index) {
  sim::SimCarConfig config = context.scenario.simulated;
  config.world.layout = "balloons";
  config.world.lead = false;
  const std::vector<std::string>& kinds = sim::room_kinds();
  config.world.room.kinds = {kinds[index % kinds.size()]};
  exemplar::BalloonFinder finder(context.scenario.exemplar.percept);
  MserBalloons mser;
  WorldResult result;
  int number = 0;
  take_balloon_pictures(
      config, kPictures, Random(context.scenario.seed).fork("blobs", index),
      [&](const BalloonPicture& picture) {
        const exemplar::Balloons& balloons = finder.find(picture.frame);
        std::string wrong;
        result.ours.add(score(picture, {seen(balloons.red), seen(balloons.green)}, &wrong));
        const bool first = number++ == 0;
        if (first) result.mser.add(score(picture, mser.find(picture.frame), nullptr));
        if (first || !wrong.empty()) {
          result.kept.push_back(picture.frame);
          result.notes.push_back(wrong.empty() ? "" : picture.room + ": " + wrong);
        }
      });
  return result;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// Milliseconds of `work` on one core, the middle one of all `frames`.
template <class Work>
double median_ms(const std::vector<Frame>& frames, std::size_t count, const Work& work) {
  const OneCore core;
  std::vector<double> taken;
  work(frames.front());  // what is made once
  for (std::size_t i = 0; i < std::min(count, frames.size()); ++i) {
    const auto start = std::chrono::steady_clock::now();
    work(frames[i]);
    const std::chrono::duration<double, std::milli> ms = std::chrono::steady_clock::now() - start;
    taken.push_back(ms.count());
  }
  return median(std::move(taken));
}

double share(std::int64_t part, std::int64_t whole) {
  return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

/// All worlds together.
struct Findings {
  Tally ours, mser;
  std::vector<Frame> first;          // one of each world
  std::vector<report::Tiled> wrong;  // with what was wrong
  double ms = 0.0, mser_ms = 0.0;
};

Findings look(const StudyContext& context) {
  Findings findings;
  std::vector<std::uint32_t> worlds(kWorlds);
  std::iota(worlds.begin(), worlds.end(), 0U);
  std::uint64_t done = 0;
  const bool whole = run_in_workers(
      context.control.jobs, worlds,
      [&](std::uint32_t index) { return to_bytes(look_about(context, index)); },
      [&](std::uint32_t, const std::string& bytes) {
        WorldResult result = result_from(bytes);
        findings.ours.add(result.ours);
        findings.mser.add(result.mser);
        for (std::size_t i = 0; i < result.kept.size(); ++i) {
          if (!result.notes[i].empty()) {
            findings.wrong.push_back({.frame = result.kept[i], .caption = result.notes[i]});
          }
        }
        findings.first.push_back(std::move(result.kept.front()));
        done += kPictures;
      },
      context.control.stop,
      [&] { context.control.progress(done, kWorlds * kPictures, "pictures looked at"); });
  if (!whole) throw StudyStopped();
  exemplar::BalloonFinder finder(context.scenario.exemplar.percept);
  findings.ms =
      median_ms(findings.first, kTimed, [&](const Frame& frame) { (void)finder.find(frame); });
  MserBalloons mser;
  findings.mser_ms =
      median_ms(findings.first, kTimedMser, [&](const Frame& frame) { (void)mser.find(frame); });
  return findings;
}

report::Table table_of(const Findings& findings) {
  report::Table table;
  table.columns = {{.heading = "finder"},
                   {.heading = "pictures"},
                   {.heading = "balloons of 30 px or more"},
                   {.heading = "found within 2 px",
                    .unit = "%",
                    .decimals = 1,
                    .scale = 100.0,
                    .better = report::Better::kHigher},
                   {.heading = "false balloons", .better = report::Better::kLower},
                   {.heading = "time, median", .unit = "ms", .better = report::Better::kLower}};
  const auto row = [](const char* name, std::int64_t pictures, const Tally& tally, double ms) {
    return report::Row{.cells = {name, pictures, tally.all_there(),
                                 share(tally.all_found(), tally.all_there()), tally.falsely, ms}};
  };
  table.rows = {
      row("blobs, colour table, shape", kWorlds * kPictures, findings.ours, findings.ms),
      row("OpenCV's MSER on colour, same table", kWorlds, findings.mser, findings.mser_ms)};
  return table;
}

void show(const Findings& findings, exemplar::BalloonFinder& finder, report::Page& page) {
  constexpr std::size_t kExamples = 9;
  constexpr std::size_t kMostWrong = 48;
  std::vector<report::Tiled> examples;
  for (std::size_t i = 0; i < findings.first.size() && examples.size() < 3 * kExamples; ++i) {
    const exemplar::Balloons& seen = finder.find(findings.first[i]);
    if (seen.red && seen.green) add_stages(findings.first[i], "", finder, examples);
  }
  page.section("Figure 5.10: frame, blobs, percept")
      .figure({.bytes = report::encode_png(report::contact_sheet(examples, 3)),
               .caption = "What the camera sends; its blobs in their mean colours, what is of no "
                          "blob in black; the percept, drawn from its numbers alone."});
  report::Content& wrong = page.section("What went wrong");
  wrong.paragraph(fmt::format("{} pictures in which a balloon was missed or a thing named one.",
                              findings.wrong.size()));
  if (findings.wrong.empty()) return;
  std::vector<report::Tiled> tiles;
  for (std::size_t i = 0; i < std::min(kMostWrong, findings.wrong.size()); ++i) {
    add_stages(findings.wrong[i].frame, findings.wrong[i].caption, finder, tiles);
  }
  wrong.figure({.bytes = report::encode_png(report::contact_sheet(tiles, 3)), .caption = {}});
}

}  // namespace

/// Figure 5.10, measured: what is found of the balloons in 1,000 pictures with exact truth.
StudyResult study_blobs(const StudyContext& context, report::Page& page) {
  const Findings findings = look(context);
  const Tally& ours = findings.ours;
  StudyResult result;
  const double found = share(ours.all_found(), ours.all_there());
  const std::int64_t still = ours.all_there() - ours.there_moving;
  result.figures = {{"frames", kWorlds * kPictures},
                    {"balloons", ours.all_there()},
                    {"found", found},
                    {"found_red", share(ours.found[0], ours.there[0])},
                    {"found_green", share(ours.found[1], ours.there[1])},
                    {"found_at_rest", share(ours.all_found() - ours.found_moving, still)},
                    {"found_moving", share(ours.found_moving, ours.there_moving)},
                    {"false_balloons", ours.falsely},
                    {"median_ms", findings.ms},
                    {"mser",
                     {{"frames", kWorlds},
                      {"balloons", findings.mser.all_there()},
                      {"found", share(findings.mser.all_found(), findings.mser.all_there())},
                      {"false_balloons", findings.mser.falsely},
                      {"median_ms", findings.mser_ms}}}};
  result.claims = {
      at_least("found",
               "each balloon of 30 visible pixels or more, within 2 px, without "
               "interference (a balloon each counts)",
               found, 0.99),
      at_most("false_balloons", "nothing else is named, with interference or without",
              static_cast<double>(ours.falsely), 0.0),
      at_most("median_ms", "a picture of 320 x 240 to its percept on one core", findings.ms, 3.0)};
  page.section("Beside OpenCV").table(table_of(findings));
  exemplar::BalloonFinder finder(context.scenario.exemplar.percept);
  show(findings, finder, page);
  return result;
}

}  // namespace pacer
