// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/window_view.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <future>
#include <map>
#include <optional>
#include <utility>

#include <rakelight/error.h>

#include "engines/opengl/renderer.h"
#include "math/functions.h"

namespace rakelight::opengl {
namespace {

constexpr int shows_codes = -1;

/// A corner of a line's quadrangle, as lines_main.glsl reads it.
struct LineVertex {
    float place[4], color[4], line[2];
};

/// Cut at the near plane. False: nothing is left.
bool keep_before(dvec4& a, dvec4& b, double least_w) {
    if (a.w < least_w && b.w < least_w) return false;
    if (a.w >= least_w && b.w >= least_w) return true;
    const double t = (least_w - a.w) / (b.w - a.w);
    const dvec4 cut = a + (b - a) * t;
    (a.w < least_w ? a : b) = cut;
    return true;
}

void add_line(const Line& line, const dmat4& to_clip, double least_w, int width, int height,
              std::vector<LineVertex>& to) {
    dvec4 a = to_clip * dvec4{line.from.x, line.from.y, line.from.z, 1},
          b = to_clip * dvec4{line.to.x, line.to.y, line.to.z, 1};
    if (!keep_before(a, b, least_w)) return;
    const dvec3 p{a.x / a.w, a.y / a.w, a.z / a.w}, q{b.x / b.w, b.y / b.w, b.z / b.w};
    dvec2 along{(q.x - p.x) * width * 0.5, (q.y - p.y) * height * 0.5};
    const double length = std::sqrt(dot(along, along));
    if (!std::isfinite(length)) return;
    along = length > 1e-9 ? along * (1 / length) : dvec2{1, 0};
    const double half = std::max(0.5 * double(line.width_px), 0.5), reach = half + 1;
    const dvec2 aside{-along.y * reach * 2 / width, along.x * reach * 2 / height};
    const auto corner = [&](const dvec3& end, double side) {
        return LineVertex{
            {float(end.x + aside.x * side), float(end.y + aside.y * side), float(end.z), float(reach * side)},
            {line.color.x, line.color.y, line.color.z, line.color.w},
            {float(half), line.is_overlay ? 1.0f : 0.0f}};
    };
    const LineVertex quad[4] = {corner(p, -1), corner(p, 1), corner(q, -1), corner(q, 1)};
    for (const int k : {0, 1, 2, 2, 1, 3}) to.push_back(quad[k]);
}

/// What of the caller's is bound: pictures end there.
struct Screen {
    GLint frame = 0, viewport[4]{};

    static Screen current() {
        Screen s;
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &s.frame);
        glGetIntegerv(GL_VIEWPORT, s.viewport);
        return s;
    }
    /// With what this library takes for granted of a context, whatever the caller set before.
    static Screen with_own_state(bool is_es) {
        for (const GLenum what :
             {GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_DEPTH_TEST, GL_CULL_FACE, GL_BLEND, GL_RASTERIZER_DISCARD,
              GL_POLYGON_OFFSET_FILL, GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_COVERAGE})
            glDisable(what);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glDepthMask(GL_TRUE);
        glBlendEquation(GL_FUNC_ADD);
        for (const GLenum what : {GL_PIXEL_PACK_BUFFER, GL_PIXEL_UNPACK_BUFFER}) glBindBuffer(what, 0);
        for (const GLenum what : {GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_PACK_ROW_LENGTH,
                                  GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS})
            glPixelStorei(what, 0);
        if (!is_es) {
            glDisable(GL_FRAMEBUFFER_SRGB);
            glDisable(GL_COLOR_LOGIC_OP);
            glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
        }
        return current();
    }
    void bind() const {
        glBindFramebuffer(GL_FRAMEBUFFER, GLuint(frame));
        glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
    }
};

}  // namespace

struct WindowView::State {
    struct Incoming;
    Renderer renderer;
    std::unique_ptr<Incoming> incoming;
    Target target;
    GlTexture picture;
    GlVertexArray no_arrays, line_array;
    GlBuffer line_vertices;
    std::map<int, GlProgram> display_programs;  ///< by tone curve
    GlProgram line_program;
    RenderStats stats;       ///< of the last picture, without what the GPU knows
    bool has_depth = false;  ///< `target` holds the depth of what is on the screen

