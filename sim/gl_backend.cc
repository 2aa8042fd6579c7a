// SPDX-License-Identifier: Apache-2.0
#include "sim/gl_backend.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>

#include <array>
#include <charconv>
#include <cstdlib>
#include <stdexcept>
#include <utility>
#include <vector>

namespace pacer::sim {
namespace {

/// Why one way to a context is closed; the next is tried.
class Unavailable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A shared library that stays loaded: drivers do not survive being unloaded. Its symbols are made
/// global because that is where MuJoCo looks for eglGetProcAddress or OSMesaGetProcAddress.
class Library {
 public:
  explicit Library(const char* name) : handle_(dlopen(name, RTLD_NOW | RTLD_GLOBAL)) {
    if (handle_ == nullptr) throw Unavailable(std::string("cannot load ") + name);
  }
  template <class Function>
  [[nodiscard]] Function get(const char* symbol) const {
    void* const address = dlsym(handle_, symbol);
    if (address == nullptr) throw Unavailable(std::string(symbol) + " is missing");
    return reinterpret_cast<Function>(address);
  }

 private:
  void* handle_;
};

std::string environment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::string() : std::string(value);
}

// ---------------------------------------------------------------------------------------- EGL

/// The functions of libEGL that are used. Loaded, not linked: a machine without it can use OSMesa.
struct Egl {
  Library library{"libEGL.so.1"};
  decltype(&eglGetProcAddress) get_proc =
      library.get<decltype(&eglGetProcAddress)>("eglGetProcAddress");
  decltype(&eglGetDisplay) get_display = library.get<decltype(&eglGetDisplay)>("eglGetDisplay");
  decltype(&eglInitialize) initialize = library.get<decltype(&eglInitialize)>("eglInitialize");
  decltype(&eglGetError) get_error = library.get<decltype(&eglGetError)>("eglGetError");
  decltype(&eglBindAPI) bind_api = library.get<decltype(&eglBindAPI)>("eglBindAPI");
  decltype(&eglChooseConfig) choose_config =
      library.get<decltype(&eglChooseConfig)>("eglChooseConfig");
  decltype(&eglCreateContext) create_context =
      library.get<decltype(&eglCreateContext)>("eglCreateContext");
  decltype(&eglDestroyContext) destroy_context =
      library.get<decltype(&eglDestroyContext)>("eglDestroyContext");
  decltype(&eglMakeCurrent) make_current = library.get<decltype(&eglMakeCurrent)>("eglMakeCurrent");
  PFNEGLQUERYDEVICESEXTPROC query_devices =
      reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(get_proc("eglQueryDevicesEXT"));
  PFNEGLGETPLATFORMDISPLAYEXTPROC get_platform_display =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(get_proc("eglGetPlatformDisplayEXT"));

  [[noreturn]] void fail(const std::string& call) const {
    std::array<char, 8> code{};
    const auto end = std::to_chars(code.data(), code.data() + code.size(), get_error(), 16).ptr;
    throw Unavailable(call + " failed (0x" + std::string(code.data(), end) + ")");
  }
};

class EglBackend : public GlContext::Backend {
 public:
  EglBackend(const Egl& egl, EGLDisplay display, std::string path) : egl_(egl), display_(display) {
    path_ = std::move(path);
    if (display_ == EGL_NO_DISPLAY) egl_.fail("eglGetDisplay");
    // Never terminated: that would end every other context of the process on this display.
    if (egl_.initialize(display_, nullptr, nullptr) != EGL_TRUE) egl_.fail("eglInitialize");
    if (egl_.bind_api(EGL_OPENGL_API) != EGL_TRUE) egl_.fail("eglBindAPI");
    constexpr std::array<EGLint, 7> kWanted = {
        EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_DEPTH_SIZE, 24,
        EGL_NONE};
    EGLConfig config = nullptr;
    EGLint found = 0;
    if (egl_.choose_config(display_, kWanted.data(), &config, 1, &found) != EGL_TRUE) {
      egl_.fail("eglChooseConfig");
    }
    if (found == 0) throw Unavailable("eglChooseConfig found no OpenGL configuration");
    context_ = egl_.create_context(display_, config, EGL_NO_CONTEXT, nullptr);
    if (context_ == EGL_NO_CONTEXT) egl_.fail("eglCreateContext");
    if (!current()) {
      egl_.destroy_context(display_, context_);
      egl_.fail("eglMakeCurrent");
    }
  }
  ~EglBackend() override {
    egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    egl_.destroy_context(display_, context_);
  }
  EglBackend(const EglBackend&) = delete;
  EglBackend& operator=(const EglBackend&) = delete;

  void make_current() override {
    if (!current()) egl_.fail(path_ + ": eglMakeCurrent");
  }
  [[nodiscard]] void* function(const char* name) const override {
    return reinterpret_cast<void*>(egl_.get_proc(name));
  }

 private:
  // Without a surface: MuJoCo draws into a frame buffer object of its own.
  [[nodiscard]] bool current() const {
    return egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
  }

  const Egl& egl_;
  EGLDisplay display_;
  EGLContext context_ = EGL_NO_CONTEXT;
};

const Egl& egl() {
  static const Egl functions;  // throws again on the next call when it cannot be loaded
  return functions;
}

/// The devices to try: the one that MUJOCO_EGL_DEVICE_ID names, else all.
std::vector<std::pair<EGLDeviceEXT, std::string>> egl_devices() {
  if (egl().query_devices == nullptr || egl().get_platform_display == nullptr) {
    throw Unavailable("eglQueryDevicesEXT is missing");
  }
  std::array<EGLDeviceEXT, 32> devices{};
  EGLint count = 0;
  if (egl().query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count) !=
      EGL_TRUE) {
    egl().fail("eglQueryDevicesEXT");
  }
  std::vector<std::pair<EGLDeviceEXT, std::string>> all;
  for (EGLint i = 0; i < count; ++i) {
    all.emplace_back(devices.at(static_cast<std::size_t>(i)), "EGL device " + std::to_string(i));
  }
  const std::string wanted = environment("MUJOCO_EGL_DEVICE_ID");
  if (wanted.empty()) return all;
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), index);
  if (error != std::errc{} || end != wanted.data() + wanted.size() || index >= all.size()) {
    throw std::runtime_error("MUJOCO_EGL_DEVICE_ID=" + wanted + ": must be below " +
                             std::to_string(all.size()) + ", the number of EGL devices; unset it");
  }
  return {all.at(index)};
}

