// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <functional>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace pacer::sim {

/// A part of an atlas, and how it covers a surface.
struct Skin {
  cv::Rect2f texels;    ///< empty: the surface is not drawn
  float metres = 0.0F;  ///< the skin repeats, mirrored, every so many metres; 0: it is stretched
  [[nodiscard]] bool drawn() const noexcept { return texels.area() > 0.0F; }
  /// The part of it from (left, top) to (right, bottom), each in [0, 1]; stretched.
  [[nodiscard]] Skin part(float left, float top, float right, float bottom) const noexcept;
};

/// Many pictures in one texture, so that a whole piece of furniture is one draw call.
class Atlas {
 public:
  /// `width` of the texture, texels; its height grows with what is added.
  explicit Atlas(int width) : width_(width) {}

  /// Copies `picture` (8-bit RGB) in, with a margin against bleeding into its neighbours when it is
  /// seen small. Throws nothing; a picture wider than the atlas breaks a promise.
  Skin add(const cv::Mat& picture, double metres = 0.0);

  /// Everything that was added, as a material of this name. Nothing may be added afterwards.
  void add_to(mjSpec& spec, const std::string& material);

  [[nodiscard]] cv::Size size() const noexcept { return {width_, std::max(height_, 1)}; }

 private:
  int width_;
  int height_ = 0;   // of the shelves so far
  int shelf_y_ = 0;  // the open shelf: pictures side by side
  int shelf_x_ = 0;
  int shelf_height_ = 0;
  struct Placed {
    cv::Mat picture;  // with its margin
    cv::Point at;
  };
  std::vector<Placed> placed_;
};

/// The skins of a box's sides. Front is +y, right is +x, top is +z. Default: not drawn.
struct BoxSkins {
  Skin front, back, left, right, top, bottom;
  /// The same on every side but the bottom, which stands on something.
  static BoxSkins all(const Skin& skin) { return {skin, skin, skin, skin, skin, {}}; }
  static BoxSkins six(const Skin& skin) { return {skin, skin, skin, skin, skin, skin}; }
};

/// Skinned rectangles gathered into one mesh, in metres.
class Shape {
 public:
  using Vector = Eigen::Vector3d;

  /// A rectangle from its bottom-left `corner`, seen from the side that shows.
  void rectangle(const Vector& corner, const Vector& right, const Vector& up, const Skin& skin);
  /// Any flat quadrangle, counter-clockwise as it is seen; `at` says where in the skin, (0, 0) its
  /// top left and (1, 1) its bottom right, each corner lies.
  void quad(const std::array<Vector, 4>& corners, const Skin& skin,
            const std::array<std::array<float, 2>, 4>& at);
  /// A box, turned by `yaw` about its vertical axis.
  void box(const Vector& centre, const Vector& half, const BoxSkins& skins, double yaw = 0.0);
  /// An upright cylinder or cone on `base`; its mantle wears `side`, once around.
  void cylinder(const Vector& base, double radius, double top_radius, double height,
                const Skin& side, const Skin& top, int corners = 10);
  /// A smooth surface in columns x rows cells: `at(s, t)` from its left (s = 0) to its right (1)
  /// and from its top (t = 0) to its bottom (1), seen from the side that shows. It wears `skin`
  /// once. What goes all round has at(0, t) = at(1, t) and goes on beyond them, so that no seam
  /// shows.
  void surface(int columns, int rows, const std::function<Vector(double s, double t)>& at,
               const Skin& skin);
  /// A straight limb with round ends, its skin once around and along; `front` is a direction that
  /// the middle of the skin looks to. Metres.
  void limb(const Vector& from, const Vector& to, double radius, double end_radius,
            const Vector& front, const Skin& skin, int corners = 12);

  [[nodiscard]] bool empty() const noexcept { return faces_.empty(); }
  [[nodiscard]] int triangles() const noexcept { return static_cast<int>(faces_.size()) / 3; }

  /// Adds the mesh `name` and a geom of that name to `body`: drawn, not touched, without mass.
  /// `atlas` is the finished size of the atlas that the skins are of, or 1 x 1 without one.
  mjsGeom& add_to(mjSpec& spec, mjsBody& body, const std::string& name, const std::string& material,
                  cv::Size atlas) const;

 private:
  void piece(const Vector& corner, const Vector& right, const Vector& up, float u0, float v0,
             float u1, float v1);
  int vertex(const Vector& position, const Vector& normal, float u, float v);

  std::vector<float> positions_;  // x y z a vertex, metres
  std::vector<float> normals_;
  std::vector<float> texels_;  // u v a vertex, texels of the atlas; v down
  std::vector<int> faces_;     // three vertices a triangle, counter-clockwise from outside
};

}  // namespace pacer::sim
