// SPDX-License-Identifier: Apache-2.0
// maps.glsl and albedo_tables.glsl on a GPU, or on Mesa's llvmpipe, in GLSL 3.30 and in ES 3.00: what they read from
// textures, bound as an engine binds them, is compared with closed forms in double. Skipped where there is no EGL.
#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <fstream>
#include <numbers>
#include <random>
#include <sstream>

#include "lighting/albedo_tables.h"
#include "support/gl_context.h"
#include "support/shared.h"

namespace rakelight::lighting_test {
namespace {

using test::GlContext;
using test::GlFlavour;

constexpr float pi = std::numbers::pi_v<float>;
constexpr double by_hardware = 1.0 / 256;  ///< of values below 1: weights of filters may have 8 bits
constexpr float unread = 99;               ///< in channels that no function looks at

/// Four numbers that a pixel finds in `q`.
using Query = std::array<float, 4>;

struct Level {
    int width, height;
    std::vector<float> texels;  ///< [width * height * 4]
};

/// A texture with its levels; those of mip chains halve down to one texel.
struct Chain {
    std::vector<Level> levels;
    GLint wrap_u, wrap_v;
    bool is_octahedral = false;  ///< then it goes on across its edges as the sphere does
};

/// Numbers k / 64 below 1, which half floats hold exactly; no symmetry hides a wrong texel.
Chain random_chain(int width, int height, GLint wrap_u, GLint wrap_v) {
    std::mt19937 random(7);
    Chain chain{{}, wrap_u, wrap_v};
    for (;; width = std::max(width / 2, 1), height = std::max(height / 2, 1)) {
        chain.levels.push_back({width, height, {}});
        for (int i = 0; i < 4 * width * height; ++i) chain.levels.back().texels.push_back(float(random() >> 26) / 64);
        if (width == 1 && height == 1) return chain;
    }
}

int wrapped(int i, int size, GLint mode) {
    if (mode != GL_REPEAT && mode != GL_MIRRORED_REPEAT) return std::clamp(i, 0, size - 1);
    const int period = mode == GL_REPEAT ? size : 2 * size, at = (i % period + period) % period;
    return at < size ? at : period - 1 - at;
}

double texel(const Chain& chain, const Level& l, int x, int y, std::size_t channel) {
    const bool is_aside = x < 0 || x >= l.width, is_beyond = y < 0 || y >= l.height;
    x = wrapped(x, l.width, chain.wrap_u), y = wrapped(y, l.height, chain.wrap_v);
    if (chain.is_octahedral && is_aside) y = l.height - 1 - y;  // bordered_texel() of image/environment.h
    if (chain.is_octahedral && is_beyond) x = l.width - 1 - x;
    return double(l.texels[std::size_t(y * l.width + x) * 4 + channel]);
}

double bilinear(const Chain& chain, const Level& l, double u, double v, std::size_t channel) {
    const double x = u * l.width - 0.5, y = v * l.height - 0.5;
    const int left = int(std::floor(x)), top = int(std::floor(y));
    const auto tap = [&](int right, int down) { return texel(chain, l, left + right, top + down, channel); };
    return std::lerp(std::lerp(tap(0, 0), tap(1, 0), x - left), std::lerp(tap(0, 1), tap(1, 1), x - left), y - top);
}

/// @param place  u, v, level
double trilinear(const Chain& chain, const Query& place, std::size_t channel) {
    const std::size_t last = chain.levels.size() - 1;
    const double level = std::clamp(double(place[2]), 0.0, double(last));
    const auto lower = std::size_t(level);
    const auto of = [&](std::size_t i) { return bilinear(chain, chain.levels[i], place[0], place[1], channel); };
    return std::lerp(of(lower), of(std::min(lower + 1, last)), level - double(lower));
}

std::string read_source(const std::string& name) {
    std::ifstream file(test::source_dir() / "src" / name);
    std::stringstream text;
    text << file.rdbuf();
    EXPECT_FALSE(text.str().empty()) << name;
    return text.str() + "\n";
}

/// Everything that an engine's program has.
std::string whole_text() {
    std::string text = read_source("math/prelude.glsl") + read_source("lighting/maps.glsl") +
                       read_source("lighting/albedo_tables.glsl");
    std::istringstream list(read_source("lighting/all.glsl.list"));
    for (std::string name; std::getline(list, name);)
        if (!name.empty() && name[0] != '#') text += read_source("lighting/" + name);
    return text;
}

/// As half floats: ES need not filter floats. GlContext::run() looks for errors.
void bind_chain(GlContext& context, const std::string& sampler, const Chain& chain) {
    context.set_textures(
        {{sampler, 1, 1, std::span(chain.levels.back().texels).first(4)}});  // stays bound: what follows goes to it
    for (GLint number = 0; const Level& l : chain.levels)
        glTexImage2D(GL_TEXTURE_2D, number++, GL_RGBA16F, l.width, l.height, 0, GL_RGBA, GL_FLOAT, l.texels.data());
    const bool has_levels = chain.levels.size() > 1;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, has_levels ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, chain.wrap_u);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, chain.wrap_v);
}

