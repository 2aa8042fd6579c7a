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
#include "learning/affordance/kmeans.h"
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
constexpr std::size_t kImages = 6;  // two a class

/// The exemplars of three groups of similar actions, from left to right.
std::array<std::vector<std::size_t>, kClasses> classes_of(const Exemplars& exemplars,
                                                          const Random& random) {
  std::vector<float> actions;
  for (const double value : exemplars.actions()) actions.push_back(static_cast<float>(value));
  constexpr int kRestarts = 10;
  const affordance::KMeansResult means = affordance::kmeans(
      actions, 2, {.clusters = static_cast<int>(kClasses), .restarts = kRestarts}, random);
  std::array<std::size_t, kClasses> by_turn = {0, 1, 2};
  std::ranges::sort(by_turn, std::greater{}, [&](std::size_t c) { return means.centres[2 * c]; });
  std::array<std::vector<std::size_t>, kClasses> members;
  for (std::size_t n = 0; n < exemplars.size(); ++n) {
    const auto distance = [&](std::size_t c) {
      const float turn = actions[2 * n] - means.centres[2 * c];
      const float drive = actions[2 * n + 1] - means.centres[2 * c + 1];
      return turn * turn + drive * drive;
    };
    members[static_cast<std::size_t>(std::ranges::min_element(by_turn, {}, distance) -
                                     by_turn.begin())]
        .push_back(n);
  }
  return members;
}

/// An unseen picture with both balloons in it.
struct TestImage {
  Frame frame;
  Percept percept{};
  exemplar::Balloons balloons;
};

/// Of unseen drives: for each third of the picture that the red balloon is in, the two with the
/// green one farthest to the left and to the right.
std::vector<TestImage> test_images(const StudyContext& context) {
  constexpr std::uint64_t kDrives = 30;
  const dataset::RecordedDemonstration drives(
      Materials(context).recording(Purpose::kStudy, kDrives));
  const double width = drives.image_size().width;
  std::array<std::optional<TestImage>, kImages> chosen;
  exemplar::BalloonFinder finder(context.scenario.exemplar.percept);
  for (std::size_t episode = 0; episode < drives.episode_count(); ++episode) {
    if (context.control.stop.stop_requested()) throw StudyStopped();
    ImpulseStream impulses(drives.open(episode));
    while (const ImpulseExemplar* impulse = impulses.next()) {
      const exemplar::Balloons& seen = finder.find(*impulse->frame);
      if (!seen.red || !seen.green || !finder.whole()) continue;
      // Well inside its third, so that there is one thing to do about it.
      const double red = seen.red->centroid.x() / width;
      const std::size_t third = red < 0.25 ? 0 : red > 0.75 ? 2 : 1;
      if (third == 1 && std::abs(red - 0.5) > 0.08) continue;
      const double green = seen.green->centroid.x();
      for (const std::size_t image : {2 * third, 2 * third + 1}) {
        const bool leftmost = image % 2 == 0;
        const auto better = [&](const TestImage& old) {
          const double other = old.balloons.green->centroid.x();
          return leftmost ? green < other : green > other;
        };
        if (chosen[image] && !better(*chosen[image])) continue;
        chosen[image] = {
            .frame = *impulse->frame, .percept = exemplar::percept(seen), .balloons = seen};
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

/// How many of the ordered pairs of Figure 5.12 are as there: each class is nearer to either of its
/// own images than to any other image.
double share_ordered(const std::array<std::array<double, kImages>, kClasses>& distances) {
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

void add_page(const std::vector<TestImage>& images,
              const std::array<std::array<double, kImages>, kClasses>& distances,
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
          "Three groups of similar actions, and the Gaussian of each one's percepts. The red "
          "balloon is to the left in images 1 and 2, in the middle in 3 and 4, to the right in 5 "
          "and 6; the green one is as far to the left as there is a picture of in the odd ones, as "
          "far to the right in the even ones. Each class should be near to its own two images, "
          "wherever the green balloon is.")
      .gallery(figures)
      .chart({.spec = report::bar_chart(bars, {.title = "Mahalanobis distance (5.5)"},
                                        report::Palette(names), {.height_px = 300}),
              .caption = "Unseen pictures, from drives in a room that nobody demonstrated in."});
}

}  // namespace

/// Figure 5.12: grouped by their actions, percepts are matched by what decides the action.
StudyResult study_perceptual_weighting(const StudyContext& context, report::Page& page) {
  const Exemplars exemplars = chapter5::demonstrated(context).exemplars;
  const exemplar::HierarchyConfig& config = context.scenario.exemplar.hierarchy;
  const exemplar::Hierarchy hierarchy(exemplars, config);
  const auto classes =
      classes_of(exemplars, Random(context.scenario.seed).fork("perceptual-weighting"));
  const std::vector<TestImage> images = test_images(context);

  std::array<std::array<double, kImages>, kClasses> distances{};
  nlohmann::ordered_json measured = nlohmann::ordered_json::object();
  for (std::size_t c = 0; c < kClasses; ++c) {
    // The root of a hierarchy over the group, with the prior of the whole.
    const exemplar::Hierarchy group(exemplars.subset(classes[c]), config, hierarchy.prior());
    const exemplar::Gaussian model = group.percept_model(0);
    for (std::size_t i = 0; i < kImages; ++i) {
      distances[c][i] = model.distance(
          Eigen::Map<const Eigen::VectorXd>(images[i].percept.data(), exemplar::kPerceptSize));
      measured[kNames[c]].push_back(distances[c][i]);
    }
  }
  const double ordered = share_ordered(distances);
  int nearest = 0;
  for (std::size_t i = 0; i < kImages; ++i) {
    std::size_t best = 0;
    for (std::size_t c = 1; c < kClasses; ++c) {
      if (distances[c][i] < distances[best][i]) best = c;
    }
    nearest += best == i / 2 ? 1 : 0;
  }

  StudyResult result;
  result.figures = {{"ordered", ordered},
                    {"images_nearest_their_class", nearest},
                    {"distances", measured},
                    {"class_sizes", {classes[0].size(), classes[1].size(), classes[2].size()}}};
  result.claims = {at_least("ordered",
                            "5.12: every class is nearer to its own two images than to the others",
                            ordered, 1.0)};
  add_page(images, distances, page);
  return result;
}

}  // namespace pacer
