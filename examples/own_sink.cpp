// SPDX-License-Identifier: Apache-2.0
// Tiles into memory of your own, as they are finished: a sink that counts how many pixels show each object, and keeps no picture.
//
//   own_sink [MODEL]      builtin:teapot by default
#include <cstdio>
#include <map>
#include <mutex>

#include <rakelight/rakelight.h>

namespace {

class PixelsOfObjects final : public rakelight::Sink {
public:
    void begin(int, int, rakelight::Window, std::uint32_t) override { pixels_.clear(); }
    void tile(const rakelight::Tile& tile) override {  // from several threads at once
        std::map<std::uint32_t, int> here;
        for (const std::uint32_t object : tile.object) ++here[object];
        const std::lock_guard lock(mutex_);
        for (const auto& [object, count] : here) pixels_[object] += count;
    }
    void end_pass(int) override {}
    const std::map<std::uint32_t, int>& pixels() const { return pixels_; }

private:
    std::mutex mutex_;
    std::map<std::uint32_t, int> pixels_;
};

}  // namespace

int main(int argc, char** argv) {
    try {
        rakelight::Context context;
        const rakelight::Scene scene = rakelight::load(argc > 1 ? argv[1] : "builtin:teapot", {}, context);
        rakelight::RenderSettings settings;
        settings.channels = rakelight::channel_object;
        const double aspect = double(settings.width) / settings.height;
        rakelight::Session session;
        session.set(scene);
        PixelsOfObjects sink;
        session.render(rakelight::choose_camera(scene, {}, aspect, context), settings, sink, context);
        for (const auto& [object, count] : sink.pixels())
            std::printf("%8d pixels: %s\n", count,
                        object == rakelight::no_index ? "(background)" : scene.nodes[object].name.c_str());
        return 0;
    } catch (const rakelight::Error& error) {
        std::fprintf(stderr, "own_sink: %s\n", error.what());
        return 1;
    }
}