// ------------------------------------------------------------------------------------- OSMesa

/// The functions of libOSMesa that are used, declared here: its headers are seldom installed.
struct OsMesa {
  Library library;
  void* (*create)(unsigned format, int depth, int stencil, int accumulation,
                  void* share) = library.get<decltype(create)>("OSMesaCreateContextExt");
  unsigned char (*make_current)(void* context, void* buffer, unsigned type, int width, int height) =
      library.get<decltype(make_current)>("OSMesaMakeCurrent");
  void (*destroy)(void* context) = library.get<decltype(destroy)>("OSMesaDestroyContext");
  void* (*get_proc)(const char* name) = library.get<decltype(get_proc)>("OSMesaGetProcAddress");
};

const OsMesa& osmesa() {
  static const OsMesa functions = [] {
    for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6"}) {
      try {
        return OsMesa{Library(name)};
      } catch (const Unavailable&) {
        // the next
      }
    }
    return OsMesa{Library("libOSMesa.so")};
  }();
  return functions;
}

class OsMesaBackend : public GlContext::Backend {
 public:
  explicit OsMesaBackend(const OsMesa& mesa) : mesa_(mesa) {
    path_ = "OSMesa";
    constexpr unsigned kRgba = 0x1908;  // GL_RGBA
    context_ = mesa_.create(kRgba, 24, 8, 0, nullptr);
    if (context_ == nullptr) throw Unavailable("OSMesaCreateContextExt failed");
    if (!current()) {
      mesa_.destroy(context_);
      throw Unavailable("OSMesaMakeCurrent failed");
    }
  }
  ~OsMesaBackend() override {
    mesa_.make_current(nullptr, nullptr, 0, 0, 0);
    mesa_.destroy(context_);
  }
  OsMesaBackend(const OsMesaBackend&) = delete;
  OsMesaBackend& operator=(const OsMesaBackend&) = delete;

  void make_current() override {
    if (!current()) throw std::runtime_error("OSMesa: OSMesaMakeCurrent failed");
  }
  [[nodiscard]] void* function(const char* name) const override { return mesa_.get_proc(name); }

 private:
  bool current() {
    constexpr unsigned kBytes = 0x1401;  // GL_UNSIGNED_BYTE
    return mesa_.make_current(context_, screen_.data(), kBytes, kSide, kSide) != 0;
  }

  static constexpr int kSide = 16;  // of the screen that nobody draws to
  const OsMesa& mesa_;
  void* context_ = nullptr;
  std::array<unsigned char, std::size_t{4} * kSide * kSide> screen_{};
};

// --------------------------------------------------------------------------------- the order

/// Tries `make`; notes in `failures` why it did not work.
template <class Make>
std::unique_ptr<GlContext::Backend> attempt(const std::string& path, std::string& failures,
                                            Make&& make) {
  try {
    return make();
  } catch (const Unavailable& why) {
    failures += (failures.empty() ? "" : "; ") + path + ": " + why.what();
    return nullptr;
  }
}

std::unique_ptr<GlContext::Backend> open_egl(std::string& failures) {
  std::vector<std::pair<EGLDeviceEXT, std::string>> devices;
  (void)attempt("EGL devices", failures, [&] {
    devices = egl_devices();
    return nullptr;
  });
  if (devices.empty() && failures.empty()) failures = "EGL devices: none found";
  for (const auto& device : devices) {
    auto backend = attempt(device.second, failures, [&device] {
      return std::make_unique<EglBackend>(
          egl(), egl().get_platform_display(EGL_PLATFORM_DEVICE_EXT, device.first, nullptr),
          device.second);
    });
    if (backend) return backend;
  }
  if (!environment("MUJOCO_EGL_DEVICE_ID").empty()) return nullptr;  // that one and no other
  auto backend = attempt("EGL surfaceless", failures, [] {
    if (egl().get_platform_display == nullptr) {
      throw Unavailable("eglGetPlatformDisplayEXT is missing");
    }
    return std::make_unique<EglBackend>(
        egl(),
        egl().get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr),
        "EGL surfaceless");
  });
  if (backend) return backend;
  return attempt("EGL default", failures, [] {
    return std::make_unique<EglBackend>(egl(), egl().get_display(EGL_DEFAULT_DISPLAY),
                                        "EGL default");
  });
}

}  // namespace

std::unique_ptr<GlContext::Backend> open_gl_backend() {
  const std::string only = environment("MUJOCO_GL");
  std::string failures;
  if (only != "osmesa") {
    if (auto backend = open_egl(failures)) {
      setenv("MUJOCO_GL", "egl", 1);
      return backend;
    }
  }
  if (only != "egl") {
    auto backend =
        attempt("OSMesa", failures, [] { return std::make_unique<OsMesaBackend>(osmesa()); });
    if (backend) {
      setenv("MUJOCO_GL", "osmesa", 1);
      return backend;
    }
  }
  throw std::runtime_error("no off-screen OpenGL: " + failures +
                           "; install libegl1 and libgl1-mesa-dri, or libosmesa6");
}

}  // namespace pacer::sim
