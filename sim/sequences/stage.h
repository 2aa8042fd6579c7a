// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/box.h"
#include "core/frame.h"
#include "core/random.h"
#include "sim/lens.h"
#include "sim/renderer.h"
#include "sim/sensor.h"

namespace pacer::sim {

class Stage;

/// What there is in a simulated sequence and what happens to it.
struct Scene {
  struct Delete {
    void operator()(mjSpec* made) const noexcept { mj_deleteSpec(made); }
  };
  /// Bodies that move are mocap bodies or hang on one. kTarget is the body that is tracked, with
  /// all that hangs on it.
  std::unique_ptr<mjSpec, Delete> spec{mj_makeSpec()};
  /// Of the target, metres in its frame: the truth is the box about these points in the picture.
  std::vector<Eigen::Vector3d> outline;
  /// Brings everything to where it is at a frame; fractions lie between frames.
  std::function<void(Stage& stage, double frame)> act;

  double view_angle = 50.0;   ///< degrees, of the picture's width
  double distortion = -0.03;  ///< as LensConfig's
  double noise = 2.0;         ///< grey levels, deviation of one sample
  double shutter = 0.25;      ///< share of a frame's time that it stands open

  static constexpr const char* kTarget = "target";
  /// Adds a body without joints that the act places.
  mjsBody& add_body(const std::string& name) const;
};

/// A scene with a camera in front of it.
class Stage {
 public:
  /// Throws std::runtime_error when there is no OpenGL to draw with.
  Stage(Scene scene, ImageSize size, const Random& random);

  /// Everything as it is at `frame`: what follows is of that moment.
  void go_to(double frame);
  /// The box about the target's outline.
  [[nodiscard]] Box truth() const;
  /// The picture taken at `frame`: the mean of renders spread over the time that the shutter is
  /// open and, for smooth edges, over a pixel; then lens and noise. The stage is then at `frame`.
  void expose(double frame, Frame& out);

  // For acts. Names are those of the spec.
  void place(const std::string& body, const Eigen::Isometry3d& world_from_body);
  void bend(const std::string& joint, double by);  ///< radians, metres where it slides
  void show(const std::string& geom, bool shown);
  void shine(const std::string& light,
             double factor);  ///< on its own diffuse light; "": the ambient one
  /// Camera axes: x right, y down, z ahead. `zoom` is a factor on the focal length.
  void aim(const Eigen::Isometry3d& world_from_camera, double zoom = 1.0);
  /// Puts the camera at `eye` and turns it so that `point` is seen at `pixel`; `roll` turns the
  /// picture about it, radians clockwise as one looks.
  void frame(const Eigen::Vector3d& eye, const Eigen::Vector3d& point, const Eigen::Vector2d& pixel,
             double roll, double zoom = 1.0);

  [[nodiscard]] const Lens& lens() const noexcept { return lens_; }
  [[nodiscard]] const mjModel& model() const noexcept { return *model_; }
  [[nodiscard]] const mjData& data() const noexcept { return *data_; }

 private:
  struct Delete {
    void operator()(mjModel* model) const noexcept { mj_deleteModel(model); }
    void operator()(mjData* data) const noexcept { mj_deleteData(data); }
  };

  [[nodiscard]] int find(mjtObj kind, const std::string& name) const;
  void turn_eye(double aside, double down);
  [[nodiscard]] int renders_for(double frame);

  std::function<void(Stage&, double)> act_;
  std::vector<Eigen::Vector3d> outline_;
  double shutter_;
  Lens lens_;
  std::unique_ptr<mjModel, Delete> model_;
  std::unique_ptr<mjModel, Delete> as_built_;  // whose lights shine() scales
  std::unique_ptr<mjData, Delete> data_;
  int target_ = -1;
  Eigen::Isometry3d world_from_camera_ = Eigen::Isometry3d::Identity();
  double zoom_ = 1.0;
  std::optional<Renderer> renderer_;
  Sensor sensor_;
  Frame rendered_;
  std::vector<std::uint16_t> sums_;
};

/// Camera pose at `eye` that looks at `at`, `roll` radians clockwise as one looks.
[[nodiscard]] Eigen::Isometry3d look_at(const Eigen::Vector3d& eye, const Eigen::Vector3d& at,
                                        double roll = 0.0);

/// A pose from a place and turns about z, then y, then x (yaw, pitch, roll; radians).
[[nodiscard]] Eigen::Isometry3d pose_at(const Eigen::Vector3d& place, double yaw,
                                        double pitch = 0.0, double roll = 0.0);

}  // namespace pacer::sim
