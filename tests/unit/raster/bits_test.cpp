// SPDX-License-Identifier: Apache-2.0
// One scene, one picture, to the bit: whatever the threads, the instruction set, the windows that it is drawn in and
// their order. tests/acceptance/acceptance.py (bits) holds the program to the same, under qemu too.
#include <gtest/gtest.h>

#include <string>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <random>

#include "engines/raster/raster_engine.h"
#include "math/isa.h"
#include "support/scene_builder.h"
#include "unit/raster/busy_scene.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

constexpr int width = 230, height = 150;  // parts of tiles at the right and at the bottom
constexpr std::uint32_t all_channels = channel_depth | channel_normal | channel_object | channel_material;

RenderSettings settings_for(Shading shading) {
    return {.width = width,
            .height = height,
            .channels = all_channels,
            .shading = shading,
            .background = {0.1f, 0.2f, 0.3f, 0.5f}};
}

/// FNV-1a, 64 bits.
template <class T>
std::uint64_t hash(const std::vector<T>& values, std::uint64_t h) {
    std::vector<unsigned char> bytes(values.size() * sizeof(T));
    if (!bytes.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
    for (const unsigned char b : bytes) h = (h ^ b) * 1099511628211u;
    return h;
}
std::uint64_t hash(const Frame& f) {
    return hash(f.material, hash(f.object, hash(f.normal, hash(f.depth, hash(f.color, 14695981039346656037u)))));
}

std::uint64_t hash_of(const Scene& scene, const RenderSettings& settings, int threads) {
    Context context({.threads = threads});
    const auto engine = raster::make_engine();
    engine->prepare(scene, context);
    Frame frame;
    engine->render(busy_view(), settings, frame, context);
    return hash(frame);
}

struct IsaGuard {
    explicit IsaGuard(Isa isa) { setenv("RAKELIGHT_ISA", name(isa), 1); }
    ~IsaGuard() { unsetenv("RAKELIGHT_ISA"); }
};

/// The picture cut in two at a random place, and the halves again, in random order.
std::vector<Window> random_windows(std::mt19937& random) {
    std::vector<Window> windows = {{0, 0, width, height}};
    for (int cut = 0; cut < 9; ++cut) {
        const std::size_t i = random() % windows.size();
        Window a = windows[i], b = a;
        const bool across = a.width > a.height;
        if ((across ? a.width : a.height) < 2) continue;
        const int at = 1 + int(random() % unsigned((across ? a.width : a.height) - 1));
        if (across)
            a.width = at, b.x += at, b.width -= at;
        else
            a.height = at, b.y += at, b.height -= at;
        windows[i] = a;
        windows.push_back(b);
    }
    std::shuffle(windows.begin(), windows.end(), random);
    return windows;
}

template <class T>
void put(std::vector<T>& whole, const std::vector<T>& part, const Window& w) {
    whole.resize(std::size_t(width) * height);
    for (int y = 0; y < w.height; ++y)
        std::copy_n(part.begin() + std::ptrdiff_t(y) * w.width, w.width,
                    whole.begin() + std::ptrdiff_t(w.y + y) * width + w.x);
}

/// The picture of one thread and no vectors, from any number of threads and every instruction set.
void expect_same_everywhere(const Scene& scene, const RenderSettings& settings, const std::string& what) {
    const std::uint64_t expected = [&] {
        const IsaGuard guard(Isa::scalar);
        return hash_of(scene, settings, 1);
    }();
    for (const Isa isa : {Isa::scalar, Isa::sse2, Isa::avx2, Isa::avx512}) {
        if (!is_available(isa)) continue;
        const IsaGuard guard(isa);
        for (const int threads : {1, 2, 4})
            EXPECT_EQ(hash_of(scene, settings, threads), expected)
                << name(isa) << ", " << threads << " threads, " << what;
    }
}

}  // namespace

TEST(Bits, AreThoseOfOneThreadAndNoVectorsForAnyThreadsAndInstructionSet) {
    const Scene scene = busy_scene();
    for (const Shading shading : {Shading::unlit, Shading::flat, Shading::gouraud, Shading::phong})
        for (const Visibility visibility : {Visibility::z_reversed, Visibility::z24, Visibility::painter}) {
            RenderSettings settings = settings_for(shading);
            settings.visibility = visibility;
            expect_same_everywhere(
                scene, settings,
                "shading " + std::to_string(int(shading)) + ", visibility " + std::to_string(int(visibility)));
        }
}

TEST(Bits, OfMultisampledPicturesAreThoseOfOneThreadAndNoVectorsToo) {
    const Scene scene = busy_scene();
    for (const int samples : {4, 8})
        for (const bool edges : {false, true}) {
            RenderSettings settings = settings_for(Shading::phong);
            settings.samples = samples;
            settings.edges = edges;
            expect_same_everywhere(scene, settings, std::to_string(samples) + " samples");
        }
}

/// Tiles lie on the picture's own grid, so a window draws parts of them: cut anywhere, drawn in any order by one engine
/// that keeps its memory from window to window.
TEST(Bits, OfWindowsInAnyOrderAreThoseOfTheWhole) {
    const Scene scene = busy_scene();
    std::mt19937 random(31);
    Context context({.threads = 2});
    const auto engine = raster::make_engine();
    engine->prepare(scene, context);
    for (const auto& [shading, samples] : {std::pair{Shading::flat, 1},
                                           {Shading::gouraud, 1},
                                           {Shading::phong, 1},
                                           {Shading::phong, 4},
                                           {Shading::gouraud, 8}}) {
        RenderSettings settings = settings_for(shading);
        settings.samples = samples;
        Frame whole;
        engine->render(busy_view(), settings, whole, context);
        for (int round = 0; round < 8; ++round) {
            Frame pieces;
            for (const Window& window : random_windows(random)) {
                settings.window = window;
                Frame part;
                engine->render(busy_view(), settings, part, context);
                put(pieces.color, part.color, window);
                put(pieces.depth, part.depth, window);
                put(pieces.normal, part.normal, window);
                put(pieces.object, part.object, window);
                put(pieces.material, part.material, window);
            }
            settings.window = {};
            EXPECT_EQ(hash(pieces), hash(whole))
                << "round " << round << ", shading " << int(shading) << ", samples " << samples;
        }
    }
}

TEST(Bits, DifferWhereThePictureDoes) {
    Scene scene = busy_scene();
    const std::uint64_t before = hash_of(scene, settings_for(Shading::phong), 1);
    scene.lights[0].diffuse.x += 1e-5f;
    EXPECT_NE(hash_of(scene, settings_for(Shading::phong), 1), before);
}
