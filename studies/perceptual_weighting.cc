// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "core/impulse.h"
#include "dataset/demonstration.h"
#include "learning/exemplar/percept.h"
#include "runs/report/charts.h"
#include "runs/report/draw.h"
#include "runs/report/picture.h"
#include "studies/chapter5.h"
#include "studies/materials.h"
#include "studies/studies.h"

namespace pacer {
namespace {

using exemplar::Exemplars;
using exemplar::Percept;

constexpr std::size_t kClasses = 3;
constexpr std::array<const char*, kClasses> kNames = {"turn left", "straight ahead", "turn right"};
constexpr std::size_t kImages = 6;     // two a class
constexpr std::uint64_t kTaught = 80;  // demonstrations, with either side searched
constexpr std::uint64_t kUnseen = 20;  // drives that the images are of, with either side searched

/// The same task, taught by one who looks for the balloon towards `side`. Both sides make as many
/// turns to the right as to the left, as Figure 5.11 has them.
StudyContext searching(const StudyContext& context, const char* side) {
  StudyContext searching = context;
  searching.scenario.click_teacher.search = side;
  return searching;
}

/// Of drives that were taught by either.
Exemplars taught(const StudyContext& context) {
  Exemplars all = chapter5::demonstrated(searching(context, "left"), kTaught).exemplars;
  const Exemplars more = chapter5::demonstrated(searching(context, "right"), kTaught).exemplars;
  for (std::size_t n = 0; n < more.size(); ++n) all.add(more.percept(n), more.action(n));
  return all;
}

/// Figure 5.11's three subsets of the actions, from left to right: clear turns, and nearly none. Of
/// exemplars that show both balloons, as the thesis's all do.
using Classes = std::array<std::vector<std::size_t>, kClasses>;

Classes classes_of(const Exemplars& exemplars) {
  constexpr double kTurn = 0.4;   // stick, at least
  constexpr double kAhead = 0.1;  // at most
  const auto seen = [](std::span<const double> balloon) {
    return std::ranges::any_of(balloon, [](double value) { return value != 0.0; });
  };
  Classes members;
  for (std::size_t n = 0; n < exemplars.size(); ++n) {
    const auto percept = exemplars.percept(n);
    if (!seen(percept.first(exemplar::kBalloonValues)) ||
        !seen(percept.last(exemplar::kBalloonValues))) {
      continue;
    }
    const double turn = exemplars.action(n)[0];
    if (std::abs(turn) <= kAhead) members[1].push_back(n);
    if (std::abs(turn) >= kTurn) members[turn > 0.0 ? 0 : 2].push_back(n);
  }
  return members;
}

/// An unseen picture with both balloons in it.
struct TestImage {
  Frame frame;
  Percept percept{};
  exemplar::Balloons balloons;
};

/// How unusual both balloons look: 0 is the median size of either, whole.
double unusual(const exemplar::Balloons& seen, const std::array<double, 2>& usual_areas) {
  constexpr double kCut = 100.0;  // more than any size
  const auto cut = [](const exemplar::Blob& blob) {
    return blob.cut != exemplar::Sides{} ? kCut : 0.0;
  };
  return cut(*seen.red) + cut(*seen.green) + std::abs(std::log(seen.red->area / usual_areas[0])) +
         std::abs(std::log(seen.green->area / usual_areas[1]));
}

/// Of unseen drives: for each third of the picture that the red balloon is in, the two with
/// balloons of the most usual size, whole where there are any, the green one in the left half and
/// in the right half.
std::vector<TestImage> test_images(const StudyContext& context,
                                   const std::array<double, 2>& usual_areas) {
  std::array<std::optional<TestImage>, kImages> chosen;
  exemplar::BalloonFinder finder(exemplar::of_videos(context.scenario.exemplar.percept));
  for (const char* side : {"left", "right"}) {
    const StudyContext one = searching(context, side);
    const dataset::RecordedDemonstration drives(Materials(one).recording(Purpose::kStudy, kUnseen));
    const double width = drives.image_size().width;
    for (std::size_t episode = 0; episode < drives.episode_count(); ++episode) {
      if (context.control.stop.stop_requested()) throw StudyStopped();
      ImpulseStream impulses(drives.open(episode));
      while (const ImpulseExemplar* impulse = impulses.next()) {
        const exemplar::Balloons& seen = finder.find(*impulse->frame);
        if (!seen.red || !seen.green || !finder.whole()) continue;
        // Well inside its third, so that there is one thing to do about it.
        const double aside = seen.red->centroid.x() / width - 0.5;
        const std::size_t third = aside < -0.12 ? 0 : aside > 0.12 ? 2 : 1;
        if (third == 1 && std::abs(aside) > 0.05) continue;
        const bool right = seen.green->centroid.x() > 0.5 * width;
        std::optional<TestImage>& image = chosen[2 * third + (right ? 1 : 0)];
        if (image && unusual(image->balloons, usual_areas) <= unusual(seen, usual_areas)) continue;
        image = {.frame = *impulse->frame, .percept = exemplar::percept(seen), .balloons = seen};
      }
    }
  }
  std::vector<TestImage> images;
  for (std::optional<TestImage>& image : chosen) {
    if (!image)
      throw std::runtime_error("perceptual-weighting: too few pictures with both balloons");
    images.push_back(std::move(*image));
  }
  return images;
}

using Distances = std::array<std::array<double, kImages>, kClasses>;

/// How many of the ordered pairs of Figure 5.12 are as there: each class is nearer to either of its
/// own images than to any other image.
double share_ordered(const Distances& distances) {
  int held = 0;
  int pairs = 0;
  for (std::size_t c = 0; c < kClasses; ++c) {
    for (const std::size_t own : {2 * c, 2 * c + 1}) {
      for (std::size_t other = 0; other < kImages; ++other) {
        if (other / 2 == c) continue;
        ++pairs;
        held += distances[c][own] < distances[c][other] ? 1 : 0;
      }
    }
  }
  return static_cast<double>(held) / pairs;
}

void add_page(const std::vector<TestImage>& images, const Distances& distances,
              report::Page& page) {
  std::vector<std::vector<std::uint8_t>> bytes;
  std::vector<report::Figure> figures;
  for (const TestImage& image : images) {
    Annotations marks;
    exemplar::mark(image.balloons, marks);
    Frame drawn;
    report::draw(image.frame, marks, drawn, 1);
    bytes.push_back(report::encode_jpeg(drawn));
  }
  for (std::size_t i = 0; i < kImages; ++i) {
    figures.push_back({.bytes = bytes[i], .caption = fmt::format("image {}", i + 1)});
  }
  std::vector<report::Bar> bars;
  for (std::size_t c = 0; c < kClasses; ++c) {
    for (std::size_t i = 0; i < kImages; ++i) {
      const double value = distances[c][i];
      bars.push_back({.group = kNames[c],
                      .series = fmt::format("image {}", i + 1),
                      .value = {.value = value, .low = value, .high = value}});
    }
  }
  std::vector<std::string> names;
  for (std::size_t i = 0; i < kImages; ++i) names.push_back(fmt::format("image {}", i + 1));
  page.section("Perceptual weighting (Figure 5.12)")
      .paragraph(
          "Three groups of similar actions, clear turns to the left, next to none and clear turns "
          "to "
          "the right, of exemplars that show both balloons, and the Gaussian of each one's "
          "percepts. "
          "The red balloon is to the left in images 1 and 2, in the middle "
          "in 3 and 4, to the right in 5 and 6; the green one is in the left half in the odd ones, "
          "in the right half in the even ones. Each class should be near to its own two images, "
          "wherever the green balloon is.")
      .gallery(figures)
      .chart({.spec = report::bar_chart(bars, {.title = "Mahalanobis distance (5.5)"},
                                        report::Palette(names), {.height_px = 300}),
              .caption = "Unseen pictures, from drives in a room that nobody demonstrated in."});
}

/// The median areas of the red and the green balloon.
std::array<double, 2> usual_areas(const Exemplars& exemplars,
                                  std::span<const std::size_t> members) {
  std::array<double, 2> medians{};
  for (std::size_t balloon = 0; balloon < 2; ++balloon) {
    std::vector<double> areas;
    for (const std::size_t n : members) {
      areas.push_back(exemplars.percept(n)[balloon * exemplar::kBalloonValues]);
    }
    const auto middle = areas.begin() + std::ssize(areas) / 2;
    std::ranges::nth_element(areas, middle);
    medians[balloon] = middle == areas.end() ? 1.0 : *middle;
  }
  return medians;
}

/// (5.5), from the Gaussian of each class's percepts to each image.
Distances measure(const Exemplars& exemplars, const exemplar::HierarchyConfig& config,
                  const std::vector<TestImage>& images) {
  const exemplar::Hierarchy hierarchy(exemplars, config);
  const Classes classes = classes_of(exemplars);
  Distances distances{};
  for (std::size_t c = 0; c < kClasses; ++c) {
    if (classes[c].empty()) throw std::runtime_error("perceptual-weighting: nobody turned so");
    // The root of a hierarchy over the group, with the prior of the whole.
    const exemplar::Hierarchy group(exemplars.subset(classes[c]), config, hierarchy.prior());
    for (std::size_t i = 0; i < kImages; ++i) {
      distances[c][i] = group.distance(0, images[i].percept);
    }
  }
  return distances;
}

/// How many images are nearest to the class that they are of.
int count_nearest(const Distances& distances) {
  int nearest = 0;
  for (std::size_t i = 0; i < kImages; ++i) {
    const auto best = std::ranges::min_element(distances, {}, [&](const auto& d) { return d[i]; });
    nearest += static_cast<std::size_t>(best - distances.begin()) == i / 2 ? 1 : 0;
  }
  return nearest;
}

}  // namespace

/// Figure 5.12: grouped by their actions, percepts are matched by what decides the action.
StudyResult study_perceptual_weighting(const StudyContext& context, report::Page& page) {
  const Exemplars exemplars = taught(context);
  const Classes classes = classes_of(exemplars);
  const std::vector<TestImage> images = test_images(context, usual_areas(exemplars, classes[1]));
  const exemplar::HierarchyConfig& config = context.scenario.exemplar.hierarchy;
  const Distances distances = measure(exemplars, config, images);

  nlohmann::ordered_json measured = nlohmann::ordered_json::object();
  nlohmann::ordered_json sizes = nlohmann::ordered_json::object();
  for (std::size_t c = 0; c < kClasses; ++c) {
    measured[kNames[c]] = distances[c];
    sizes[kNames[c]] = classes[c].size();
  }
  StudyResult result;
  result.figures = {{"ordered", share_ordered(distances)},
                    {"images_nearest_their_class", count_nearest(distances)},
                    {"distances", measured},
                    {"exemplars", sizes}};
  result.claims = {
      at_least("ordered", "5.12: every class is nearer to its own two images than to the others",
               share_ordered(distances), 1.0),
      at_least("images_nearest_their_class", "5.12: every image is nearest to its own class",
               count_nearest(distances), double{kImages})};
  add_page(images, distances, page);
  return result;
}

}  // namespace pacer
