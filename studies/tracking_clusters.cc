// SPDX-License-Identifier: Apache-2.0
#include "studies/tracking_clusters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <span>

#include "learning/tracking/config.h"
#include "runs/report/picture.h"
#include "studies/drawing.h"

namespace pacer {
namespace {

Frame frame_of(const PatchMark& patch) {
  Frame frame;
  frame.size = patch.size;
  for (const std::uint8_t value : patch.grey) {
    frame.rgb.insert(frame.rgb.end(), {value, value, value});
  }
  return frame;
}

}  // namespace

ClusteredTemplates::ClusteredTemplates(const Box& target, std::size_t pictures)
    : grid_(target.width, target.height, tracking::TrackingConfig().template_pixels),
      clusters_(tracking::TrackingConfig().medoidshift),
      most_(pictures) {
  const auto points = static_cast<std::size_t>(tracking::TrackingConfig().medoidshift.templates);
  templates_.resize(points * grid_.length());
  pictures_.resize(points);
  distances_.resize(points);
}

void ClusteredTemplates::add(const cv::Mat1b& grey, const Box& box) {
  if (seen_ == most_) return;
  const std::size_t length = grid_.length();
  const std::size_t point = clusters_.next();
  const std::span<std::uint8_t> newest(&templates_[point * length], length);
  grid_.extract(grey, {static_cast<int>(std::lround(box.x)), static_cast<int>(std::lround(box.y))},
                newest.data());
  for (std::size_t i = 0; i < clusters_.size(); ++i) {
    distances_[i] = tracking::distance(newest, {&templates_[i * length], length});
  }
  clusters_.add(distances_);
  pictures_[point] = seen_++;
}

std::vector<ClusteredTemplates::Cluster> ClusteredTemplates::largest_first() const {
  std::vector<Cluster> all(clusters_.size());
  for (std::size_t point = 0; point < clusters_.size(); ++point) {
    Cluster& cluster = all[clusters_.modes()[point]];
    cluster.mode = clusters_.modes()[point];
    cluster.points.push_back(point);
  }
  std::erase_if(all, [](const Cluster& cluster) { return cluster.points.empty(); });
  for (Cluster& cluster : all) {
    std::ranges::sort(cluster.points, {}, [this](std::size_t point) { return pictures_[point]; });
  }
  std::ranges::stable_sort(all, std::greater{},
                           [](const Cluster& cluster) { return cluster.points.size(); });
  return all;
}

std::vector<std::uint8_t> ClusteredTemplates::draw(const std::vector<std::size_t>& order) const {
  constexpr int kScale = 2;
  const std::size_t length = grid_.length();
  const auto side = static_cast<int>(order.size());
  cv::Mat1f distances(side, side);
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const std::size_t a = order[static_cast<std::size_t>(row)] * length;
      const std::size_t b = order[static_cast<std::size_t>(column)] * length;
      distances(row, column) = static_cast<float>(
          tracking::distance({&templates_[a], length}, {&templates_[b], length}));
    }
  }
  return Drawing::of_surface(distances, kScale).png();
}

void ClusteredTemplates::add_to(report::Page& page) const {
  constexpr std::size_t kShown = 6;
  if (clusters_.size() < 2) return;
  const std::vector<Cluster> clusters = largest_first();
  std::vector<std::size_t> sorted;
  std::vector<report::Tiled> modes;
  for (const Cluster& cluster : clusters) {
    sorted.insert(sorted.end(), cluster.points.begin(), cluster.points.end());
    if (modes.size() == kShown) continue;
    const std::span<const std::uint8_t> mode(&templates_[cluster.mode * grid_.length()],
                                             grid_.length());
    modes.push_back({.frame = frame_of(grid_.patch(mode, Tone::kNeutral)),
                     .caption = fmt::format("{}: {}-{}", cluster.points.size(),
                                            pictures_[cluster.points.front()] + 1,
                                            pictures_[cluster.points.back()] + 1)});
  }
  std::vector<std::size_t> in_time = sorted;
  std::ranges::sort(in_time, {}, [this](std::size_t point) { return pictures_[point]; });
  const auto before = draw(in_time);
  const auto after = draw(sorted);
  const auto sheet = report::encode_png(
      report::contact_sheet(modes, static_cast<int>(modes.size()), {.width = 150, .height = 180}));
  const std::vector<report::Figure> matrices = {
      {.bytes = before, .caption = "In the order of time"},
      {.bytes = after,
       .caption = fmt::format("Sorted by cluster, of which there are {}", clusters.size())}};
  page.section("Figure 4.5: clusters by medoidshift")
      .paragraph(fmt::format(
          "Distances between the templates of pictures {} to {} of head-motion, about the true "
          "centres, clustered as LP-MED does: dark is alike. Pictures far apart in time share a "
          "cluster where the head "
          "looks the same.",
          pictures_[in_time.front()] + 1, pictures_[in_time.back()] + 1))
      .gallery(matrices)
      .figure({.bytes = sheet,
               .caption = "The modes of the largest clusters: how many templates, and of which "
                          "pictures."});
}

}  // namespace pacer
