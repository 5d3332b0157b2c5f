// SPDX-License-Identifier: Apache-2.0
// What many tests of the soft engine do: draw a scene, look at a pixel, compare pictures to the bit.
#pragma once
#include <cstring>

#include "engines/raster/raster_engine.h"
#include "support/scene_builder.h"

namespace rakelight::test {

inline Frame draw(const Scene& scene, const Camera& camera, const RenderSettings& settings, int threads = 1,
                  RenderStats* stats = nullptr) {
    Context context({.threads = threads});
    auto engine = raster::make_engine();
    engine->prepare(scene, context);
    Frame frame;
    const RenderStats counted = engine->render(camera, settings, frame, context);
    if (stats) *stats = counted;
    return frame;
}

/// From the window's corner.
inline vec4 pixel(const Frame& f, int x, int y) { return f.color[std::size_t(y * f.window.width + x)]; }

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}
/// The colors alone.
inline bool same_bits(const Frame& a, const Frame& b) { return same_bits(a.color, b.color); }

inline std::uint32_t add_unlit(Scene& scene, vec4 color, AlphaMode mode = AlphaMode::opaque, bool double_sided = true) {
    Material m;
    m.model = MaterialModel::unlit;
    m.base_color = color;
    m.alpha_mode = mode;
    m.double_sided = double_sided;
    scene.materials.push_back(m);
    return std::uint32_t(scene.materials.size() - 1);
}

}  // namespace rakelight::test
