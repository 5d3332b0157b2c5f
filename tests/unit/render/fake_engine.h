// SPDX-License-Identifier: Apache-2.0
// An engine for tests of what stands around engines: pixel (x, y) is a known function of its place, tiles are 64 x 64.
#pragma once
#include <rakelight/engines/engine.h>

#include <algorithm>
#include <mutex>
#include <vector>

namespace rakelight::test {

class FakeEngine final : public Engine {
public:
    std::string name() const override { return "fake"; }
    EngineCapabilities capabilities() const override { return can; }
    void set_lights(std::vector<Light> lights) override { prepared.lights = std::move(lights), ++lights_set; }
    void prepare(Scene scene, Context&) override {
        if (fails) throw Error(ErrorCode::failed, "it fails");
        prepared = std::move(scene), ++times_prepared;
    }
    const Scene& scene() const override { return prepared; }

    RenderStats render(const Camera& c, const RenderSettings& s, Sink& sink, Context& context) override {
        camera = c;
        const Window w = s.window.width == 0 ? Window{0, 0, s.width, s.height} : s.window;
        windows.push_back(w);
        sink.begin(s.width, s.height, w, s.channels);
        const int held = sink.rows_at_once(), tiles_x = (w.width + 63) / 64;
        const int at_once = held == 0 ? w.height : held / 64 * 64;
        for (int top = 0; top < w.height; top += at_once) {
            const int rows = std::min(at_once, w.height - top), tiles_y = (rows + 63) / 64;
            context.parallel_for(std::size_t(tiles_x * tiles_y), [&](std::size_t i) {
                const int x = int(i) % tiles_x * 64, y = top + int(i) / tiles_x * 64;
                deliver({w.x + x, w.y + y, std::min(64, w.width - x), std::min(64, w.height - y)}, s, sink);
            });
            strips.push_back(rows);
            sink.rows_done(w.y + top, rows);
        }
        context.progress("render", 1);
        sink.end_pass(0);
        RenderStats stats;
        stats.triangles_in = 7;
        stats.pixels_covered = covered ? std::uint64_t(w.width) * std::uint64_t(w.height) : 0;
        return stats;
    }

    /// Linear color of a pixel: red grows with x, green with y, blue is the sum's last bit.
    static vec4 color_at(int x, int y) {
        return {float(x % 256) / 255.0f, float(y % 256) / 255.0f, float((x + y) % 2), 1};
    }
    static float depth_at(int x, int y) { return float(x) + float(y) * 0.001f; }

    Scene prepared;
    EngineCapabilities can{.channels = channels_all,
                           .samples = {1, 4, 8},
                           .visibility_methods = true,
                           .screen_interpolation = true,
                           .lines_and_points = true,
                           .shadows = true};
    int times_prepared = 0, lights_set = 0;
    Camera camera;
    std::vector<Window> windows;
    std::vector<int> strips;  ///< rows of each
    bool covered = true, fails = false;

private:
    static void deliver(Window area, const RenderSettings& s, Sink& sink) {
        std::vector<vec4> color;
        std::vector<float> depth;
        std::vector<vec3> normal;
        std::vector<std::uint32_t> object;
        for (int y = area.y; y < area.y + area.height; ++y)
            for (int x = area.x; x < area.x + area.width; ++x) {
                color.push_back(color_at(x, y));
                if (s.channels & channel_depth) depth.push_back(depth_at(x, y));
                if (s.channels & channel_normal) normal.push_back({0, 0, 1});
                if (s.channels & channel_object) object.push_back(x == 0 ? no_index : std::uint32_t(y));
            }
        sink.tile(
            {.area = area, .color = color, .depth = depth, .normal = normal, .object = object, .material = object});
    }
};

}  // namespace rakelight::test
