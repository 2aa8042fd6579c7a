// SPDX-License-Identifier: Apache-2.0
#include "runs/hierarchy_picture.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "learning/exemplar/percept.h"
#include "runs/report/canvas.h"

namespace pacer {
namespace {

using exemplar::ActionTree;
using exemplar::Hierarchy;
using exemplar::NodeId;
namespace canvas = report::canvas;

constexpr int kWidth = 1280;
constexpr int kMargin = 44;   // room for the numbers of the axes
constexpr int kPlot = 400;    // height of the actions
constexpr int kCaption = 18;  // from their axis to the middle of the percepts' caption
constexpr int kLevels = 4;    // of nodes, the root's included
constexpr int kArrows = 34;   // height of a node's strip of actions
constexpr int kGap = 10;
const cv::Scalar kRed(232, 72, 72);
const cv::Scalar kGreen(72, 190, 96);
const cv::Scalar kLine(84, 94, 110);
const cv::Scalar kAxisLine(150, 160, 176);
const std::array<cv::Scalar, 3> kGroups = {cv::Scalar(88, 166, 255), cv::Scalar(255, 159, 28),
                                           cv::Scalar(188, 140, 255)};

/// A place or a length as whole pixels. Models are read from files, and can hold any numbers:
/// beyond what a picture can be wide, it is so far outside.
int pixels(double value) {
  constexpr double kFar = 16384.0;
  return std::isnan(value) ? 0 : static_cast<int>(std::lround(std::clamp(value, -kFar, kFar)));
}

/// Turn and drive as a place on a plot: left is left, and ahead is up.
class ActionPlot {
 public:
  /// Wide enough for all actions, and for the models of `groups` to two standard deviations.
  ActionPlot(const Hierarchy& hierarchy, const std::vector<NodeId>& groups, const cv::Rect& place)
      : place_(place) {
    double least = 1.0;
    double most = 0.05;
    const auto reach = [&](double turn, double low, double high) {
      most_turn_ = std::clamp(turn, most_turn_, 2.0);
      least = std::min(least, low);
      most = std::max(most, high);
    };
    for (std::size_t n = 0; n < hierarchy.exemplars().size(); ++n) {
      const auto action = hierarchy.exemplars().action(n);
      reach(std::abs(action[0]), action[1], action[1]);
    }
    for (const NodeId group : groups) {
      if (!hierarchy.has_model(group)) continue;
      const exemplar::Gaussian model = hierarchy.action_model(group);
      const double turn = 2.0 * std::sqrt(model.covariance(0, 0));
      const double drive = 2.0 * std::sqrt(model.covariance(1, 1));
      reach(std::abs(model.mean[0]) + turn, model.mean[1] - drive, model.mean[1] + drive);
    }
    const double rim = std::max(0.05 * (most - least), 0.01);
    least_drive_ = std::clamp(least - rim, -1.0, 0.9);
    most_drive_ = std::clamp(most + rim, least_drive_ + 0.02, 2.0);
  }
  [[nodiscard]] cv::Point at(double turn, double drive) const {
    const double up = (drive - least_drive_) / (most_drive_ - least_drive_);
    return {pixels(place_.x + 0.5 * (1.0 - turn / most_turn_) * place_.width),
            pixels(place_.y + (1.0 - up) * place_.height)};
  }
  [[nodiscard]] double most_turn() const { return most_turn_; }
  [[nodiscard]] double least_drive() const { return least_drive_; }
  [[nodiscard]] double most_drive() const { return most_drive_; }

