// SPDX-License-Identifier: Apache-2.0
#define GL_GLEXT_PROTOTYPES
#include "raster/gl_target.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>

#include <cstdlib>

#include <rakelight/base/error.h>

namespace rakelight::bench {
namespace {

[[noreturn]] void fail(const char* what) {
    throw Error(ErrorCode::failed, std::string(what) + ", EGL error " + std::to_string(eglGetError()));
}

std::string text(GLenum name) { return reinterpret_cast<const char*>(glGetString(name)); }

void attach(GLenum where, GLenum format, int width, int height, int samples) {
    GLuint buffer = 0;
    glGenRenderbuffers(1, &buffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    if (samples > 1)
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
    else
        glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, where, GL_RENDERBUFFER, buffer);
}

}  // namespace

GlContext::GlContext() {
    ::setenv("LIBGL_ALWAYS_SOFTWARE", "1", 0);
    display_ = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display_ == EGL_NO_DISPLAY || !eglInitialize(display_, nullptr, nullptr)) fail("no surfaceless EGL display");
    if (!eglBindAPI(EGL_OPENGL_API)) fail("EGL has no OpenGL");
    const EGLint wanted[] = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
    if (context_ == EGL_NO_CONTEXT) fail("no OpenGL 3.3 context");
    make_current();
}

void GlContext::make_current() const {
    if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) fail("the OpenGL context cannot be used");
}

GlContext::~GlContext() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);  // the display is the process's
}

std::string GlContext::renderer() const { return text(GL_RENDERER); }
std::string GlContext::version() const { return text(GL_VERSION); }

void GlContext::finish() { glFinish(); }

unsigned GlTarget::make(int samples, bool with_depth) const {
    GLuint frame = 0;
    glGenFramebuffers(1, &frame);
    glBindFramebuffer(GL_FRAMEBUFFER, frame);
    attach(GL_COLOR_ATTACHMENT0, GL_SRGB8_ALPHA8, width_, height_, samples);
    if (with_depth) attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, width_, height_, samples);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Error(ErrorCode::failed, "OpenGL cannot draw pictures of this size");
    return frame;
}

GlTarget::GlTarget(int width, int height, int samples)
    : width_(width),
      height_(height),
      samples_(samples),
      drawn_(make(samples, true)),
      resolved_(samples > 1 ? make(1, false) : drawn_) {}

void GlTarget::begin() const {
    glBindFramebuffer(GL_FRAMEBUFFER, drawn_);
    glViewport(0, 0, width_, height_);
    glEnable(GL_FRAMEBUFFER_SRGB);
    glClearColor(0.18f, 0.18f, 0.2f, 1);  // RenderSettings::background, linear
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void GlTarget::resolve() const {
    if (samples_ <= 1) return;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_);
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

Pixels GlTarget::read() const {
    Pixels pixels;
    pixels.width = width_;
    pixels.height = height_;
    pixels.channels = 3;
    pixels.bytes.resize(pixels.row_bytes() * std::size_t(height_));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, pixels.bytes.data());
    return pixels;
}

}  // namespace rakelight::bench