    const Driver& driver() const { return renderer.driver(); }
    void give_up_incoming();
    void draw_display(const Screen& screen, GLuint picture_name, int tone, float gain);
};

EngineAbilities WindowView::abilities() const { return abilities_of(state_->driver()); }
double WindowView::aspect() const {
    const Screen screen = Screen::current();
    return double(std::max(screen.viewport[2], 1)) / double(std::max(screen.viewport[3], 1));
}
std::string WindowView::renderer() const { return state_->driver().renderer; }
bool WindowView::has_gpu() const { return !state_->driver().is_software; }

/// A scene on its way: first on a thread, then to the GPU.
struct WindowView::State::Incoming {
    Incoming(const Scene& scene, std::uint64_t its_number, const Renderer& renderer, const Context& context)
        : number(its_number),
          own({.threads = context.threads()}),
          taken(std::async(std::launch::async, [this, scene = Scene(scene), cache = renderer.decoded(),
                                                environments = renderer.decoded_environment()]() mutable {
              return take_scene(std::move(scene), std::move(cache), std::move(environments), own);
          })) {}
    ~Incoming() { own.cancel(); }

    std::uint64_t number;
    Context own;
    std::future<TakenScene> taken;  ///< ends with its thread
    std::optional<TakenScene> ready;
};

WindowView::WindowView() : state_(std::make_unique<State>()) {}
WindowView::~WindowView() = default;

bool WindowView::upload(const Scene& scene, std::uint64_t number, double milliseconds, Context& context) {
    State& s = *state_;
    const Clock::time_point end =
        Clock::now() + std::chrono::microseconds(std::int64_t(1e3 * std::max(milliseconds, 0.0)));
    if (!s.incoming || s.incoming->number != number) {
        s.give_up_incoming();
        s.incoming = std::make_unique<State::Incoming>(scene, number, s.renderer, context);
    }
    State::Incoming& incoming = *s.incoming;
    if (!incoming.ready) {
        if (incoming.taken.wait_until(end) != std::future_status::ready) return false;
        try {
            incoming.ready = incoming.taken.get();
        } catch (...) {
            s.give_up_incoming();  // asked for again, it begins again
            throw;
        }
        for (const ReportEntry& e : incoming.own.report().entries())
            context.report().add(e.remark, e.file, e.place, e.message, e.settings);
    }
    Screen::with_own_state(s.driver().is_es);
    try {
        if (!s.renderer.upload(*incoming.ready, end, context)) return false;
        s.renderer.take(std::move(*incoming.ready), context);
    } catch (...) {
        s.give_up_incoming();
        throw;
    }
    s.incoming.reset();
    return true;
}

void WindowView::State::give_up_incoming() {
    if (!std::exchange(incoming, nullptr)) return;
    renderer.forget_uploads();
}

void WindowView::set_lights(std::vector<Light> lights) { state_->renderer.set_lights(std::move(lights)); }

void WindowView::State::draw_display(const Screen& screen, GLuint picture_name, int tone, float gain) {
    GlProgram& program = display_programs[tone];
    if (!program) program = link_program(display_text(driver(), tone));
    screen.bind();
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glUseProgram(program.name());
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, picture_name);
    glBindSampler(0, 0);
    const auto place = [&](const char* name) { return glGetUniformLocation(program.name(), name); };
    glUniform1i(place("rl_picture"), 0);
    glUniform4f(place("rl_show"), float(screen.viewport[0]), float(screen.viewport[1]),
                1.0f / float(screen.viewport[2]), 1.0f / float(screen.viewport[3]));
    glUniform1f(place("rl_gain"), gain);
    glBindVertexArray(no_arrays.get());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    if (driver().has_reversed_depth) glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    check_gl("the window");
}

