// SPDX-License-Identifier: Apache-2.0
// STL files have Z up. What is made of them stands as they do: files, worlds, comparisons, scenes of the library.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include <rakelight/base/report.h>
#include <rakelight/scene/scene_queries.h>
#include <rakelight/tools/bake_files.h>
#include <rakelight/tools/compare.h>
#include <rakelight/tools/convert_file.h>
#include <rakelight/world/render_keys.h>
#include <rakelight/world/world_request.h>
#include <rakelight_internal/render/draw_alike.h>
#include <rakelight_internal/tools/radiosity_file.h>

#include "base/format_text.h"
#include "math/linear.h"
#include "render/look.h"
#include "scene/drawn_vertices.h"
#include "unit/tools/smooth_file_support.h"

namespace rakelight {
namespace {

using namespace test;

/// A wedge on the plane z = 0, of 4 by 1 by 2, as a modeler with Z up sees it: its vertical side is at the lowest x.
std::string wedge_stl() {
    const double p[6][3] = {{0, 0, 0}, {4, 0, 0}, {0, 1, 0}, {4, 1, 0}, {0, 0, 2}, {0, 1, 2}};
    const int faces[8][3] = {{0, 2, 3}, {0, 3, 1}, {0, 4, 5}, {0, 5, 2}, {0, 1, 4}, {2, 5, 3}, {1, 3, 5}, {1, 5, 4}};
    std::string text = "solid wedge\n";
    for (const auto& face : faces) {
        text += "facet normal 0 0 0\nouter loop\n";
        for (const int corner : face)
            text += format_text("vertex {} {} {}\n", p[corner][0], p[corner][1], p[corner][2]);
        text += "endloop\nendfacet\n";
    }
    return text + "endsolid wedge\n";
}

/// How many pixels differ by more than rounding in any channel, and the largest difference.
struct Difference {
    std::size_t pixels = 0;
    int largest = 0;
};

Difference between(const Pixels& a, const Pixels& b) {
    Difference difference;
    EXPECT_EQ(a.width, b.width);
    EXPECT_EQ(a.bytes.size(), b.bytes.size());
    for (std::size_t i = 0; i < std::min(a.bytes.size(), b.bytes.size()); ++i) {
        const int by = std::abs(int(a.bytes[i]) - int(b.bytes[i]));
        difference.pixels += by > 1;
        difference.largest = std::max(difference.largest, by);
    }
    return difference;
}

class ZUpFiles : public testing::Test {
protected:
    void SetUp() override { stl_ = folder_.write("wedge.stl", wedge_stl()); }
    /// In the default look, with what formats store in different ways, or not at all: the color and its highlight.
    PictureRequest request(const std::string& file) {
        PictureRequest request{.input = file, .look = Look::standard};
        const std::vector<WorldValue> keys = {{.key = "lighting", .words = {"lambert"}},
                                              {.key = "light", .words = {"studio"}},
                                              {.key = "color", .words = {"#c04020"}}};
        read_render_keys(keys, request);
        request.settings.width = 120, request.settings.height = 90;
        return request;
    }
    Pixels picture(const std::string& file) { return picture(request(file)); }
    Pixels picture(const PictureRequest& of) {
        Pixels color;
        render_picture(of, color, context_);
        return color;
    }
    dvec3 size_of(const std::string& file) {
        const Bounds box = world_bounds(load(file, {}, context_));
        return box.high - box.low;
    }

