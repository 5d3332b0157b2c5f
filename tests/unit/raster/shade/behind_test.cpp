// SPDX-License-Identifier: Apache-2.0
// What is seen through transmissive surfaces: closed forms at clear, colored, thick and rough panes, one layer, the same bits
// whatever the threads, the instruction set and the window.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "math/isa.h"
#include "math/linear.h"
#include "unit/raster/facing_square.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

constexpr int side = 64;  // a power of two: the picture of what is behind has the pixels of the picture

/// Nothing is reflected: an index of refraction of 1.
Material pane(float roughness = 0) {
    Material m = metallic(0, roughness, {1, 1, 1});
    m.metallic_roughness.transmission = 1;
    m.metallic_roughness.ior = 1;
    m.metallic_roughness.specular = 0;
    m.double_sided = true;
    return m;
}

/// Unlit, red grows from 0 to 1 from left to right, at z = -2 behind whatever is at 0.
Scene with_ramp(const Material& front, const dmat4& place = {}) {
    Scene scene;
    Material own;
    own.model = MaterialModel::unlit;
    scene.materials = {front, own};
    Mesh ramp = square_mesh(1, 4);
    ramp.colors = std::vector<vec4>{{-1.5f, 0.5f, 0, 1}, {2.5f, 0.5f, 0, 1}, {2.5f, 0.5f, 0, 1}, {-1.5f, 0.5f, 0, 1}};
    add_object(scene, ramp, translation(dvec3{0, 0, -2}));
    add_object(scene, square_mesh(0, 3), place);
    return scene;
}

RenderSettings of_side(Lighting lighting = Lighting::pbr) {
    return {.width = side, .height = side, .lighting = lighting, .background = {0, 0, 0, 1}};
}

TEST(Behind, AClearPaneShowsWhatIsBehindIt) {
    const Frame frame = draw(with_ramp(pane()), flat_camera(), of_side());
    for (const int x : {3, 20, 40, 60}) {
        const vec4 c = pixel(frame, x, 30);
        EXPECT_NEAR(c.x, (float(x) + 0.5f) / side, 1e-4);
        EXPECT_NEAR(c.y, 0.5f, 1e-4);
        EXPECT_EQ(c.w, 1.0f);
    }
}

TEST(Behind, ItsColorFiltersAndHalfATransmissionLetsHalfThrough) {
    Material m = pane();
    m.base_color = {1, 0.25f, 1, 1};
    EXPECT_NEAR(pixel(draw(with_ramp(m), flat_camera(), of_side()), 32, 32).y, 0.125f, 1e-4);
    m.metallic_roughness.transmission = 0.5f;  // no light: the diffuse rest is black
    EXPECT_NEAR(pixel(draw(with_ramp(m), flat_camera(), of_side()), 32, 32).y, 0.0625f, 1e-4);
    EXPECT_NEAR(pixel(draw(with_ramp(m), flat_camera(), of_side(Lighting::blinn_phong)), 32, 32).y, 0, 1e-4)
        << "opaque under other models";
}

TEST(Behind, BodiesAbsorbByTheirThicknessInTheWorld) {
    Material m = pane();
    m.metallic_roughness.thickness = 2;
    m.metallic_roughness.attenuation_distance = 1;
    m.metallic_roughness.attenuation_color = {1, 0.5f, 1};
    EXPECT_NEAR(pixel(draw(with_ramp(m), flat_camera(), of_side()), 32, 32).y, 0.5f * 0.25f, 1e-4);
    EXPECT_NEAR(pixel(draw(with_ramp(m, scaling(dvec3{2, 2, 2})), flat_camera(), of_side()), 32, 32).y, 0.5f / 16,
                1e-4);
}

/// A slab of thickness d turned by 45 degrees: the ray leaves it d sin(45 - b) to the side, sin b = sin 45 / n.
TEST(Behind, ATurnedBodyRefracts) {
    Material m = pane();
    m.metallic_roughness.ior = 1.5f;
    m.metallic_roughness.thickness = 0.5f;
    const double half_turn = radians(22.5);
    const dmat4 turned = compose({0, 0, 0}, {0, std::sin(half_turn), 0, std::cos(half_turn)}, {1, 1, 1});
    const double sine = std::sqrt(0.5) / 1.5, b = std::asin(sine), moved = 0.5 * std::sin(radians(45.0) - b);
    const vec4 seen = pixel(draw(with_ramp(m, turned), flat_camera(), of_side()), 32, 32);
    EXPECT_NEAR(seen.x, (32.5 - moved * side / 2) / side, 2e-3);  // the normal leans to +x: the ray bends to -x
    m.metallic_roughness.thickness = 0;
    EXPECT_NEAR(pixel(draw(with_ramp(m, turned), flat_camera(), of_side()), 32, 32).x, 32.5 / side, 2e-3) << "thin";
}