RenderStats WindowView::draw(const Camera& camera, const RenderSettings& settings, const ToneSettings& tone,
                             Context& context) {
    State& s = *state_;
    const Screen screen = Screen::with_own_state(s.driver().is_es);
    RenderStats stats;
    if (std::max(settings.width, settings.height) > s.driver().picture_size)
        throw Error(ErrorCode::failed,
                    "this OpenGL driver draws at most " + std::to_string(s.driver().picture_size) + " pixels a side");
    // Of the picture before: what is asked of this one would have to be waited for.
    s.renderer.end_picture(s.stats, context);
    stats.gpu_passes = std::move(s.stats.gpu_passes);
    s.stats = {};
    s.renderer.begin_picture(camera, settings, stats, context);
    s.target.reserve(settings.width, settings.height, settings.samples);
    s.renderer.draw_part({0, 0, settings.width, settings.height}, s.target, context);
    s.has_depth = true;
    s.draw_display(screen, s.target.texture(), int(tone.mapping), float(math::exp2(tone.exposure_ev)));
    return stats;
}

void WindowView::show(int width, int height, std::span<const std::uint32_t> srgb8, bool smooth) {
    if (width <= 0 || height <= 0 || srgb8.size() != std::size_t(width) * std::size_t(height))
        throw Error(ErrorCode::usage, "a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                                          " pixels does not have " + std::to_string(srgb8.size()) + " of them");
    State& s = *state_;
    const Screen screen = Screen::with_own_state(s.driver().is_es);
    s.has_depth = false;
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, s.picture.get());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, srgb8.data());
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D, filter, smooth ? GL_LINEAR : GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    s.draw_display(screen, s.picture.name(), shows_codes, 1);
}

bool WindowView::show_again() {
    State& s = *state_;
    if (!s.picture) return false;
    const Screen screen = Screen::with_own_state(s.driver().is_es);
    s.has_depth = false;
    s.draw_display(screen, s.picture.name(), shows_codes, 1);
    return true;
}

void WindowView::lines(const Camera& camera, std::span<const Line> lines) {
    State& s = *state_;
    const Screen screen = Screen::with_own_state(s.driver().is_es);
    const int width = screen.viewport[2], height = screen.viewport[3];
    if (lines.empty() || width <= 0 || height <= 0) return;
    RenderSettings settings;
    settings.width = width, settings.height = height;
    const shading::View view = s.renderer.view_of(camera, settings);
    const DepthRange::Row nearness = DepthRange::nearness(view);
    const dmat4 to_clip = clip_matrix(view, {0, 0, width, height}, nearness, 1) * view.world_to_camera;
    std::vector<LineVertex> vertices;
    for (const Line& line : lines)
        add_line(line, to_clip, view.orthographic ? 0.5 : view.z_near, width, height, vertices);
    if (vertices.empty()) return;
    if (!s.line_program) s.line_program = link_program(line_text(s.driver()));
    screen.bind();
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glUseProgram(s.line_program.name());
    const bool hides = s.has_depth && s.target.width() == width && s.target.height() == height;
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, hides ? s.target.depth_texture() : 0);
    glBindSampler(0, 0);
    const auto place = [&](const char* name) { return glGetUniformLocation(s.line_program.name(), name); };
    glUniform1i(place("rl_depth"), 0);
    glUniform4f(place("rl_show"), float(screen.viewport[0]), float(screen.viewport[1]), hides ? 1.0f : 0.0f,
                float(height));
    glUniform1f(place("rl_show_scale"), view.orthographic ? 0.0f : float(nearness.scale));
    glBindVertexArray(s.line_array.get());
    glBindBuffer(GL_ARRAY_BUFFER, s.line_vertices.get());
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertices.size() * sizeof(LineVertex)), vertices.data(), GL_STREAM_DRAW);
    const auto attribute = [](GLuint at, GLint components, std::size_t offset) {
        glEnableVertexAttribArray(at);
        glVertexAttribPointer(at, components, GL_FLOAT, GL_FALSE, sizeof(LineVertex),
                              reinterpret_cast<const void*>(offset));
    };
    attribute(0, 4, offsetof(LineVertex, place));
    attribute(1, 4, offsetof(LineVertex, color));
    attribute(2, 2, offsetof(LineVertex, line));
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(vertices.size()));
    glDisable(GL_BLEND);
    check_gl("lines");
}

}  // namespace rakelight::opengl
