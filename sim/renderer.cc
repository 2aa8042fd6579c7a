// SPDX-License-Identifier: Apache-2.0
#include "sim/renderer.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>

#include "core/check.h"
#include "sim/room.h"

namespace pacer::sim {
namespace {

/// What a word in RenderConfig stands for.
struct Preset {
  const char* name;
  int samples;      // a pixel
  int shadow_size;  // side of the shadow map, pixels; 0: no shadows
  bool reflections;
};

constexpr std::array<Preset, 3> kPresets = {{
    {"fast", 0, 0, false},
    {"fine", 4, 0, false},
    {"best", 4, 2048, true},
}};

const Preset* find(const std::string& name) {
  const auto* const found =
      std::ranges::find_if(kPresets, [&name](const Preset& preset) { return name == preset.name; });
  return found == kPresets.end() ? nullptr : found;
}

template <class Value>
void flip_rows(const std::vector<Value>& from, Value* to, int rows) {
  const std::size_t row = from.size() / static_cast<std::size_t>(rows);
  for (std::size_t y = 0; y < static_cast<std::size_t>(rows); ++y) {
    const Value* const source = from.data() + (static_cast<std::size_t>(rows) - 1 - y) * row;
    std::memcpy(to + y * row, source, row * sizeof(Value));
  }
}

}  // namespace

void RenderConfig::validate() const {
  require(find(quality) != nullptr, "quality: must be fast, fine or best, not " + quality);
}

mjvOption shown_in_pictures() {
  mjvOption shown;
  mjv_defaultOption(&shown);
  std::ranges::fill(shown.flags, mjtByte{0});
  shown.flags[mjVIS_TEXTURE] = 1;
  shown.flags[mjVIS_STATIC] = 1;
  shown.flags[mjVIS_TENDON] = 1;
  shown.flags[mjVIS_SKIN] = 1;
  std::ranges::fill(shown.sitegroup, mjtByte{0});
  std::ranges::fill(shown.geomgroup, mjtByte{0});
  for (const GeomGroup group : {kStructure, kFurniture, kDecoration}) shown.geomgroup[group] = 1;
  return shown;
}

void make_buffers(const mjModel& model, ImageSize size, const RenderConfig& config, mjvScene& scene,
                  mjrContext& buffers) {
  config.validate();
  require(size.width > 0 && size.height > 0, "size: a picture has at least one pixel");
  const Preset& preset = *find(config.quality);

  mjModel sized = model;  // the struct alone: its arrays are shared and only read
  sized.vis.global.offwidth = size.width;
  sized.vis.global.offheight = size.height;
  sized.vis.quality.offsamples = preset.samples;
  sized.vis.quality.shadowsize = preset.shadow_size;
  mjr_defaultContext(&buffers);
  mjr_makeContext(&sized, &buffers, mjFONTSCALE_50);
  mjr_setBuffer(mjFB_OFFSCREEN, &buffers);
  if (buffers.currentBuffer != mjFB_OFFSCREEN || buffers.offWidth < size.width ||
      buffers.offHeight < size.height) {
    mjr_freeContext(&buffers);
    throw std::runtime_error("OpenGL cannot draw a picture of " + std::to_string(size.width) +
                             " x " + std::to_string(size.height) +
                             " pixels; ask for a smaller one");
  }

  mjv_defaultScene(&scene);
  // Room for every geom, tendon segment and skin; a scene that is too small warns, silently.
  mjv_makeScene(&model, &scene, static_cast<int>(model.ngeom + 8 * model.ntendon) + 64);
  std::ranges::fill(scene.flags, mjtByte{0});
  scene.flags[mjRND_CULL_FACE] = 1;
  scene.flags[mjRND_SKYBOX] = 1;
  scene.flags[mjRND_SHADOW] = preset.shadow_size > 0 ? 1 : 0;
  scene.flags[mjRND_REFLECTION] = preset.reflections ? 1 : 0;
}

Renderer::Renderer(const mjModel& model, const std::string& camera, ImageSize size,
                   const RenderConfig& config)
    : shown_(shown_in_pictures()), size_(size) {
  mjv_defaultCamera(&camera_);
  camera_.type = mjCAMERA_FIXED;
  camera_.fixedcamid = mj_name2id(&model, mjOBJ_CAMERA, camera.c_str());
  if (camera_.fixedcamid < 0) throw UsageError("the model has no camera named " + camera);
  make_buffers(model, size, config, scene_, buffers_);

  const std::size_t pixels =
      static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  bottom_first_.resize(pixels * 3);
  depth_bottom_first_.resize(pixels);
}

Renderer::~Renderer() {
  try {
    context_.make_current();
  } catch (const std::exception&) {
    return;  // the context is lost and with it everything in it
  }
  mjv_freeScene(&scene_);
  mjr_freeContext(&buffers_);
}

void Renderer::render(const mjModel& model, mjData& data, Frame& out) {
  draw(model, data, out, nullptr);
}

void Renderer::render(const mjModel& model, mjData& data, Frame& out, std::vector<float>& depth) {
  draw(model, data, out, depth_bottom_first_.data());
  // The buffer holds 0 at the near plane and 1 at the far one, and is linear in 1 / distance.
  const float near = scene_.camera[0].frustum_near;
  const float far = scene_.camera[0].frustum_far;
  for (float& value : depth_bottom_first_) value = near * far / (far - value * (far - near));
  depth.resize(depth_bottom_first_.size());
  flip_rows(depth_bottom_first_, depth.data(), size_.height);
}

void Renderer::render_flat(const mjModel& model, mjData& data, std::span<const Rgb> colours,
                           Rgb rest, Frame& out) {
  check(colours.size() == static_cast<std::size_t>(model.ngeom), "a colour for every geom");
  context_.make_current();
  mjv_updateScene(&model, &data, &shown_, nullptr, &camera_, mjCAT_ALL, &scene_);
  // MuJoCo writes segid + 1 into the picture, red lowest, and does not draw -1.
  const auto id_of = [](Rgb colour) { return (colour[0] | colour[1] << 8 | colour[2] << 16) - 1; };
  constexpr float kClear = 0.5F;  // opacity: one sees through what has less
  for (int i = 0; i < scene_.ngeom; ++i) {
    mjvGeom& geom = scene_.geoms[i];
    const bool ours = geom.objtype == mjOBJ_GEOM && geom.objid >= 0 && geom.objid < model.ngeom;
    geom.segid = id_of(ours ? colours[static_cast<std::size_t>(geom.objid)] : rest);
    if (geom.rgba[3] < kClear) geom.segid = -1;
  }
  std::array<mjtByte, mjNRNDFLAG> lit{};
  std::ranges::copy(scene_.flags, lit.begin());
  scene_.flags[mjRND_SEGMENT] = scene_.flags[mjRND_IDCOLOR] = 1;
  scene_.flags[mjRND_SKYBOX] = scene_.flags[mjRND_SHADOW] = scene_.flags[mjRND_REFLECTION] = 0;
  read(out, nullptr);
  std::ranges::copy(lit, scene_.flags);
}

void Renderer::draw(const mjModel& model, mjData& data, Frame& out, float* depth) {
  context_.make_current();
  mjv_updateScene(&model, &data, &shown_, nullptr, &camera_, mjCAT_ALL, &scene_);
  read(out, depth);
}

void Renderer::read(Frame& out, float* depth) {
  const mjrRect whole{0, 0, size_.width, size_.height};
  mjr_render(whole, &scene_, &buffers_);
  mjr_readPixels(bottom_first_.data(), depth, whole, &buffers_);
  out.size = size_;
  out.rgb.resize(bottom_first_.size());
  flip_rows(bottom_first_, out.rgb.data(), size_.height);
}

}  // namespace pacer::sim
