// SPDX-License-Identifier: Apache-2.0
// Which files are pieces of one surface: parts of one wall, as OBJ files.
#include <gtest/gtest.h>

#include <array>
#include <sstream>

#include <rakelight/tools/smooth_file.h>

#include "io/gltf/write/glb_writer.h"
#include "support/temporary_folder.h"
#include "unit/prepare/meshes.h"

namespace rakelight {
namespace {

using First = std::vector<std::uint32_t>;

class FilesCutApart : public testing::Test {
protected:
    /// A part of a wall, from x to x + 1: `rows` unit squares one above the other, counter-clockwise seen from +Z; `is_back` the
    /// other way round.
    std::string part(const std::string& name, double x, bool is_back = false, double z = 0, int rows = 2) {
        std::ostringstream file;
        for (int y = 0; y <= rows; ++y)
            for (const double dx : {0, 1}) file << "v " << x + dx << ' ' << y << ' ' << z << '\n';
        for (int v = 1; v <= 2 * rows; v += 2)
            for (const int k : is_back ? std::array{0, 2, 3, 1} : std::array{0, 1, 3, 2})
                file << (k == 0 ? "f " : " ") << v + k << (k == (is_back ? 1 : 2) ? "\n" : "");
        return folder_.write(name, file.str());
    }
    First first(const std::vector<std::string>& files, const SmoothFileOptions& options = {}) {
        return files_cut_apart(files, options, context_).first;
    }

    const test::TemporaryFolder folder_;
    Context context_;
};

TEST_F(FilesCutApart, NeighborsContinueEachOtherInAnyOrder) {
    const std::string a = part("a.obj", 0), b = part("b.obj", 1), c = part("c.obj", 2), far = part("f.obj", 9);
    EXPECT_EQ(first({a, b}), (First{0, 0}));
    EXPECT_EQ(first({a, c}), (First{0, 1}));
    EXPECT_EQ(first({far, c, a, b}), (First{0, 1, 1, 1}));
    EXPECT_EQ(first({a}), (First{0}));
    EXPECT_EQ(first({}), (First{}));
    EXPECT_EQ(first({part("low.obj", 0, false, 0, 1), part("next.obj", 1, false, 0, 1)}), (First{0, 1}))
        << "one edge only";
}

TEST_F(FilesCutApart, VariantsAndTouchingModelsAreApart) {
    const std::string a = part("a.obj", 0), copy = part("copy.obj", 0), back = part("back.obj", 1, true);
    EXPECT_EQ(first({a, copy}), (First{0, 1}));
    EXPECT_EQ(first({a, back}), (First{0, 1}));  // its edge runs as that of `a` does
    // A closed box at the edge has no open edge.
    std::ostringstream file;
    for (int i = 0; i < 8; ++i) file << "v " << 1 + (i & 1) << ' ' << (i >> 1 & 1) << ' ' << (i >> 2) << '\n';
    file << "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
    EXPECT_EQ(first({a, folder_.write("box.obj", file.str())}), (First{0, 1}));
    EXPECT_EQ(first({a, copy, part("b.obj", 1)}), (First{0, 1, 2}));  // which of both?
    EXPECT_EQ(files_cut_apart(std::vector{a, copy, part("b.obj", 1)}, {}, context_).unclear, (First{0, 1, 2}));
    EXPECT_EQ(files_cut_apart(std::vector{a, part("b.obj", 1)}, {}, context_).unclear, (First{}));
}

TEST_F(FilesCutApart, TheWeldDistanceCounts) {
    const std::string a = part("a.obj", 0), b = part("b.obj", 1, false, 1e-3);
    EXPECT_EQ(first({a, b}), (First{0, 1}));
    SmoothFileOptions options;
    options.attributes.weld_distance = 2e-3;
    EXPECT_EQ(first({a, b}, options), (First{0, 0}));
}

TEST_F(FilesCutApart, MirroredPlacementsCountInTheWorld) {
    Mesh mesh = test::quad_mesh();  // with a second one above it
    mesh.positions = std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 2, 0}, {0, 2, 0}};
    mesh.indices = std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3, 3, 2, 4, 3, 4, 5};
    Scene scene;
    scene.meshes = {mesh};
    scene.nodes.emplace_back().meshes = {0};
    scene.nodes[0].local.scale = {-1, 1, 1};
    const std::string left = folder_.file("left.glb"), right = folder_.file("right.glb");
    io::write_glb(scene, left, context_);
    scene.nodes[0].local.scale = {1, 1, 1};
    io::write_glb(scene, right, context_);
    EXPECT_EQ(first({left, right}), (First{0, 0}));
}

TEST_F(FilesCutApart, WhatIsKeptOfEachFileIsCharged) {
    std::ostringstream soup;  // 2000 triangles without a common edge: 2000 * 3 * (3 * 16 bytes) are kept of each file
    for (int i = 0; i < 2000; ++i) soup << "v " << i << " 0 0\nv " << i << " 1 0\nv " << i << " 0 1\nf -3 -2 -1\n";
    std::vector<std::string> files;
    for (int i = 0; i < 40; ++i) files.push_back(folder_.write(std::to_string(i) + ".obj", soup.str()));
    Context small({.max_memory = 4 << 20});
    EXPECT_EQ(files_cut_apart(std::span(files).first(2), {}, small).first, (First{0, 1}));
    EXPECT_THROW(files_cut_apart(files, {}, small), Error);
    EXPECT_EQ(small.memory().charged(), 0u);
    Context cancelled;
    cancelled.cancel();
    EXPECT_THROW(files_cut_apart(files, {}, cancelled), Error);
}

TEST_F(FilesCutApart, AFileThatCannotBeReadIsApart) {
    const std::string broken = folder_.write("broken.obj", "f 1 2 3\n");
    EXPECT_EQ(first({broken, part("a.obj", 0), folder_.file("none.obj"), part("b.obj", 1)}), (First{0, 1, 2, 1}));
}

}  // namespace
}  // namespace rakelight