 private:
  cv::Rect place_;
  double most_turn_ = 1.05;
  double least_drive_ = 0.0;
  double most_drive_ = 1.0;
};

struct Bounds {
  std::array<double, 2> low, high;
};

/// The cuts of `node`'s cell and of those below.
void draw_cuts(cv::Mat& image, const ActionPlot& plot, const ActionTree& tree, NodeId node,
               const Bounds& cell) {
  const ActionTree::Node& one = tree.nodes()[node];
  if (one.leaf()) return;
  Bounds low = cell;
  Bounds high = cell;
  low.high[one.axis] = high.low[one.axis] = one.cut;
  const cv::Point from = plot.at(high.low[0], high.low[1]);
  const cv::Point to =
      one.axis == 0 ? plot.at(one.cut, cell.high[1]) : plot.at(cell.high[0], one.cut);
  cv::line(image, from, to, kLine, 1, cv::LINE_AA);
  draw_cuts(image, plot, tree, one.left, low);
  draw_cuts(image, plot, tree, one.right, high);
}

/// The three largest groups that cutting the largest one again and again leaves.
std::vector<NodeId> three_groups(const ActionTree& tree) {
  std::vector<NodeId> groups = {0};
  const auto count = [&](NodeId node) {
    const ActionTree::Node& one = tree.nodes()[node];
    return one.leaf() ? 0U : one.count;
  };
  while (groups.size() < kGroups.size()) {
    const auto largest = std::ranges::max_element(groups, {}, count);
    const ActionTree::Node& one = tree.nodes()[*largest];
    if (one.leaf()) break;
    *largest = one.left;
    groups.push_back(one.right);
  }
  return groups;
}

/// Two standard deviations about an action model.
void draw_model(cv::Mat& image, const ActionPlot& plot, const exemplar::Gaussian& model,
                const cv::Scalar& colour) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(Eigen::Matrix2d(model.covariance));
  std::vector<cv::Point> outline;
  constexpr int kPoints = 72;
  for (int i = 0; i < kPoints; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kPoints;
    const Eigen::Vector2d side = axes.eigenvalues().cwiseMax(0.0).cwiseSqrt().cwiseProduct(
        Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    const Eigen::Vector2d point = model.mean.head<2>() + 2.0 * (axes.eigenvectors() * side);
    outline.push_back(plot.at(point.x(), point.y()));
  }
  cv::polylines(image, outline, true, colour, 2, cv::LINE_AA);
}

/// Numbers along both axes, and the line between left and right.
void draw_axes(cv::Mat& image, const ActionPlot& plot, const cv::Rect& place) {
  const cv::Point middle = plot.at(0.0, plot.least_drive());
  cv::line(image, {middle.x, place.y}, {middle.x, place.y + place.height}, kAxisLine, 1);
  for (const double turn : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
    const cv::Point at = plot.at(turn, plot.least_drive());
    cv::line(image, {at.x, place.y + place.height}, {at.x, place.y + place.height + 4}, kAxisLine);
    canvas::text(image, fmt::format("{:+.1f}", turn), {at.x - 12, place.y + place.height + 16},
                 {.height_px = 8});
  }
  constexpr int kTicks = 5;
  const double range = plot.most_drive() - plot.least_drive();
  for (int i = 0; i < kTicks; ++i) {
    const double drive = plot.least_drive() + range * (i + 0.5) / kTicks;
    const cv::Point at = plot.at(0.0, drive);
    cv::line(image, {place.x - 4, at.y}, {place.x, at.y}, kAxisLine);
    canvas::text(image, fmt::format("{:.2f}", drive), {place.x - 36, at.y + 4}, {.height_px = 8});
  }
}

void draw_actions(cv::Mat& image, const Hierarchy& hierarchy, const std::vector<NodeId>& groups) {
  constexpr int kAxis = 22;
  const cv::Rect place(kMargin, kMargin + 24, kWidth - 2 * kMargin, kPlot - kAxis - 24);
  const ActionPlot plot(hierarchy, groups, place);
  canvas::text(
      image,
      "actions: turn (left is left, 1 is full stick) and drive (up is ahead); lines: where "
      "the tree cuts them",
      {kMargin, 20}, {.height_px = 11});
  int x = kMargin;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const std::string entry =
        fmt::format("group {}: {} of {}", g + 1, hierarchy.tree().nodes()[groups[g]].count,
                    hierarchy.exemplars().size());
    cv::circle(image, {x + 5, 40}, 5, kGroups[g], cv::FILLED, cv::LINE_AA);
    x += 34 + canvas::text(image, entry, {x + 16, 45}, {.height_px = 10});
  }
  canvas::text(image, "dots: its actions; ellipse: two standard deviations; below, its frame",
               {x, 45}, {.height_px = 10, .most_width_px = kWidth - kMargin - x});
  draw_cuts(image, plot, hierarchy.tree(), 0,
            {.low = {-plot.most_turn(), plot.least_drive()},
             .high = {plot.most_turn(), plot.most_drive()}});
  draw_axes(image, plot, place);
  cv::rectangle(image, place, kLine, 1);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    for (const std::uint32_t n : hierarchy.tree().exemplars_of(groups[g])) {
      const auto action = hierarchy.exemplars().action(n);
      cv::circle(image, plot.at(action[0], action[1]), 3, kGroups[g], cv::FILLED, cv::LINE_AA);
    }
    if (hierarchy.has_model(groups[g])) {
      draw_model(image, plot, hierarchy.action_model(groups[g]), kGroups[g]);
    }
  }
}

/// The colour of the group that `node` is; null where it is none.
const cv::Scalar* colour_of(const std::vector<NodeId>& groups, NodeId node) {
  const auto found = std::ranges::find(groups, node);
  if (found == groups.end()) return nullptr;
  return &kGroups.at(static_cast<std::size_t>(found - groups.begin()));
}

