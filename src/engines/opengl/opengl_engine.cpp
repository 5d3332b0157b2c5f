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

Window whole(const RenderSettings& s) {
    return s.window == Window{} ? Window{0, 0, s.width, s.height} : s.window;
}

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

    std::string name() const override { return "gl"; }
    EngineAbilities abilities() const override {
        EngineAbilities can;
        can.channels = channels_all;
        if (renderer_->driver().samples >= 4) can.samples.push_back(4);
        if (renderer_->driver().samples >= 8) can.samples.push_back(8);
        can.screen_interpolation = !renderer_->driver().is_es;
        can.shadows = true;
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
        renderer_->begin_picture(camera, settings, stats, context);
        sink.begin(settings.width, settings.height, window, settings.channels);
        auto* const strips = dynamic_cast<StripSink*>(&sink);
        const int at_once = strips && strips->rows_at_once() > 0 ? strips->rows_at_once() : window.height;
        const int rows = std::min({at_once, most_rows, renderer_->driver().picture_size});
        for (int y = 0; y < window.height; y += rows) {
            const int height = std::min(rows, window.height - y);
            for (int x = 0; x < window.width; x += renderer_->driver().picture_size) {
                const int width = std::min(window.width - x, renderer_->driver().picture_size);
                stats.pixels_not_finite += deliver({window.x + x, window.y + y, width, height}, sink, context);
            }
            if (strips) strips->rows_done(window.y + y, height);
            context.progress("render", double(y + height) / double(window.height));
        }
        sink.end_pass(0);
        if (stats.pixels_not_finite > 0)
            context.report().add(Remark::warning, renderer_->scene().source, {},
                                 std::to_string(stats.pixels_not_finite) + " color values came out not finite and are shown black");
        return stats;
    }

    std::uint64_t deliver(Window pixels, Sink& sink, Context& context) {
        colors_.resize(std::size_t(pixels.width) * std::size_t(pixels.height));
        const std::uint64_t not_finite = renderer_->draw_and_read(pixels, colors_, context);
        Tile tile{.area = pixels};
        tile.color = colors_;
        if (const std::uint32_t channels = renderer_->channels(); channels != 0) {
            renderer_->draw_channels(pixels, arrays_, context);
            for_each_channel([&](std::uint32_t bit, auto& to, const auto& array) { if (channels & bit) to = array; }, tile,
                             static_cast<const ChannelArrays&>(arrays_));
        }
        sink.tile(tile);
        return not_finite;
    }

    std::optional<HeadlessContext> context_;
    std::optional<Renderer> renderer_;
    std::vector<vec4> colors_;
    ChannelArrays arrays_;
    GlThread thread_;
};

}  // namespace

std::unique_ptr<Engine> make_engine() { return std::make_unique<OpenGlEngine>(); }

}  // namespace rakelight::opengl
