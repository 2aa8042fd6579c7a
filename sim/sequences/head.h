// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "core/random.h"
#include "sim/shape.h"
#include "sim/texture.h"

namespace pacer::sim {

/// How a person's head looks.
struct HeadLook {
  texture::Colour skin{214, 166, 138};
  texture::Colour hair{58, 40, 30};
  texture::Colour iris{70, 105, 120};
  double hair_depth = 0.012;   ///< metres that it stands off
  double side_hairline = 0.0;  ///< metres above the ears' middle at which it ends beside the face
  bool stubble = false;
};

enum class Expression : std::uint8_t { kNeutral, kBlink, kSmile, kTalk };

/// A head as a surface. Its frame: x ahead (the way the nose points), y left, z up, the origin
/// midway between the ears; metres. On the picture that it wears, s goes once around from behind,
/// the face in the middle, and t from crown to chin.
class Head {
 public:
  explicit Head(const HeadLook& look) : look_(look) {}

  [[nodiscard]] Eigen::Vector3d at(double s, double t, Expression expression) const;
  /// Where the face's point y to the left and z above the ears' middle is in the picture, [0, 1].
  [[nodiscard]] Eigen::Vector2d on_picture(double y, double z) const;
  /// 1 where hair grows, 0 on the face, between within `edge` metres of its line.
  [[nodiscard]] double hair_at(double s, double t, double edge) const;
  [[nodiscard]] const HeadLook& look() const noexcept { return look_; }

  /// Points all over it, hair included.
  [[nodiscard]] std::vector<Eigen::Vector3d> outline() const;
  /// Points all over the face: from the brow to the chin, from cheek to cheek.
  [[nodiscard]] std::vector<Eigen::Vector3d> face_outline() const;

  /// Adds head and ears to `shape`, wearing `skin` and `ear`; the head is made of columns x rows
  /// cells.
  void add_to(Shape& shape, Expression expression, const Skin& skin, const Skin& ear, int columns,
              int rows) const;

 private:
  HeadLook look_;
};

/// The picture of a head: face, hair, everything.
[[nodiscard]] cv::Mat head_print(const Head& head, Expression expression, cv::Size size,
                                 Random random);

}  // namespace pacer::sim