/// A pixel a query, whose `result` the statements set.
std::vector<float> draw(GlContext& context, const std::vector<Query>& queries, const std::string& statements) {
    std::vector<float> numbers;
    for (const Query& q : queries) numbers.insert(numbers.end(), q.begin(), q.end());
    const int count = int(numbers.size() / 4);
    context.set_textures({{"queries", count, 1, numbers}});
    return context.run(whole_text() +
                           "uniform sampler2D queries;\nvoid main() {\n"
                           "    vec4 q = texelFetch(queries, ivec2(int(gl_FragCoord.x), 0), 0);\n"
                           "    Maps maps;\n    maps.shadow_origin = ivec2(0);\n    maps.height_scale = 1.0;\n    "
                           "maps.height_offset = 0.0;\n    " +
                           statements + "\n}\n",
                       count, 1);
}

/// u, v of from..to, levels past both ends, 0..3. Up to 8 texels a side have weights there that 8 bits hold exactly.
std::vector<Query> random_places(int from, int to) {
    std::mt19937 random(11);
    const auto any = [&random](int first, int last) { return float(first + int(random() % (last - first + 1u))); };
    std::vector<Query> out(512);
    for (Query& q : out)
        q = {any(128 * from, 128 * to) / 128, any(128 * from, 128 * to) / 128, any(-8, 40) / 8, any(0, 3)};
    return out;
}

/// @param got  colors at `places` of the chain
void expect_colors(const std::vector<float>& got, const std::vector<Query>& places, const Chain& chain) {
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            ASSERT_NEAR(got[4 * i + c], trilinear(chain, places[i], c), by_hardware)
                << "channel " << c << " at " << testing::PrintToString(places[i]);
}

/// Levels beside each other, each with its border. 32-bit floats would need an extension of ES to be filtered.
void bind_environment(GlContext& context, const Chain& chain) {
    int width = 0, height = 0;
    std::vector<float> places;
    for (const Level& l : chain.levels) {
        places.insert(places.end(), {float(width + 1), 1, float(l.width)});
        width += l.width + 2, height = std::max(height, l.height + 2);
    }
    Chain atlas{
        {{width, height, std::vector<float>(std::size_t(4 * width * height), unread)}}, chain.wrap_u, chain.wrap_v};
    for (std::size_t i = 0; i < chain.levels.size(); ++i)
        for (int y = -1; y <= chain.levels[i].height; ++y)
            for (int x = -1; x <= chain.levels[i].width; ++x)
                for (std::size_t c = 0; c < 4; ++c)
                    atlas.levels[0].texels[std::size_t((y + 1) * width + x + int(places[3 * i])) * 4 + c] =
                        float(texel(chain, chain.levels[i], x, y, c));
    bind_chain(context, "rl_environment", atlas);
    context.set_vectors("rl_environment_levels", places);
}

class MapsOnGpu : public testing::TestWithParam<GlFlavour> {
protected:
    void SetUp() override {
        std::string why;
        context = GlContext::make(GetParam(), why);
        if (!context) GTEST_SKIP() << why;
    }
    std::unique_ptr<GlContext> context;
};

/// q.w: 0 front, 1 front of a map of depths, 2 back, 3 back of one.
void expect_heights(GlContext& context, GLint wrap_u, GLint wrap_v) {
    const Chain chain = random_chain(8, 4, wrap_u, wrap_v);
    bind_chain(context, "rl_heights", chain);
    const std::vector<Query> places = random_places(-1, 2);
    const std::vector<float> got = draw(context, places,
                                        "HeightSense sense = height_sense(q.w < 2.0 ? 1.0 : -1.0, 0.5, int(q.w) & 1);\n"
                                        "    maps.height_scale = sense.scale;\n    maps.height_offset = sense.offset;\n"
                                        "    result = vec4(sample_height(maps, q.xy, q.z));");
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double height = trilinear(chain, places[i], 0);
        const bool is_upright = places[i][3] == 0 || places[i][3] == 3;
        ASSERT_NEAR(got[4 * i], is_upright ? height : 1 - height, by_hardware) << testing::PrintToString(places[i]);
    }
}