/// What one node has seen, its exemplars' balloons, each as its ellipse, and its actions.
void draw_node(cv::Mat image, const Hierarchy& hierarchy, NodeId node, double scale) {
  constexpr std::size_t kMost = 120;  // exemplars drawn
  const std::span<const std::uint32_t> members = hierarchy.tree().exemplars_of(node);
  const std::size_t step = (members.size() + kMost - 1) / kMost;
  cv::Mat view = image.rowRange(0, image.rows - kArrows);
  view.setTo(cv::Scalar(30, 36, 45));
  const std::size_t drawn = (members.size() + step - 1) / step;
  const double alpha = std::max(0.06, 0.9 / std::sqrt(static_cast<double>(drawn)));
  cv::Mat layer;
  const cv::Point foot(image.cols / 2, image.rows - 6);
  for (std::size_t i = 0; i < members.size(); i += step) {
    exemplar::Percept percept{};
    std::ranges::copy(hierarchy.exemplars().percept(members[i]), percept.begin());
    const exemplar::Balloons balloons = exemplar::balloons(percept);
    view.copyTo(layer);
    for (const auto& [blob, colour] : {std::pair(&balloons.green, kGreen), {&balloons.red, kRed}}) {
      if (!*blob) continue;
      const exemplar::Ellipse shape = exemplar::ellipse(**blob);
      cv::ellipse(
          layer,
          cv::Point(pixels(scale * (*blob)->centroid.x()), pixels(scale * (*blob)->centroid.y())),
          cv::Size(std::max(2, pixels(scale * shape.major)),
                   std::max(2, pixels(scale * shape.minor))),
          shape.angle * 180.0 / std::numbers::pi, 0.0, 360.0, colour, cv::FILLED, cv::LINE_AA);
    }
    cv::addWeighted(layer, alpha, view, 1.0 - alpha, 0.0, view);
    const auto action = hierarchy.exemplars().action(members[i]);
    const double angle = action[0] * std::numbers::pi / 3.0;
    const double length = (kArrows - 8) * std::clamp(2.0 * action[1], 0.3, 1.0);
    cv::line(image, foot,
             foot - cv::Point(pixels(length * std::sin(angle)), pixels(length * std::cos(angle))),
             canvas::kInk, 1, cv::LINE_AA);
  }
  canvas::text(image, fmt::format("{}", members.size()), {4, image.rows - 6}, {.height_px = 9});
  cv::rectangle(image, {0, 0, image.cols, image.rows}, kLine, 1);
}

}  // namespace

Frame draw_hierarchy(const exemplar::Model& model) {
  const Hierarchy& hierarchy = model.hierarchy;
  constexpr int kColumns = 1 << (kLevels - 1);
  constexpr int kNodeWidth = (kWidth - 2 * kMargin - (kColumns - 1) * kGap) / kColumns;
  const double scale = static_cast<double>(kNodeWidth) / model.image_size.width;
  const int node_height = pixels(scale * model.image_size.height) + kArrows;
  constexpr int kBetween = 26;
  Frame frame;
  cv::Mat image = canvas::resized(
      frame, {.width = kWidth,
              .height = kPlot + kMargin + kCaption + 16 + kLevels * (node_height + kBetween)});
  image.setTo(canvas::kBackground);
  const std::vector<NodeId> groups = three_groups(hierarchy.tree());
  draw_actions(image, hierarchy, groups);
  canvas::text(
      image,
      fmt::format("percepts: the balloons that each node's exemplars saw; their number, and "
                  "what was done; levels 0 to {} of {}",
                  std::min(kLevels - 1, hierarchy.tree().depth()), hierarchy.tree().depth()),
      {kMargin, kPlot + kMargin + kCaption},
      {.height_px = 11, .most_width_px = kWidth - 2 * kMargin});

  std::vector<NodeId> level = {0};
  for (int depth = 0; depth < kLevels; ++depth) {
    const int y = kPlot + kMargin + kCaption + 16 + depth * (node_height + kBetween);
    const auto middle = [&](std::size_t i, int levels_down) {
      const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(1 << levels_down);
      return kMargin + static_cast<int>(share * (kWidth - 2 * kMargin));
    };
    std::vector<NodeId> next;
    for (std::size_t i = 0; i < level.size(); ++i) {
      const bool there = level[i] != exemplar::kNoNode;
      const ActionTree::Node* const node = there ? &hierarchy.tree().nodes()[level[i]] : nullptr;
      // Left in the picture is the turn to the left, which is the greater one.
      const bool inner = there && !node->leaf();
      const bool turned = inner && node->axis == 0;
      next.push_back(inner ? (turned ? node->right : node->left) : exemplar::kNoNode);
      next.push_back(inner ? (turned ? node->left : node->right) : exemplar::kNoNode);
      if (!there) continue;
      const int x = middle(i, depth);
      if (depth + 1 < kLevels && inner) {
        for (const std::size_t child : {2 * i, 2 * i + 1}) {
          cv::line(image, {x, y + node_height},
                   {middle(child, depth + 1), y + node_height + kBetween}, kLine, 1, cv::LINE_AA);
        }
      }
      const cv::Rect frame_of_node(x - kNodeWidth / 2, y, kNodeWidth, node_height);
      draw_node(image(frame_of_node), hierarchy, level[i], scale);
      if (const cv::Scalar* colour = colour_of(groups, level[i])) {
        cv::rectangle(image, frame_of_node, *colour, 2);
      }
    }
    level = std::move(next);
  }
  return frame;
}

}  // namespace pacer
