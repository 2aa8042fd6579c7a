// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

namespace pacer::sim {

/// Which OpenGL a context draws with: what `pacer doctor` shows and reports record.
struct GlDescription {
  std::string
      path;  ///< how it was found: "EGL device 0", "EGL surfaceless", "EGL default", "OSMesa"
  std::string vendor;
  std::string renderer;
  std::string version;
  bool software = false;  ///< drawn by the CPU: correct, but many times slower than a GPU
};

/// An off-screen OpenGL context that needs no display server.
///
/// Tried in order: the devices that EGL enumerates (only number MUJOCO_EGL_DEVICE_ID where that is
/// set), EGL's surfaceless platform, its default display, OSMesa. MUJOCO_GL=egl or MUJOCO_GL=osmesa
/// keeps to one of them. MuJoCo looks OpenGL's functions up once a process, so the first context
/// decides between EGL and OSMesa for those that follow, and sets MUJOCO_GL to what it decided.
///
/// Make it after fork(): a driver's state does not survive one. It belongs to one thread, which
/// keeps the last one that was given up for the next that is wanted: a driver compiles its shaders
/// anew for every context, and an episode would pay for that.
class GlContext {
 public:
  /// Current on this thread when it returns. Throws std::runtime_error, saying for each way that
  /// was tried which call failed.
  GlContext();
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  /// What follows on this thread draws here. Needed only where a thread has several contexts.
  void make_current() const;

  [[nodiscard]] const GlDescription& description() const noexcept { return description_; }

  /// One of the ways to a context; an implementation detail.
  class Backend;

 private:
  std::unique_ptr<Backend> backend_;
  GlDescription description_;
};

}  // namespace pacer::sim
