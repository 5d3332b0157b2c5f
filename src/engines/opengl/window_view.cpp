// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/window_view.h"

#include <algorithm>
#include <chrono>
#include <future>
#include <map>
#include <optional>
#include <utility>

#include <rakelight/base/error.h>

#include "base/apart.h"
#include "base/format_text.h"
#include "engines/opengl/picture/line_pass.h"
#include "engines/opengl/picture/screen.h"
#include "engines/opengl/renderer.h"
#include "math/functions.h"

namespace rakelight::opengl {
namespace {

constexpr int shows_codes = -1;

}  // namespace

struct WindowView::State {
    struct Incoming;
    Renderer renderer;
    std::unique_ptr<Incoming> incoming;
    Target target;
    GlTexture picture;
    GlVertexArray no_arrays;
    std::map<int, GlProgram> display_programs;  ///< by tone curve
    LinePass lines;
    RenderStats stats;       ///< of the last picture, without what the GPU knows
    bool has_depth = false;  ///< `target` holds the depth of what is on the screen

    const Driver& driver() const { return renderer.driver(); }
    void give_up_incoming();
    void draw_display(const Screen& screen, GLuint picture_name, int tone, float gain, vec4 behind = {});
};

EngineCapabilities WindowView::capabilities() const { return abilities_of(state_->driver()); }
double WindowView::aspect() const {
    const Screen screen = Screen::current();
    return double(std::max(screen.viewport[2], 1)) / double(std::max(screen.viewport[3], 1));
}
std::string WindowView::renderer() const { return state_->driver().renderer; }
bool WindowView::has_gpu() const { return !state_->driver().is_software; }

/// A scene on its way: first on a thread, then to the GPU.
struct WindowView::State::Incoming {
    Incoming(GivenScene given, std::uint64_t its_number, const Renderer& renderer, const Context& context)
        : number(its_number),
          own({.threads = context.threads()}),
          taken(start_apart([this, given = std::move(given), cache = renderer.decoded(),
                             poses_here = !renderer.driver().poses_meshes,
                             environments = renderer.decoded_environment()]() mutable {
              return take_scene(std::move(given), poses_here, std::move(cache), std::move(environments), own);
          })) {}
    ~Incoming() { own.cancel(); }

    std::uint64_t number;
    Context own;
    std::future<TakenScene> taken;  ///< ends with its thread
    std::optional<TakenScene> ready;
};

WindowView::WindowView() : state_(std::make_unique<State>()) {}
WindowView::~WindowView() = default;

bool WindowView::upload(const Scene& scene, const std::shared_ptr<const geometry::MeshPoses>& poses,
                        std::uint64_t number, double milliseconds, Context& context) {
    State& s = *state_;
    const Clock::time_point end =
        Clock::now() + std::chrono::microseconds(std::int64_t(1e3 * std::max(milliseconds, 0.0)));
    if (!s.incoming || s.incoming->number != number) {
        s.give_up_incoming();
        s.incoming = std::make_unique<State::Incoming>(GivenScene{scene, poses}, number, s.renderer, context);
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

/// @param behind  linear; what lies behind the picture
void WindowView::State::draw_display(const Screen& screen, GLuint picture_name, int tone, float gain, vec4 behind) {
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
    glUniform4f(place("rl_behind"), behind.x, behind.y, behind.z, behind.w);
    glBindVertexArray(no_arrays.get());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    if (driver().has_reversed_depth) glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    check_gl("the window");
}

RenderStats WindowView::draw(const Camera& camera, const RenderSettings& settings, const ToneSettings& tone,
                             vec4 behind, Context& context) {
    State& s = *state_;
    const Screen screen = Screen::with_own_state(s.driver().is_es);
    RenderStats stats;
    if (std::max(settings.width, settings.height) > s.driver().picture_size)
        throw Error(ErrorCode::failed,
                    format_text("this OpenGL driver draws at most {} pixels per side", s.driver().picture_size));
    // Of the picture before: what is asked of this one would have to be waited for.
    s.renderer.end_picture(s.stats, context);
    stats.gpu_passes = std::move(s.stats.gpu_passes);
    s.stats = {};
    s.renderer.begin_picture(camera, settings, stats, context);
    s.target.reserve(settings.width, settings.height, settings.samples);
    s.renderer.draw_part({0, 0, settings.width, settings.height}, s.target, context);
    s.has_depth = true;
    s.draw_display(screen, s.target.texture(), int(tone.mapping), float(math::exp2(tone.exposure_ev)), behind);
    return stats;
}

void WindowView::show(int width, int height, std::span<const std::uint32_t> srgb8, bool smooth) {
    if (width <= 0 || height <= 0 || srgb8.size() != std::size_t(width) * std::size_t(height))
        throw Error(ErrorCode::usage,
                    format_text("a picture of {} x {} pixels does not have {} of them", width, height, srgb8.size()));
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
    if (lines.empty() || screen.width() <= 0 || screen.height() <= 0) return;
    RenderSettings settings;
    settings.width = screen.width(), settings.height = screen.height();
    const bool hides = s.has_depth && s.target.width() == settings.width && s.target.height() == settings.height;
    s.lines.draw(lines, s.renderer.picture_camera_of(camera, settings), screen, hides ? s.target.depth_texture() : 0,
                 s.driver());
}

}  // namespace rakelight::opengl
