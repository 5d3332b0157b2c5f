// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/opengl_engine.h"
#include "engines/posed_arrays.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>
#include <vector>

#include "engines/channel_arrays.h"
#include "engines/opengl/context/gl_thread.h"
#include "engines/opengl/context/headless.h"
#include "engines/opengl/renderer.h"

namespace rakelight::opengl {
namespace {

constexpr int pixels_at_once = 4 << 20;  ///< that are drawn and read, where it is not fewer than
constexpr int fewest_rows = 64;          ///< any strip of a sink has room for them

Window whole(const RenderSettings& s) { return s.window == Window{} ? Window{0, 0, s.width, s.height} : s.window; }

class OpenGlEngine final : public Engine {
public:
    OpenGlEngine() {
        thread_.call([this] {
            context_.emplace();
            try {
                renderer_.emplace();
            } catch (...) {
                context_.reset();  // on its thread
                throw;
            }
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
    EngineCapabilities capabilities() const override { return abilities_of(driver()); }
    void prepare(Scene scene, Context& context) override { prepare_unposed(std::move(scene), nullptr, context); }
    bool poses_vertices() const override { return true; }
    void prepare_unposed(Scene scene, std::shared_ptr<const geometry::MeshPoses> poses, Context& context) override {
        thread_.call([&] { renderer_->prepare({std::move(scene), std::move(poses)}, context); });
    }
    const Scene& scene() const override { return renderer_->scene(); }
    void set_lights(std::vector<Light> lights) override {
        thread_.call([&] { renderer_->set_lights(std::move(lights)); });
    }
    RenderStats render(const Camera& camera, const RenderSettings& settings, Sink& sink, Context& context) override {
        RenderStats stats;
        const Window window = whole(settings);
        const std::vector<Window> parts = parts_of(window, driver().picture_size);
        thread_.call([&] {
            renderer_->begin_picture(camera, settings, stats, context);
            renderer_->draw_part(parts[0], context);  // shaders and memory fail before the sink gets anything
        });
        sink.begin(settings.width, settings.height, window, settings.channels);
        for (const Window& part : parts) {
            thread_.call([&] {
                if (&part != &parts[0]) renderer_->draw_part(part, context);
                read(part, context);
            });
            renderer_->remark_order(context.report());
            deliver(part, window, sink);
            context.progress("render", double(part.y - window.y + part.height) / double(window.height));
        }
        sink.end_pass(0);
        thread_.call([&] { renderer_->end_picture(stats, context); });
        return stats;
    }
    std::vector<std::array<vec4, 4>> user_terms(int x, int y, Context& context) {
        std::vector<std::array<vec4, 4>> terms;
        thread_.call([&] { terms = renderer_->user_terms(x, y, context); });
        return terms;
    }

private:
    /// What is drawn and read at once, from the top.
    static std::vector<Window> parts_of(const Window& window, int most) {
        const int rows =
            window.width > most ? fewest_rows : std::clamp(int(pixels_at_once / window.width), fewest_rows, most);
        std::vector<Window> parts;
        for (int y = 0; y < window.height; y += rows)
            for (int x = 0; x < window.width; x += most)
                parts.push_back(
                    {window.x + x, window.y + y, std::min(window.width - x, most), std::min(window.height - y, rows)});
        return parts;
    }

    void read(const Window& part, Context& context) {
        colors_.resize(std::size_t(part.width) * std::size_t(part.height));
        renderer_->read_part(colors_);
        if (renderer_->channels() != 0) renderer_->draw_channels(part, arrays_, context);
    }

    /// In strips of as many rows as the sink takes.
    void deliver(const Window& part, const Window& window, Sink& sink) {
        const int most = sink.rows_at_once() > 0 ? sink.rows_at_once() : part.height;
        for (int row = 0; row < part.height; row += most) {
            const int rows = std::min(most, part.height - row);
            sink.tile(tile_of(part, row, rows));
            const bool ends_row = part.x + part.width == window.x + window.width;
            if (ends_row) sink.rows_done(part.y + row, rows);
        }
    }

    Tile tile_of(const Window& part, int row, int rows) const {
        const std::size_t first = std::size_t(row) * std::size_t(part.width),
                          count = std::size_t(rows) * std::size_t(part.width);
        Tile tile{.area = {part.x, part.y + row, part.width, rows}};
        tile.color = std::span(colors_).subspan(first, count);
        const std::uint32_t channels = renderer_->channels();
        for_each_channel(
            [&](std::uint32_t bit, auto& to, const auto& array) {
                if (channels & bit) to = std::span(array).subspan(first, count);
            },
            tile, arrays_);
        return tile;
    }

    std::optional<HeadlessContext> context_;
    std::optional<Renderer> renderer_;
    std::vector<vec4> colors_;
    ChannelArrays arrays_;
    GlThread thread_;
};

}  // namespace

std::unique_ptr<Engine> make_engine() { return std::make_unique<OpenGlEngine>(); }

std::vector<std::array<vec4, 4>> user_terms(Engine& engine, int x, int y, Context& context) {
    return dynamic_cast<OpenGlEngine&>(engine).user_terms(x, y, context);
}

std::unique_ptr<Engine> make_gpu_engine(std::string& why) {
    try {
        auto engine = std::make_unique<OpenGlEngine>();
        if (!engine->driver().is_software) return engine;
        why = "there is no GPU (" + engine->driver().renderer + " draws on the processor)";
    } catch (const Error& error) {
        why = error.reason();
    }
    return nullptr;
}

}  // namespace rakelight::opengl