TEST_P(MapsOnGpu, HeightsRepeatAlongUAndAreMirroredAlongV) { expect_heights(*context, GL_REPEAT, GL_MIRRORED_REPEAT); }
TEST_P(MapsOnGpu, HeightsEndAlongUAndRepeatAlongV) { expect_heights(*context, GL_CLAMP_TO_EDGE, GL_REPEAT); }

/// The direction, and the level, of a place on the octahedral map: octahedral_direction() of image/environment.h.
Query unfolded(const Query& place) {
    const float x = 2 * place[0] - 1, z = 2 * place[1] - 1, y = 1 - std::abs(x) - std::abs(z);
    if (y >= 0) return {x, y, z, place[2]};
    return {std::copysign(1 - std::abs(z), x), y, std::copysign(1 - std::abs(x), z), place[2]};
}

void expect_environment(GlContext& context, const std::vector<Query>& places) {
    Chain chain{{}, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE, true};
    for (const int size : {8, 4, 4, 2, 2, 2, 2, 2})
        chain.levels.push_back(random_chain(size, size, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE).levels[0]);
    bind_environment(context, chain);
    std::vector<Query> directions;
    for (const Query& place : places) directions.push_back(unfolded(place));
    expect_colors(draw(context, directions, "result = vec4(sample_environment(maps, octahedral(q.xyz), q.w), 1.0);"),
                  places, chain);
}

TEST_P(MapsOnGpu, EnvironmentIsMixedOfOctahedralLevelsAndGoesOnAcrossTheirEdges) {
    std::vector<Query> places = random_places(0, 1);
    for (std::size_t i = 0; i < places.size(); ++i) places[i][2] += float(i % 2) * 4;  // to the last levels
    expect_environment(*context, places);
}

/// The direction, and the level, of a place on an equirectangular picture: its middle is -Z, its top +Y.
Query direction_on_sky(const Query& place) {
    const float azimuth = 2 * pi * (place[0] - 0.5f), across = std::sin(pi * place[1]);
    return {across * std::sin(azimuth), std::cos(pi * place[1]), -across * std::cos(azimuth), place[2]};
}

TEST_P(MapsOnGpu, SkyIsAnEquirectangularPictureThatClosesBehind) {
    const Chain chain = random_chain(8, 4, GL_REPEAT, GL_CLAMP_TO_EDGE);
    bind_chain(*context, "rl_sky", chain);
    std::vector<Query> places = random_places(0, 1), directions;
    for (Query& place : places) {
        place[1] = std::clamp(place[1], 1.0f / 128, 127.0f / 128);  // the poles have no u
        directions.push_back(direction_on_sky(place));
    }
    expect_colors(draw(*context, directions, "result = vec4(sample_sky(maps, equirectangular(q.xyz), q.w), 1.0);"),
                  places, chain);
}

/// Rows of 32 numbers, by RL_ALBEDO_...; the one row of losses stands there twice.
std::array<std::vector<float>, 4> tables() {
    const lighting::AlbedoTables t = lighting::albedo_tables();
    std::array<std::vector<float>, 4> out;
    out[0].assign(t.lobe_loss, t.lobe_loss + 32 * 32);
    out[1].assign(t.grazing, t.grazing + 32 * 32);
    out[2].assign(t.sheen, t.sheen + 16 * 32);
    for (int i = 0; i < 2; ++i) out[3].insert(out[3].end(), t.loss, t.loss + 32);
    return out;
}

/// Places in float, since a GPU has them so; shares of texels and sums in double.
double table_value(const std::vector<float>& table, float x, float y) {
    const int rows = int(table.size()) / 32;
    const float column = std::clamp(x, 0.0f, 1.0f) * 31, row = std::clamp(y, 0.0f, 1.0f) * float(rows - 1);
    const int c = std::min(int(column), 30), r = std::min(int(row), rows - 2);
    const auto along = [&](int at) {
        const float* const first = table.data() + 32 * at + c;
        return std::lerp(double(first[0]), double(first[1]), double(column) - c);
    };
    return std::lerp(along(r), along(r + 1), double(row) - r);
}

