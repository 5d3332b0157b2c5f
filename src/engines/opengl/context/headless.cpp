// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/context/headless.h"

#include <dlfcn.h>
#include <epoxy/egl.h>

#include <cstdlib>
#include <string>
#include <vector>

#include <rakelight/base/error.h>

namespace rakelight::opengl {
namespace {

[[noreturn]] void fail(const std::string& reason, const std::string& missing = {}) {
    throw Error(ErrorCode::failed, reason, {},
                missing.empty() ? "render with engine soft" : "install " + missing + ", or use 'engine' soft")
        .naming({"engine"});
}

constexpr const char* packages =
    "it (on Debian the packages libegl1 and libgl1, and libgl1-mesa-dri to draw without a GPU)";

/// For good: epoxy opens it again.
void* opened(const char* name) { return dlopen(name, RTLD_LAZY | RTLD_LOCAL); }

/// Without the library of a context's functions libepoxy ends the process.
bool has_functions(bool is_es) {
    if (is_es) return opened("libGLESv2.so.2") != nullptr;
    return opened("libGL.so.1") || opened("libOpenGL.so.0");
}

/// libepoxy ends the process if libEGL lacks a function that is called, so this is checked first.
void require_egl() {
    void* const library = opened("libEGL.so.1");
    if (!library || !epoxy_has_egl()) fail("libEGL is missing: OpenGL cannot be used without a window", packages);
    for (const char* const name :
         {"eglGetDisplay", "eglInitialize", "eglBindAPI", "eglChooseConfig", "eglCreateContext", "eglMakeCurrent",
          "eglQueryString", "eglGetProcAddress", "eglTerminate"})
        if (!dlsym(library, name)) fail(std::string("libEGL is broken: it has no ") + name);
}

bool wants_es() {
    const char* const wish = std::getenv("RAKELIGHT_GL");
    return wish && std::string(wish) == "es";
}

void require_functions() {
    if (has_functions(true) || (!wants_es() && has_functions(false))) return;
    if (wants_es()) fail("libGLESv2 is missing", "it (on Debian the package libgles2)");
    fail("libGL is missing", packages);
}

bool initialize(EGLDisplay display) {
    return display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) != EGL_FALSE;
}

/// One that says when it is lost, where the driver has such. @param attributes  ends with EGL_NONE
EGLContext make_robust_context(EGLDisplay display, EGLConfig config, const EGLint* attributes) {
    if (!epoxy_has_egl_extension(display, "EGL_EXT_create_context_robustness")) return EGL_NO_CONTEXT;
    std::vector<EGLint> all;
    for (; *attributes != EGL_NONE; ++attributes) all.push_back(*attributes);
    for (const EGLint more :
         {EGL_CONTEXT_OPENGL_ROBUST_ACCESS_EXT, EGL_TRUE, EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_EXT,
          EGL_LOSE_CONTEXT_ON_RESET_EXT, EGL_NONE})
        all.push_back(EGLint(more));
    return eglCreateContext(display, config, EGL_NO_CONTEXT, all.data());
}

EGLContext make_context(EGLDisplay display, bool is_es) {
    if (eglBindAPI(is_es ? EGL_OPENGL_ES_API : EGL_OPENGL_API) == EGL_FALSE) return EGL_NO_CONTEXT;
    const EGLint wanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, is_es ? EGL_OPENGL_ES3_BIT : EGL_OPENGL_BIT,
                             EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    eglChooseConfig(display, wanted, &config, 1, &count);
    const EGLint core[] = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    const EGLint es[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0, EGL_NONE};
    const EGLConfig with = count > 0 ? config : nullptr;
    const EGLContext robust = make_robust_context(display, with, is_es ? es : core);
    return robust != EGL_NO_CONTEXT ? robust : eglCreateContext(display, with, EGL_NO_CONTEXT, is_es ? es : core);
}

}  // namespace

struct HeadlessContext::State {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    ~State() {
        if (display == EGL_NO_DISPLAY) return;
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
        eglReleaseThread();  // the display stays: another context of the process may use it
    }
    bool open(EGLDisplay on) {
        if (!initialize(on)) return false;
        for (const bool is_es : {false, true}) {
            if ((wants_es() && !is_es) || !has_functions(is_es)) continue;
            const EGLContext made = make_context(on, is_es);
            if (made == EGL_NO_CONTEXT) continue;
            if (eglMakeCurrent(on, EGL_NO_SURFACE, EGL_NO_SURFACE, made) != EGL_FALSE) {
                display = on, context = made;
                return true;
            }
            eglDestroyContext(on, made);
        }
        return false;
    }
};

HeadlessContext::HeadlessContext() : state_(std::make_unique<State>()) {
    require_egl();
    require_functions();
    const bool is_surfaceless = epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless");
    const bool has_devices = epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device") &&
                             epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration");
    if (has_devices) {  // GPUs first: Mesa's own surfaceless platform knows only its drivers
        EGLDeviceEXT devices[16];
        EGLint count = 0;
        if (eglQueryDevicesEXT(16, devices, &count) == EGL_FALSE) count = 0;
        for (EGLint i = 0; i < count; ++i) {
            const char* const what = eglQueryDeviceStringEXT(devices[i], EGL_EXTENSIONS);
            if (what && std::string(what).find("EGL_MESA_device_software") != std::string::npos) continue;
            if (state_->open(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr))) return;
        }
    }
    if (is_surfaceless &&
        state_->open(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)))
        return;
    if (state_->open(eglGetDisplay(EGL_DEFAULT_DISPLAY))) return;
    fail("EGL makes no context of OpenGL 3.3 or OpenGL ES 3.0",
         "a driver (on Debian the package libgl1-mesa-dri draws without a GPU)");
}

HeadlessContext::~HeadlessContext() = default;

}  // namespace rakelight::opengl