    TemporaryFolder folder_;
    std::string stl_;
    Context context_;
};

constexpr const char* turned = "the model was turned to Y up";

TEST_F(ZUpFiles, ConvertedAndSmoothedFilesLookAsTheStl) {
    const Pixels wanted = picture(stl_);
    for (const char* name : {"a.glb", "b.gltf", "c.obj"}) {
        const std::string converted = folder_.file(name), smoothed = folder_.file(std::string("smooth_") + name);
        convert_file(stl_, converted, {}, context_);
        smooth_file(stl_, smoothed, {}, context_);
        for (const std::string& file : {converted, smoothed}) {
            EXPECT_EQ(size_of(file), (dvec3{4, 2, 1})) << file;
            EXPECT_EQ(between(wanted, picture(file)).pixels, 0u) << file << between(wanted, picture(file)).largest;
            EXPECT_FALSE(smooth_file(file, file, {}, context_).changed && file == smoothed) << file;
        }
    }
    EXPECT_TRUE(is_said(context_, Remark::changed, turned));
}

TEST_F(ZUpFiles, PlyFilesKeepCoordinatesAndSaySo) {
    const std::string ply = folder_.file("a.ply");
    convert_file(stl_, ply, {}, context_);
    EXPECT_EQ(size_of(ply), (dvec3{4, 1, 2}));
    EXPECT_TRUE(is_said(context_, Remark::warning, "'up' +Z shows it upright"));
    PictureRequest upright = request(ply);
    upright.view.world_up = dvec3{0, 0, 1}, upright.given_keys.emplace_back("up");
    EXPECT_EQ(between(picture(stl_), picture(upright)).pixels, 0u);
}

TEST_F(ZUpFiles, AGivenAxisWins) {
    convert_file(stl_, folder_.file("a.glb"), {}, context_);
    PictureRequest lying = request(stl_);
    lying.view.world_up = dvec3{0, 1, 0}, lying.given_keys.emplace_back("up");
    EXPECT_GT(between(picture(lying), picture(folder_.file("a.glb"))).pixels, 500u);
}

/// Files that are smoothed as one model still fit together.
TEST_F(ZUpFiles, SeveralFilesAreTurnedTogetherOrNotAtAll) {
    const std::string second = folder_.write("second.stl", wedge_stl()), obj = folder_.file("part.obj");
    write(obj, "v 0 0 0\nv 4 0 0\nv 0 1 0\nv 0 0 2\nf 1 2 3\nf 1 4 2\n");
    const FileToSmooth alike[] = {{stl_, folder_.file("a.glb")}, {second, folder_.file("b.obj")}};
    smooth_files(alike, {}, context_);
    for (const FileToSmooth& file : alike) EXPECT_EQ(size_of(file.output), (dvec3{4, 2, 1})) << file.output;
    const FileToSmooth mixed[] = {{stl_, folder_.file("a.glb")}, {obj, folder_.file("b.obj")}};
    EXPECT_FALSE(is_said(context_, Remark::warning, "lies on its side"));
    smooth_files(mixed, {}, context_);
    for (const FileToSmooth& file : mixed) EXPECT_EQ(size_of(file.output), (dvec3{4, 1, 2})) << file.output;
    EXPECT_TRUE(is_said(context_, Remark::warning, "lies on its side beside models with Y up"));
    context_.report().clear();
    const std::string both = folder_.file("both.glb");
    convert_file(stl_, both, {.joined = {second}}, context_);
    EXPECT_EQ(size_of(both), (dvec3{4, 2, 1}));
    EXPECT_FALSE(is_said(context_, Remark::warning, "lies on its side"));
    convert_file(obj, both, {.joined = {stl_}}, context_);
    EXPECT_EQ(size_of(both), (dvec3{4, 1, 2}));
    EXPECT_TRUE(is_said(context_, Remark::warning, "lies on its side beside models with Y up"));
}

TEST_F(ZUpFiles, WorldsSayThatAnStlLiesUnlessItIsTurnedUprightOrTheAxisIsGiven) {
    const std::string world = folder_.file("w.scene.toml"), lies = "lies on its side because worlds have Y up";
    const auto is_said_of = [&](const std::string& text, const LoadOptions& options) {
        write(world, text);
        Context context;
        load(world, options, context);
        return is_said(context, Remark::warning, lies);
    };
    const std::string model = "[[model]]\nfile = 'wedge.stl'\n", turn = "rotation_deg = [-90, 0, 0]\n";
    EXPECT_TRUE(is_said_of(model, {}));
    EXPECT_TRUE(is_said_of(model + turn + model, {}));
    EXPECT_FALSE(is_said_of(model + turn, {}));
    const auto rotated = [&](const std::string& by) { return model + "rotation_deg = " + by + "\n"; };
    for (const char* by : {"[-90, 0, 30]", "[-90, 200, 0]", "[-50, 0, 0]"})
        EXPECT_FALSE(is_said_of(rotated(by), {})) << by;
    for (const char* by : {"[0, 30, 0]", "[0, 0, 90]", "[-40, 0, 0]", "[90, 0, 0]", "[-90, 0, 60]"})
        EXPECT_TRUE(is_said_of(rotated(by), {})) << by;
    EXPECT_TRUE(is_said_of(model + turn + "scale = [1, 1, -1]\n", {})) << "upside down";
    EXPECT_FALSE(is_said_of("[render]\nup = '+Z'\n" + model, {}));
    write(world, model);
    RenderOverrides up;
    up.values = {{.key = "up", .words = {"+Z"}}};
    EXPECT_FALSE(is_said_of(model, read_world_request(world, {}, up, context_).picture.load));
    write(world, model + turn);
    const dvec3 size = size_of(world);
    EXPECT_NEAR(size.y, 2, 1e-12) << "what the remark advises is right";
    EXPECT_NEAR(size.z, 1, 1e-12);
}

TEST_F(ZUpFiles, AWorldWithZUpIsWrittenAsAnStl) {
    const std::string world = folder_.file("w.scene.toml");
    const auto written = [&](const std::string& up, const std::string& name) {
        write(world, "[render]\nup = '" + up + "'\n[[model]]\nfile = 'wedge.stl'\n");
        context_.report().clear();
        convert_file(world, folder_.file(name), {}, context_);
        return size_of(folder_.file(name));
    };
    for (const char* name : {"a.glb", "a.obj"}) {
        EXPECT_EQ(written("+Z", name), (dvec3{4, 2, 1})) << name;
        EXPECT_TRUE(is_said(context_, Remark::changed, turned)) << name;
        EXPECT_EQ(written("+Y", name), (dvec3{4, 1, 2})) << name;
        EXPECT_FALSE(is_said(context_, Remark::changed, turned)) << name;
        EXPECT_EQ(written("-Z", name), (dvec3{4, 1, 2})) << name;
        EXPECT_TRUE(is_said(context_, Remark::warning, "the model keeps its coordinates")) << name;
    }
    EXPECT_EQ(written("+Z", "a.ply"), (dvec3{4, 1, 2}));
    EXPECT_TRUE(is_said(context_, Remark::warning, "'up' +Z shows it upright"));
}

TEST_F(ZUpFiles, PicturesOfStlFilesBesideOthersSaySo) {
    PictureRequest both = request(stl_);
    both.load.joined = {"builtin:sphere"};
    picture(both);
    EXPECT_TRUE(is_said(context_, Remark::warning, "lies on its side beside models with Y up"));
    context_.report().clear();
    both.load.joined = {folder_.write("second.stl", wedge_stl())};
    picture(both);
    EXPECT_FALSE(is_said(context_, Remark::warning, "lies on its side"));
}

TEST_F(ZUpFiles, ComparisonsShowBothUpright) {
    for (const char* name : {"a.glb", "a.obj", "a.ply"}) {
        const std::string other = folder_.file(name);
        convert_file(stl_, other, {}, context_);
        for (const bool is_first : {true, false}) {
            const auto [a, b] =
                draw_alike(request(is_first ? stl_ : other), request(is_first ? other : stl_), context_);
            EXPECT_EQ(between(a, b).pixels, 0u) << name;
            EXPECT_EQ(between(a, picture(stl_)).pixels, 0u) << name;
        }
    }
}

/// As in Python: scenes are loaded, drawn and saved.
TEST_F(ZUpFiles, SavedScenesLookAsTheyAreDrawn) {
    const Scene scene = load(stl_, {}, context_);
    const Bounds box = world_bounds(scene);
    EXPECT_EQ(box.high, (dvec3{4, 1, 2})) << "coordinates are those of the file";
    for (const char* name : {"a.glb", "a.obj"}) {
        save(scene, folder_.file(name), context_);
        EXPECT_EQ(size_of(folder_.file(name)), (dvec3{4, 2, 1})) << name;
        EXPECT_TRUE(is_said(context_, Remark::changed, turned)) << name;
        context_.report().clear();
    }
    save(scene, folder_.file("a.ply"), context_);
    EXPECT_EQ(size_of(folder_.file("a.ply")), (dvec3{4, 1, 2}));
    EXPECT_TRUE(is_said(context_, Remark::warning, "'up' +Z shows it upright"));
}

/// The name of the first file does not decide for all.
TEST_F(ZUpFiles, SavedScenesOfSeveralFilesAreTurnedTogetherOrNotAtAll) {
    const std::string second = folder_.write("second.stl", wedge_stl()), out = folder_.file("a.glb");
    const Scene alike = load(stl_, {.joined = {second}}, context_);
    save(alike, out, context_);
    EXPECT_EQ(size_of(out), (dvec3{4, 2, 1}));
    const std::string obj = folder_.write("part.obj", "v 0 0 0\nv 4 0 0\nv 0 1 0\nf 1 2 3\n");
    save(load(stl_, {.joined = {obj}}, context_), out, context_);
    EXPECT_EQ(size_of(out), (dvec3{4, 1, 2}));
}

/// A convex model baked onto itself: a ray that goes inward through a point of LOW meets HIGH at this point, so heights are 0.
TEST_F(ZUpFiles, BakesMeetAModelThatWasTurned) {
    if (!can_bake()) GTEST_SKIP() << "this build follows no rays";
    const std::string glb = folder_.file("low.glb"), ply = folder_.file("low.ply");
    convert_file(stl_, glb, {}, context_);
    convert_file(stl_, ply, {}, context_);
    const std::pair<std::string, std::string> pairs[] = {{stl_, glb}, {glb, stl_}, {stl_, ply}, {stl_, stl_}};
    for (const auto& [high, low] : pairs) {
        context_.report().clear();
        BakeRequest request{.high = high, .low = low, .output = folder_.file("h.exr"), .model = folder_.file("m.glb")};
        request.options.maps = {BakeMap::height};
        request.options.width = request.options.height = 64;
        EXPECT_EQ(bake_files(request, context_).report.missed, 0u) << high << " onto " << low;
        EXPECT_EQ(size_of(request.model), low == ply ? (dvec3{4, 1, 2}) : (dvec3{4, 2, 1})) << low;
        EXPECT_EQ(is_said(context_, Remark::changed, turned), low != ply) << low;
        const Pixels map = read_picture(request.output, context_);
        ASSERT_EQ(map.component, Component::f32);
        for (std::size_t i = 0; i < map.bytes.size(); i += sizeof(float)) {
            float height = 0;
            std::memcpy(&height, map.bytes.data() + i, sizeof height);
            ASSERT_NEAR(height, 0, 1e-5) << high << " onto " << low;
        }
    }
}

TEST_F(ZUpFiles, ASceneLitByRadiosityIsTurned) {
    if (!can_bake()) GTEST_SKIP() << "this build follows no rays";
    PictureRequest lit = request(stl_);
    lit.output = folder_.file("lit.glb");
    radiosity_file(lit, std::nullopt, context_);
    EXPECT_EQ(size_of(lit.output), (dvec3{4, 2, 1}));
    EXPECT_TRUE(is_said(context_, Remark::changed, turned));
    lit.input = folder_.file("lit.ply");
    convert_file(stl_, lit.input, {}, context_);
    lit.view.world_up = dvec3{0, 0, 1};
    radiosity_file(lit, std::nullopt, context_);
    EXPECT_EQ(size_of(lit.output), (dvec3{4, 2, 1})) << "the axis was given";
}

TEST_F(ZUpFiles, StandardInputHasItsFormatsAxis) {
    const std::string text = wedge_stl();
    const auto* first = reinterpret_cast<const std::byte*>(text.data());
    for (const char* name : {"standard input", "standard input.stl"}) {
        PictureRequest piped = request(name);
        piped.load.memory_files = {{name, std::make_shared<const std::vector<std::byte>>(first, first + text.size())}};
        EXPECT_EQ(between(picture(piped), picture(stl_)).pixels, 0u) << name;
    }
}

}  // namespace
}  // namespace rakelight
