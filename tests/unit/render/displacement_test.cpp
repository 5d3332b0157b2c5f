// SPDX-License-Identifier: Apache-2.0
// Displaced surfaces on the picture: nothing shows through them, and their outline is another one.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include <rakelight/render/render.h>

#include "math/linear.h"
#include "prepare/shapes/primitives.h"
#include "render/height_maps.h"

namespace rakelight {
namespace {

ImageHandle bumps() {
    auto image = std::make_shared<EncodedImage>();
    image->name = "bumps";
    image->decode = [](const EncodedImage&, Context&) {
        Pixels p{.width = 128, .height = 128, .channels = 1, .component = Component::f32, .is_linear = true};
        p.bytes.resize(p.row_bytes() * 128);
        for (int y = 0; y < 128; ++y)
            for (int x = 0; x < 128; ++x) {
                const float h = float(0.5 + 0.25 * std::sin(x * 0.37) + 0.25 * std::cos(y * 0.29 + x * 0.11));
                std::memcpy(p.row(y) + std::size_t(x) * sizeof h, &h, sizeof h);
            }
        return p;
    };
    return image;
}

Scene with_bumps(const PrimitiveRequest& request) {
    Scene scene = make_primitive(request);
    scene.textures.push_back({"bumps", bumps(), {}});
    scene.materials[0].height_texture.texture = 0;
    scene.materials[0].double_sided = true;
    return scene;
}

Frame draw(const Scene& scene, Bump bump, std::uint32_t channels = 0, int threads = 2) {
    Context context({.threads = threads});
    return render(scene,
                  {.width = 320,
                   .height = 240,
                   .channels = channels,
                   .bump = bump,
                   .relief = {.depth = 0.02f},
                   .background = {9, 0, 9, 1}},
                  context);
}

/// Pixels of background that have something on both sides of them in their row, and above and below.
int holes(const Frame& f) {
    const auto is_background = [&](int x, int y) { return f.object[std::size_t(y * f.width + x)] == no_index; };
    int count = 0;
    for (int y = 1; y + 1 < f.height; ++y)
        for (int x = 1; x + 1 < f.width; ++x)
            count += int(is_background(x, y) && !is_background(x - 1, y) && !is_background(x + 1, y) &&
                         !is_background(x, y - 1) && !is_background(x, y + 1));
    return count;
}

std::vector<bool> outline(const Frame& f) {
    std::vector<bool> out;
    for (const std::uint32_t o : f.object) out.push_back(o != no_index);
    return out;
}

TEST(Displacement, NoPixelOfTheBackgroundShowsThroughAPlaneOrASphereOfSixteenObjects) {
    for (const PrimitiveRequest& request :
         {PrimitiveRequest{.shape = PrimitiveShape::plane, .divisions = 8, .objects = 16},
          PrimitiveRequest{.shape = PrimitiveShape::sphere, .tolerance = 0.01, .objects = 16}}) {
        const Frame f = draw(with_bumps(request), Bump::displacement, channel_object);
        EXPECT_EQ(holes(f), 0) << name_of(request.shape);
        int covered = 0;
        for (const bool is : outline(f)) covered += int(is);
        EXPECT_GT(covered, 10000);
    }
}

TEST(Displacement, ChangesTheOutlineWhereFakeBumpsDoNot) {
    Scene sphere = with_bumps({.tolerance = 0.005});
    for (Material& m : sphere.materials) m.normal_texture = m.height_texture;
    const std::vector<bool> base = outline(draw(sphere, Bump::none, channel_object));
    for (const Bump fake :
         {Bump::height, Bump::normal, Bump::parallax, Bump::parallax_limited, Bump::steep, Bump::occlusion})
        EXPECT_EQ(outline(draw(sphere, fake, channel_object)), base) << int(fake);
    const std::vector<bool> displaced = outline(draw(sphere, Bump::displacement, channel_object));
    int differs = 0;
    for (std::size_t i = 0; i < base.size(); ++i) differs += int(base[i] != displaced[i]);
    EXPECT_GT(differs, 200);
}

TEST(Displacement, IsTheSameToTheBitForAnyNumberOfThreads) {
    const Scene sphere = with_bumps({.tolerance = 0.01, .objects = 16});
    const Frame one = draw(sphere, Bump::displacement, 0, 1), four = draw(sphere, Bump::displacement, 0, 4);
    EXPECT_TRUE(one.color == four.color);
}

ImageHandle dents(int side, double phase) {
    auto image = std::make_shared<EncodedImage>();
    image->decode = [side, phase](const EncodedImage&, Context&) {
        Pixels p{.width = side, .height = side, .channels = 3};
        p.bytes.assign(p.row_bytes() * std::size_t(side), std::byte(128));
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) p.row(y)[3 * x] = std::byte(int(128 + 60 * std::sin(x * 0.1 + phase)));
        return p;
    };
    return image;
}

TEST(HeightMaps, ThatAreMadeOfManyNormalMapsHoldOnlyThemselvesInTheBudget) {
    constexpr int side = 128, count = 12;
    Scene scene;
    for (int i = 0; i < count; ++i) {
        scene.textures.push_back({"dents", dents(side, i), {}});
        scene.materials.emplace_back().normal_texture.texture = std::uint32_t(i);
    }
    Context context({.max_memory = std::uint64_t(side * side * 80)});  // one needs 48 bytes a texel while it is made
    scene = with_height_maps(std::move(scene), {.bump = Bump::steep}, context);
    for (const Material& m : scene.materials) EXPECT_TRUE(m.height_texture);
    EXPECT_EQ(context.memory().charged(), std::uint64_t(count * side * side * 2));
}

}  // namespace
}  // namespace rakelight