TEST_P(MapsOnGpu, AlbedosAreThoseOfTheTables) {
    std::vector<float> texels;
    for (const auto all = tables(); const std::vector<float>& table : all)
        for (const float number : table) texels.insert(texels.end(), {number, unread, unread, unread});
    context->set_textures({{"rl_albedos", 32, int(texels.size()) / 128, texels}});
    std::mt19937 random(13);
    std::vector<Query> queries;
    const auto any = [&random] { return float(random() >> 8) * 0x1.2p-24f - 0.0625f; };  // clamped to 0..1
    for (int i = 0; i < 1024; ++i) queries.push_back({any(), any(), float(i % 4), 0});
    const std::vector<float> got = draw(*context, queries, "result = vec4(sample_albedo(maps, int(q.z), q.x, q.y));");
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const auto [x, y, table, unused] = queries[i];
        const double expected = table_value(tables()[std::size_t(table)], x, y);  // up to 264
        ASSERT_NEAR(got[4 * i], expected, 1e-6 * std::max(expected, 1.0)) << testing::PrintToString(queries[i]);
    }
}

/// An atlas of shadow maps of 3 x 3 texels: a cube's six faces from texel (3, 6) on, three below each other, the other three to
/// the right of them. `at(face, texel)` gives nearness and codes.
template <class At>
void bind_cube(GlContext& context, const At& at) {
    constexpr int width = 12, height = 18;
    std::vector<std::uint32_t> texels(2 * width * height, 77);
    for (int face = 0; face < 6; ++face)
        for (int i = 0; i < 9; ++i) {
            const int x = 3 + face / 3 * 3 + i % 3, y = 6 + face % 3 * 3 + i / 3;
            const auto [nearness, codes] = at(face, i);
            texels[std::size_t(2 * (y * width + x))] = std::bit_cast<std::uint32_t>(nearness);
            texels[std::size_t(2 * (y * width + x) + 1)] = codes;
        }
    context.set_whole_texture("rl_shadow_atlas", width, height, texels);
    context.set_whole("rl_shadow_size", 3);
}

float nearness_of(int number) {
    return number == 0 ? -3e38f : 1 / float(number);
}  ///< the first: nothing, on a parallel light's map

TEST_P(MapsOnGpu, NearnessIsThatOfTheTexelOfACubesFace) {
    std::vector<Query> queries;
    for (int i = 0; i < 6 * 9; ++i) {
        queries.push_back({0.3f, -0.2f, 0.1f, float(i % 9)});  // a direction; number of a texel of its face
        queries.back()[std::size_t(i / 18)] = i / 9 % 2 == 0 ? 1.0f : -1.0f;
    }
    bind_cube(*context, [](int face, int i) { return std::pair(nearness_of(9 * face + i), 0u); });
    const std::vector<float> got = draw(*context, queries,
                                        "maps.shadow_origin = ivec2(3, 6);\n"
                                        "    float first = cube_face(q.xyz).number * 3.0;\n    int i = int(q.w);\n"
                                        "    result = vec4(fetch_nearness(maps, float(i % 3), first + float(i / 3)));");
    for (std::size_t i = 0; i < queries.size(); ++i) EXPECT_EQ(got[4 * i], nearness_of(int(i))) << "texel " << i;
}

TEST_P(MapsOnGpu, SlopesAreTheCodesAlongXThenDownY) {
    const auto code = [](int number, int step) { return std::uint32_t(number * step % 65521); };
    const auto slope = [](std::uint32_t c) { return float(c) / 4095 - 8; };
    std::vector<Query> queries;
    for (int i = 0; i < 6 * 9; ++i) queries.push_back({float(i % 3), float(i / 3), 0, 0});
    bind_cube(*context, [&](int face, int i) {
        const int number = 9 * face + i;
        return std::pair(0.0f, code(number, 1201) | code(number, 907) << 16);
    });
    const std::vector<float> got =
        draw(*context, queries,
             "maps.shadow_origin = ivec2(3, 6);\n    result = vec4(fetch_slopes(maps, q.x, q.y), 99.0, 99.0);");
    for (std::size_t i = 0; i < queries.size(); ++i) {
        EXPECT_NEAR(got[4 * i], slope(code(int(i), 1201)), 2e-6) << "texel " << i;
        EXPECT_NEAR(got[4 * i + 1], slope(code(int(i), 907)), 2e-6) << "texel " << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Gl, MapsOnGpu, testing::Values(GlFlavour::core_33, GlFlavour::es_30),
                         [](const auto& flavour) { return flavour.param == GlFlavour::es_30 ? "Es300" : "Glsl330"; });

}  // namespace
}  // namespace rakelight::lighting_test
