// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/context/driver.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include <rakelight/base/error.h>

#include "base/format_text.h"

namespace rakelight::opengl {
namespace {

std::string text(GLenum name) {
    const GLubyte* const words = glGetString(name);
    return words ? reinterpret_cast<const char*>(words) : "";
}

int number(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

bool has(const char* extension) { return epoxy_has_gl_extension(extension); }

bool is_software(const std::string& renderer) {
    for (const char* const name : {"llvmpipe", "softpipe", "swrast", "Software Rasterizer", "SwiftShader", "SWR"})
        if (renderer.find(name) != std::string::npos) return true;
    return false;
}

int most_samples(const Driver& driver) {
    const bool can_ask = driver.is_es || epoxy_gl_version() >= 42 || has("GL_ARB_internalformat_query");
    GLint samples = 0;
    if (can_ask)
        glGetInternalformativ(GL_RENDERBUFFER, GL_RGBA16F, GL_SAMPLES, 1, &samples);
    else
        samples = number(GL_MAX_SAMPLES);
    return std::max(int(samples), 1);
}

/// Without it (RAKELIGHT_GL_CLIP_CONTROL=off, for tests) depth is that of the textbook.
bool has_clip_control(bool is_in_driver) {
    const char* const forced = std::getenv("RAKELIGHT_GL_CLIP_CONTROL");
    return is_in_driver && !(forced && std::strcmp(forced, "off") == 0);
}

/// For tests: how a material with more maps than the driver has units is drawn.
int texture_units() {
    const char* const forced = std::getenv("RAKELIGHT_GL_TEXTURE_UNITS");
    const int units = number(GL_MAX_TEXTURE_IMAGE_UNITS);
    return forced ? std::clamp(std::atoi(forced), 8, units) : units;
}

/// The processor's own kernels are faster than a driver that draws by it (docs/motion.md). RAKELIGHT_GL_POSES=gpu or cpu, for
/// tests and measurements.
bool poses_meshes(bool is_software) {
    const char* const forced = std::getenv("RAKELIGHT_GL_POSES");
    return forced ? std::strcmp(forced, "gpu") == 0 : !is_software;
}

}  // namespace

Driver ask_driver() {
    Driver d;
    d.is_es = !epoxy_is_desktop_gl();
    const int version = epoxy_gl_version();
    if (version < (d.is_es ? 30 : 33))
        throw Error(ErrorCode::failed,
                    format_text("the OpenGL driver has version {}.{}{}", version / 10, version % 10,
                                d.is_es ? " ES; 3.0 is needed" : "; 3.3 is needed"),
                    {}, "render with engine soft");
    d.renderer = text(GL_RENDERER);
    d.identity = text(GL_VENDOR) + "\n" + d.renderer + "\n" + text(GL_VERSION);
    d.is_software = is_software(d.renderer);
    d.poses_meshes = poses_meshes(d.is_software);
    if (d.is_es && !has("GL_EXT_color_buffer_float"))
        throw Error(ErrorCode::failed, "this OpenGL ES driver draws no floats (EXT_color_buffer_float)", {},
                    "render with engine soft");
    d.has_reversed_depth =
        has_clip_control(d.is_es ? has("GL_EXT_clip_control") : version >= 45 || has("GL_ARB_clip_control"));
    d.has_sample_mask = d.is_es ? version >= 31 && has("GL_OES_sample_variables") : has("GL_ARB_gpu_shader5");
    d.has_timer = !d.is_es;
    d.has_program_binaries =
        (d.is_es || version >= 41 || has("GL_ARB_get_program_binary")) && number(GL_NUM_PROGRAM_BINARY_FORMATS) > 0;
    d.filters_floats = !d.is_es || has("GL_OES_texture_float_linear");
    d.texture_units = texture_units();
    d.texture_size = number(GL_MAX_TEXTURE_SIZE);
    GLint viewport[2] = {0, 0};
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
    d.picture_size = std::min({number(GL_MAX_RENDERBUFFER_SIZE), int(viewport[0]), int(viewport[1]), d.texture_size});
    d.samples = most_samples(d);
    return d;
}

EngineCapabilities abilities_of(const Driver& driver) {
    EngineCapabilities can;
    can.channels = channels_all;
    for (const int samples : {4, 8})
        if (driver.samples >= samples) can.samples.push_back(samples);
    can.screen_interpolation = true;
    can.shadows = true;
    can.user_lighting = RL_PROCESSES;  // which are compiled in another one first
    can.lines_and_points = true;
    return can;
}

void check_gl(const char* what) {
    const GLenum fault = glGetError();
    if (fault == GL_NO_ERROR) return;
    constexpr int most = 100;  // a lost context never says that there are no more
    for (int i = 0; i < most && glGetError() != GL_NO_ERROR; ++i) {
    }
    const std::string why = fault == GL_OUT_OF_MEMORY  ? "the GPU has no memory left"
                            : fault == GL_CONTEXT_LOST ? "the OpenGL context is lost"
                                                       : "OpenGL error " + std::to_string(fault);
    throw Error(ErrorCode::failed, why + " for " + what, {}, "render with engine soft");
}

}  // namespace rakelight::opengl