TEST(Behind, DispersionPartsRedFromBlue) {
    Material m = pane();
    m.metallic_roughness.ior = 1.5f;
    m.metallic_roughness.thickness = 1;
    m.metallic_roughness.dispersion = 20;
    Scene scene = with_ramp(m, compose({0, 0, 0}, {0, std::sin(0.5), 0, std::cos(0.5)}, {1, 1, 1}));
    scene.meshes[0].colors =
        std::vector<vec4>{{-1.5f, 0, -1.5f, 1}, {2.5f, 0, 2.5f, 1}, {2.5f, 0, 2.5f, 1}, {-1.5f, 0, -1.5f, 1}};
    const vec4 seen = pixel(draw(scene, flat_camera(), of_side()), 32, 32);
    EXPECT_GT(seen.x, seen.z + 0.01f) << "blue is bent more";
}

TEST(Behind, RoughPanesShowMeans) {
    Material m = pane(1);
    m.metallic_roughness.ior = 1.5f;
    const Frame frame = draw(with_ramp(m), flat_camera(), of_side());
    for (const int x : {3, 32, 60}) EXPECT_NEAR(pixel(frame, x, 30).x, 0.5f, 0.02f);
    m.metallic_roughness.ior = 1;  // KHR_materials_ior: what does not refract does not blur
    EXPECT_NEAR(pixel(draw(with_ramp(m), flat_camera(), of_side()), 3, 30).x, 3.5f / side, 0.02f);
}

TEST(Behind, OneLayerAlone) {
    Scene scene = with_ramp(pane());
    Material red = pane();
    red.base_color = {1, 0, 0, 1};
    scene.materials.push_back(red);
    add_object(scene, square_mesh(2, 3), translation(dvec3{0, 0, -1}));
    EXPECT_NEAR(pixel(draw(scene, flat_camera(), of_side()), 32, 32).y, 0.5f, 1e-4) << "the pane behind is not seen";
}

Frame drawn_by(const Scene& scene, RenderSettings s, int threads) {
    Context context({.threads = threads});
    const auto engine = raster::make_engine();
    engine->prepare(scene, context);
    Frame frame;
    engine->render(flat_camera(), s, frame, context);
    return frame;
}

TEST(Behind, TheBitsAreThoseOfAnyWindowThreadsAndInstructionSet) {
    Material m = pane(0.3f);
    m.metallic_roughness.ior = 1.4f;
    m.metallic_roughness.thickness = 0.7f, m.metallic_roughness.dispersion = 3;
    m.metallic_roughness.iridescence = 1;
    Scene scene = with_ramp(m, compose({0.3, 0, 0}, {0, std::sin(0.3), 0, std::cos(0.3)}, {0.2, 0.2, 0.2}));
    scene.lights = {directional({0.3, -0.4, -1})};
    for (const int samples : {1, 4}) {
        RenderSettings s = of_side();
        s.width = 150, s.height = 90, s.samples = samples;
        const Frame whole = drawn_by(scene, s, 4);
        for (const Isa isa : {Isa::scalar, Isa::sse2, Isa::avx2, Isa::avx512}) {
            if (!is_available(isa)) continue;
            setenv("RAKELIGHT_ISA", name(isa), 1);
            EXPECT_EQ(drawn_by(scene, s, 1).color, whole.color) << name(isa);
            unsetenv("RAKELIGHT_ISA");
        }
        s.window = {37, 20, 70, 41};
        const Frame part = drawn_by(scene, s, 2);
        for (int y = 0; y < 41; ++y)
            for (int x = 0; x < 70; ++x)
                ASSERT_EQ(part.color[std::size_t(y * 70 + x)], pixel(whole, x + 37, y + 20)) << x << ' ' << y;
    }
}

}  // namespace
