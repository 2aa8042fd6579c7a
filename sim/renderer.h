// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/frame.h"
#include "sim/gl_context.h"

namespace pacer::sim {

/// Red, green, blue.
using Rgb = std::array<std::uint8_t, 3>;

/// How much work goes into a picture. What a software renderer pays for is passes, not pixels.
struct RenderConfig {
  /// `fast`: one pass, for headless teaching. `fine`: smooth edges. `best`: soft shadows and
  /// reflections too, for pictures to show; an order of magnitude slower on a CPU.
  std::string quality = "fast";

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("quality", quality);
  }
};

/// What is seen of a model: what a photograph of it would show, and no more.
[[nodiscard]] mjvOption shown_in_pictures();

/// Makes what MuJoCo draws `model` with, at the quality of `config`, in the current OpenGL context;
/// the caller frees both. Throws std::runtime_error when it cannot draw at this size.
void make_buffers(const mjModel& model, ImageSize size, const RenderConfig& config, mjvScene& scene,
                  mjrContext& buffers);

/// Draws one model through one of its cameras, with an OpenGL context of its own.
///
/// The same model and data give the same bytes on one machine, whatever was drawn before. Use it on
/// the thread that made it; make it after fork(). Proxies (`kProxy`) are not drawn.
class Renderer {
 public:
  /// `camera` names a camera of `model`. Throws UsageError when there is none of that name, and
  /// std::runtime_error when there is no OpenGL to draw with, or it cannot draw at this size.
  Renderer(const mjModel& model, const std::string& camera, ImageSize size,
           const RenderConfig& config = {});
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Fills the size and pixels of `out`; its buffer is reused. `data` must be up to date (mj_step
  /// or mj_forward). `model` is the one that the renderer was made for, whose numbers (light,
  /// camera, colours; not meshes and textures) may have changed since.
  void render(const mjModel& model, mjData& data, Frame& out);

  /// Also fills `depth` from the same pass: metres along the camera's axis, height x width, top row
  /// first. The far plane's distance where nothing was drawn.
  void render(const mjModel& model, mjData& data, Frame& out, std::vector<float>& depth);

  /// Draws every geom of the model flat, in the colour that `colours` (model.ngeom of them) has for
  /// it, whatever its material and the light; what one sees through is left out, and so is what is
  /// black. Anything else that is drawn hides what is behind it, in the colour `rest`. At an edge
  /// smooth rendering mixes two colours.
  void render_flat(const mjModel& model, mjData& data, std::span<const Rgb> colours, Rgb rest,
                   Frame& out);

  [[nodiscard]] const GlDescription& gl() const noexcept { return context_.description(); }
  [[nodiscard]] ImageSize size() const noexcept { return size_; }

 private:
  void draw(const mjModel& model, mjData& data, Frame& out, float* depth);
  void read(Frame& out, float* depth);

  GlContext context_;  // first, so that it outlives the buffers drawn into
  mjvScene scene_{};
  mjrContext buffers_{};
  mjvOption shown_{};
  mjvCamera camera_{};
  ImageSize size_;
  std::vector<std::uint8_t> bottom_first_;  // as OpenGL reads it
  std::vector<float> depth_bottom_first_;
};

}  // namespace pacer::sim
