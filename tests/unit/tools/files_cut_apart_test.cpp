// SPDX-License-Identifier: Apache-2.0
// Which files are pieces of one surface: squares of one strip, as OBJ files.
#include <gtest/gtest.h>

#include <sstream>

#include <rakelight/smooth_file.h>

#include "io/glb_writer.h"
#include "support/temporary_folder.h"
#include "unit/prepare/meshes.h"

namespace rakelight {
namespace {

using First = std::vector<std::uint32_t>;

class FilesCutApart : public testing::Test {
protected:
    /// Unit squares from x = 0 on, counter-clockwise seen from +Z; `is_back` the other way round.
    std::string square(const std::string& name, double x, bool is_back = false, double z = 0) {
        std::ostringstream file;
        for (const auto& [dx, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
            file << "v " << x + dx << ' ' << y << ' ' << z << '\n';
        file << (is_back ? "f 4 3 2 1\n" : "f 1 2 3 4\n");
        return folder_.write(name, file.str());
    }
    First first(const std::vector<std::string>& files, const SmoothFileOptions& options = {}) {
        return files_cut_apart(files, options, context_);
    }

    const test::TemporaryFolder folder_;
    Context context_;
};

TEST_F(FilesCutApart, NeighborsContinueEachOtherInAnyOrder) {
    const std::string a = square("a.obj", 0), b = square("b.obj", 1), c = square("c.obj", 2), far = square("f.obj", 9);
    EXPECT_EQ(first({a, b}), (First{0, 0}));
    EXPECT_EQ(first({a, c}), (First{0, 1}));
    EXPECT_EQ(first({far, c, a, b}), (First{0, 1, 1, 1}));
    EXPECT_EQ(first({a}), (First{0}));
    EXPECT_EQ(first({}), (First{}));
}

TEST_F(FilesCutApart, VariantsAndTouchingModelsAreApart) {
    const std::string a = square("a.obj", 0), copy = square("copy.obj", 0), back = square("back.obj", 1, true);
    EXPECT_EQ(first({a, copy}), (First{0, 1}));
    EXPECT_EQ(first({a, back}), (First{0, 1}));  // its edge runs as that of `a` does
    // A closed box at the edge of the square has no open edge.
    std::ostringstream file;
    for (int i = 0; i < 8; ++i) file << "v " << 1 + (i & 1) << ' ' << (i >> 1 & 1) << ' ' << (i >> 2) << '\n';
    file << "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
    EXPECT_EQ(first({a, folder_.write("box.obj", file.str())}), (First{0, 1}));
    EXPECT_EQ(first({a, copy, square("b.obj", 1)}), (First{0, 1, 2}));  // which of both?
}

TEST_F(FilesCutApart, TheWeldDistanceCounts) {
    const std::string a = square("a.obj", 0), b = square("b.obj", 1, false, 1e-3);
    EXPECT_EQ(first({a, b}), (First{0, 1}));
    SmoothFileOptions options;
    options.attributes.weld_distance = 2e-3;
    EXPECT_EQ(first({a, b}, options), (First{0, 0}));
}

TEST_F(FilesCutApart, MirroredPlacementsCountInTheWorld) {
    Scene scene = test::scene_of({test::quad_mesh()});
    scene.nodes[0].local.scale = {-1, 1, 1};
    const std::string left = folder_.file("left.glb"), right = folder_.file("right.glb");
    io::write_glb(scene, left, context_);
    scene.nodes[0].local.scale = {1, 1, 1};
    io::write_glb(scene, right, context_);
    EXPECT_EQ(first({left, right}), (First{0, 0}));
}

TEST_F(FilesCutApart, AFileThatCannotBeReadIsApart) {
    const std::string broken = folder_.write("broken.obj", "f 1 2 3\n");
    EXPECT_EQ(first({broken, square("a.obj", 0), folder_.file("none.obj"), square("b.obj", 1)}), (First{0, 1, 2, 1}));
}

}  // namespace
}  // namespace rakelight
