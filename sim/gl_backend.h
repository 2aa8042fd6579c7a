// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "sim/gl_context.h"

namespace pacer::sim {

/// One of the ways to a context: EGL or OSMesa.
class GlContext::Backend {
 public:
  virtual ~Backend() = default;
  virtual void make_current() = 0;
  [[nodiscard]] virtual void* function(const char* name) const = 0;  ///< of OpenGL
  [[nodiscard]] const std::string& path() const { return path_; }

 protected:
  std::string path_;
};

/// The first way that is open, in the order that GlContext documents; sets MUJOCO_GL to it. Throws
/// std::runtime_error, saying for each way why it is closed.
[[nodiscard]] std::unique_ptr<GlContext::Backend> open_gl_backend();

}  // namespace pacer::sim
