// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/opengl_engine.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>
#include <vector>

#include <rakelight/tools/strip_sink.h>

#include "engines/channel_arrays.h"
#include "engines/opengl/gl_thread.h"
#include "engines/opengl/headless.h"
#include "engines/opengl/renderer.h"

namespace rakelight::opengl {
namespace {

constexpr int most_rows = 2048;  ///< of a strip that is drawn and read at once

Window whole(const RenderSettings& s) { return s.window == Window{} ? Window{0, 0, s.width, s.height} : s.window; }

class OpenGlEngine final : public Engine {
public:
    OpenGlEngine() {
        thread_.call([this] {
            context_.emplace();
            renderer_.emplace();
        });
    }
    ~OpenGlEngine() override {
        thread_.call([this] {
            renderer_.reset();
            context_.reset();
        });
    }

    const Driver& driver() const { return renderer_->driver(); }

    std::string name() const override { return "gl"; }
    EngineAbilities abilities() const override {
        EngineAbilities can;
        can.channels = channels_all;
        if (driver().samples >= 4) can.samples.push_back(4);
        if (driver().samples >= 8) can.samples.push_back(8);
        can.screen_interpolation = !driver().is_es;
        can.shadows = true;
        can.user_lighting = true;
        can.lines_and_points = true;
        return can;
    }
    void prepare(Scene scene, Context& context) override {
        thread_.call([&] { renderer_->prepare(std::move(scene), context); });
    }
    const Scene& scene() const override { return renderer_->scene(); }
    void set_lights(std::vector<Light> lights) override {
        thread_.call([&] { renderer_->set_lights(std::move(lights)); });
    }
    RenderStats render(const Camera& camera, const RenderSettings& settings, Sink& sink, Context& context) override {
        RenderStats stats;
        thread_.call([&] { stats = draw(camera, settings, sink, context); });
        return stats;
    }

private:
    RenderStats draw(const Camera& camera, const RenderSettings& settings, Sink& sink, Context& context) {
        RenderStats stats;
        const Window window = whole(settings);
        const int most = driver().picture_size;
        renderer_->begin_picture(camera, settings, stats, context);
        Window drawn{window.x, window.y, std::min(window.width, most), std::min({window.height, most, most_rows})};
        renderer_->draw_part(drawn,
                             context);  // what fails, a shader or the GPU's memory, fails before the sink gets anything
        sink.begin(settings.width, settings.height, window, settings.channels);
        auto* const strips = dynamic_cast<StripSink*>(&sink);
        const int at_once = strips && strips->rows_at_once() > 0 ? strips->rows_at_once() : window.height;
        const int rows = std::min(at_once, drawn.height);
        for (int y = 0; y < window.height; y += rows) {
            const int height = std::min(rows, window.height - y);
            for (int x = 0; x < window.width; x += most) {
                const Window part{window.x + x, window.y + y, std::min(window.width - x, most), height};
                if (part != drawn) renderer_->draw_part(part, context);
                drawn = {};
                deliver(part, sink, context);
            }
            if (strips) strips->rows_done(window.y + y, height);
            context.progress("render", double(y + height) / double(window.height));
        }
        sink.end_pass(0);
        renderer_->end_picture(stats, context);
        return stats;
    }

    void deliver(Window part, Sink& sink, Context& context) {
        const std::size_t pixels = std::size_t(part.width) * std::size_t(part.height);
        colors_.resize(pixels);
        renderer_->read_part(colors_);
        Tile tile{.area = part};
        tile.color = colors_;
        const std::uint32_t channels = renderer_->channels();
        if (channels != 0) {
            renderer_->draw_channels(part, arrays_, context);
            for_each_channel(
                [&](std::uint32_t bit, auto& to, const auto& array) {
                    if (channels & bit) to = array;
                },
                tile, static_cast<const ChannelArrays&>(arrays_));
        }
        sink.tile(tile);
    }

    std::optional<HeadlessContext> context_;
    std::optional<Renderer> renderer_;
    std::vector<vec4> colors_;
    ChannelArrays arrays_;
    GlThread thread_;
};

}  // namespace

std::unique_ptr<Engine> make_engine() { return std::make_unique<OpenGlEngine>(); }

std::unique_ptr<Engine> make_gpu_engine(std::string& why) {
    try {
        auto engine = std::make_unique<OpenGlEngine>();
        if (!engine->driver().is_software) return engine;
        why = "there is no GPU (" + engine->driver().renderer + " draws by the processor)";
    } catch (const Error& error) {
        why = error.reason();
    }
    return nullptr;
}

}  // namespace rakelight::opengl
