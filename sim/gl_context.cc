// SPDX-License-Identifier: Apache-2.0
#include "sim/gl_context.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "sim/gl_backend.h"

namespace pacer::sim {
namespace {

bool draws_on_cpu(std::string_view renderer) {
  return std::ranges::any_of(
      std::array<std::string_view, 4>{"llvmpipe", "softpipe", "swrast", "Software"},
      [renderer](std::string_view name) { return renderer.find(name) != std::string_view::npos; });
}

/// The context that this thread gave up last. A child process leaves its parent's alone.
struct Spare {
  std::unique_ptr<GlContext::Backend> backend;
  pid_t owner = 0;

  ~Spare() {
    if (owner != getpid()) (void)backend.release();
  }
};
thread_local Spare spare;

std::unique_ptr<GlContext::Backend> open_or_reuse() {
  if (spare.backend && spare.owner != getpid()) (void)spare.backend.release();
  if (!spare.backend) return open_gl_backend();
  spare.backend->make_current();
  return std::move(spare.backend);
}

}  // namespace

GlContext::GlContext() : backend_(open_or_reuse()) {
  using GetString = const unsigned char* (*)(unsigned);
  const auto get_string = reinterpret_cast<GetString>(backend_->function("glGetString"));
  const auto ask = [get_string](unsigned name) {
    const unsigned char* const text = get_string == nullptr ? nullptr : get_string(name);
    return text == nullptr ? std::string("unknown")
                           : std::string(reinterpret_cast<const char*>(text));
  };
  description_.path = backend_->path();
  description_.vendor = ask(0x1F00);    // GL_VENDOR
  description_.renderer = ask(0x1F01);  // GL_RENDERER
  description_.version = ask(0x1F02);   // GL_VERSION
  description_.software = draws_on_cpu(description_.renderer) || description_.path == "OSMesa";
}

GlContext::~GlContext() {
  spare.backend = std::move(backend_);
  spare.owner = getpid();
}

void GlContext::make_current() const { backend_->make_current(); }

}  // namespace pacer::sim
