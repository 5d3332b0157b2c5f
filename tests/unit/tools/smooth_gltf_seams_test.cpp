// SPDX-License-Identifier: Apache-2.0
// Parts of glTF models whose vertices do not stand where they meet by the file's numbers alone: quantized and skinned ones; and
// those that move: morph targets.
#include <gtest/gtest.h>

#include <rakelight/rakelight.h>

#include "math/linear.h"
#include "unit/io/gltf/gltf_support.h"

namespace rakelight {
namespace {

using namespace test;

/// All normals are made, whatever the file has.
const SmoothFileOptions anew{.authored = AuthoredNormals::replaced};

constexpr int columns = 12, rows = 9, cut_at = 5;

/// A dome as a grid of codes: vertex (c, r) at (c, r, height) * 256.
std::int16_t height(int c, int r) { return std::int16_t(40 * (c * (columns - c) + r * (rows - r))); }

struct Part {
    std::vector<std::int16_t> codes;
    std::vector<std::uint16_t> indices;
    std::vector<std::size_t> border;  ///< [rows + 1] vertices of the column where it is cut
};

/// The columns from `first` to `last`; the codes of the border moved by `shift`.
Part part(int first, int last, std::array<int, 3> shift) {
    Part p;
    for (int r = 0; r <= rows; ++r)
        for (int c = first; c <= last; ++c) {
            const bool at_border = c == cut_at;
            if (at_border) p.border.push_back(p.codes.size() / 3);
            const int values[] = {256 * c, 256 * r, height(c, r)};
            for (std::size_t k = 0; k < 3; ++k) p.codes.push_back(std::int16_t(values[k] + (at_border ? shift[k] : 0)));
        }
    const int width = last - first + 1;
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c + 1 < width; ++c) {
            const int v = r * width + c;
            for (const int i : {v, v + 1, v + width + 1, v, v + width + 1, v + width})
                p.indices.push_back(std::uint16_t(i));
        }
    return p;
}

std::array<Part, 2> two_parts(std::array<int, 3> shift) {
    return {part(0, cut_at, {0, 0, 0}), part(cut_at, columns, shift)};
}

/// Two nodes of one mesh each over 16-bit positions.
GltfFile quantized_file(const std::array<Part, 2>& parts, bool normalized) {
    GltfFile file;
    file.root["extensionsUsed"] = file.root["extensionsRequired"] = {"KHR_mesh_quantization"};
    file.root["scenes"][0]["nodes"] = {0, 1};
    const double scale = normalized ? 32767.0 / 4096 : 1.0 / 4096;
    for (std::size_t n = 0; n < 2; ++n) {
        const int positions = file.accessor(parts[n].codes, i16, 3, normalized),
                  indices = file.accessor(parts[n].indices, u16, 1);
        file.root["accessors"][positions]["min"] = {-32768, -32768, -32768};
        file.root["accessors"][positions]["max"] = {32767, 32767, 32767};
        file.root["meshes"][n]["primitives"] = {{{"attributes", {{"POSITION", positions}}}, {"indices", indices}}};
        file.root["nodes"][n] = {{"mesh", n}, {"scale", {scale, scale, scale}}, {"translation", {7, 0, 0}}};
    }
    return file;
}

std::string write(const TemporaryFolder& folder, GltfFile& file) {
    const std::string text = file.text();
    folder.write("data.bin", file.data);
    return folder.write("model.gltf", text);
}

/// How many of the border's vertices have other normals than their neighbors in the other part, by bits.
std::size_t seams(const Scene& scene, const std::array<Part, 2>& parts) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < parts[0].border.size(); ++i)
        count += !(scene.meshes[0].normals[parts[0].border[i]] == scene.meshes[1].normals[parts[1].border[i]]);
    return count;
}

TEST(SmoothQuantized, BordersWhoseCodesDifferByAStepHaveOneNormal) {
    for (const bool normalized : {false, true})
        for (const auto& shift : {std::array{1, 0, 0}, {0, -1, 1}, {-1, 1, 1}}) {
            const auto parts = two_parts(shift);
            GltfFile file = quantized_file(parts, normalized);
            const TemporaryFolder folder;
            const std::string model = write(folder, file), out = (folder.path() / "out.gltf").string();
            Context context;
            PrepareOptions options;
            options.normals = NormalSource::model;
            Scene scene = load(model, {}, context);
            EXPECT_EQ(seams(prepare_scene(scene, options, context), parts), 0u);
            smooth_file(model, out, anew, context);
            const Scene smoothed = load(out, {}, context);
            EXPECT_EQ(seams(smoothed, parts), 0u) << "as it is written";
            for (std::size_t m = 0; m < 2; ++m) {
                EXPECT_GT(smoothed.meshes[m].position_step, 0) << "positions stay as they were";
                EXPECT_TRUE(std::equal(scene.meshes[m].positions.begin(), scene.meshes[m].positions.end(),
                                       smoothed.meshes[m].positions.begin()));
            }
            for (Mesh& mesh : scene.meshes) mesh.position_step = 0;  // without the step there is a seam
            EXPECT_EQ(seams(prepare_scene(scene, options, context), parts), std::size_t(rows + 1));
        }
}

TEST(SmoothQuantized, TheSecondRunChangesNothing) {
    GltfFile file = quantized_file(two_parts({1, -1, 0}), true);
    const TemporaryFolder folder;
    const std::string model = write(folder, file), out = (folder.path() / "out.glb").string();
    Context context;
    EXPECT_TRUE(smooth_file(model, out, anew, context).changed);
    EXPECT_FALSE(smooth_file(out, (folder.path() / "again.glb").string(), anew, context).changed);
}

// Quantized skinned models leave the scale to the inverse bind matrices; the nodes' own transforms do not count.
TEST(SmoothSkinned, PartsOfOneModelHaveOneNormalWhereverTheirNodesAre) {
    const auto parts = two_parts({1, 0, 0});
    GltfFile file = quantized_file(parts, true);
    const float s = 32767.0f / 4096;
    const int inverse_bind = file.accessor<float>({s, 0, 0, 0, 0, s, 0, 0, 0, 0, s, 0, -1, -2, 0, 1}, f32, 16);
    file.root["nodes"][1]["translation"] = {0, 50, 0};
    file.root["nodes"].push_back({{"translation", {1, 2, 0}}});
    file.root["scenes"][0]["nodes"].push_back(2);
    file.root["skins"] = {{{"joints", {2}}, {"inverseBindMatrices", inverse_bind}}};
    for (std::size_t n = 0; n < 2; ++n) {
        const std::size_t vertices = parts[n].codes.size() / 3;
        std::vector<std::uint8_t> joints(4 * vertices, 0), weights(4 * vertices, 0);
        for (std::size_t v = 0; v < vertices; ++v) weights[4 * v] = 255;
        auto& attributes = file.root["meshes"][n]["primitives"][0]["attributes"];
        attributes["JOINTS_0"] = file.accessor(joints, u8, 4);
        attributes["WEIGHTS_0"] = file.accessor(weights, u8, 4, true);
        file.root["nodes"][n]["skin"] = 0;
    }
    const TemporaryFolder folder;
    const std::string model = write(folder, file), out = (folder.path() / "out.gltf").string();
    Context context;
    smooth_file(model, out, anew, context);
    EXPECT_EQ(seams(load(out, {}, context), parts), 0u);
    EXPECT_FALSE(is_said(context, Remark::warning, "part in motion"));
}

/// Offsets by which the dome bulges out once more: float, for all of a part's vertices.
std::vector<float> bulge(const Part& p) {
    std::vector<float> offsets;
    for (std::size_t v = 0; v < p.codes.size(); v += 3)
        offsets.insert(offsets.end(), {0, 0, 0.9f * float(p.codes[v + 2])});
    return offsets;
}

/// The two parts with float positions and a morph target each.
GltfFile morphed_file(const std::array<Part, 2>& parts, bool with_normals) {
    GltfFile file = quantized_file(parts, false);
    file.root.erase("extensionsUsed"), file.root.erase("extensionsRequired");
    for (std::size_t n = 0; n < 2; ++n) {
        const std::vector<float> positions(parts[n].codes.begin(), parts[n].codes.end());
        auto& primitive = file.root["meshes"][n]["primitives"][0];
        primitive["attributes"]["POSITION"] = file.accessor(positions, f32, 3);
        primitive["targets"] = {{{"POSITION", file.accessor(bulge(parts[n]), f32, 3)}}};
        file.root["meshes"][n]["extras"]["targetNames"] = {"bulge"};
        if (!with_normals) continue;
        std::vector<float> up, none(positions.size(), 0.0f);
        for (std::size_t v = 0; v < positions.size() / 3; ++v) up.insert(up.end(), {0, 0, 1});
        primitive["attributes"]["NORMAL"] = file.accessor(up, f32, 3);
        primitive["targets"][0]["NORMAL"] = file.accessor(none, f32, 3);
    }
    return file;
}

/// The same parts as they are when the target has its full weight.
Scene bulged(const Scene& scene) {
    Scene out = scene;
    for (Mesh& mesh : out.meshes) {
        std::vector<vec3> positions;
        for (std::size_t v = 0; v < mesh.positions.size(); ++v)
            positions.push_back(mesh.positions[v] + mesh.targets[0].positions[v]);
        mesh.positions = std::move(positions);
        mesh.targets = {};
        mesh.normals = {};
    }
    return out;
}

TEST(SmoothMorphed, TargetsGetTheNormalsOfTheMorphedSurface) {
    for (const bool with_normals : {false, true})
        for (const char* name : {"out.gltf", "out.glb"}) {
            GltfFile file = morphed_file(two_parts({0, 0, 0}), with_normals);
            const TemporaryFolder folder;
            const std::string model = write(folder, file), out = (folder.path() / name).string();
            Context context;
            smooth_file(model, out, anew, context);
            EXPECT_FALSE(is_said(context, Remark::warning, "morph targets"));
            const Scene got = load(out, {}, context);
            AttributeOptions options;
            options.tangents = false;
            const Scene expected = smooth(bulged(load(model, {}, context)), options, context);
            for (std::size_t m = 0; m < 2; ++m) {
                const Mesh& mesh = got.meshes[m];
                ASSERT_EQ(mesh.targets.size(), 1u);
                ASSERT_EQ(mesh.targets[0].normals.size(), mesh.positions.size());
                for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
                    const vec3 n = mesh.normals[v] + mesh.targets[0].normals[v], wanted = expected.meshes[m].normals[v];
                    EXPECT_LT(std::fabs(n.x - wanted.x) + std::fabs(n.y - wanted.y) + std::fabs(n.z - wanted.z), 1e-5f);
                }
            }
            EXPECT_FALSE(smooth_file(out, (folder.path() / "again.glb").string(), anew, context).changed);
        }
}

TEST(SmoothMorphed, ATargetWithoutNormalsBesideAMeshWithSomeStaysSo) {
    GltfFile file = morphed_file(two_parts({0, 0, 0}), true);
    file.root["meshes"][1]["primitives"][0]["targets"][0].erase("NORMAL");
    const TemporaryFolder folder;
    const std::string model = write(folder, file), out = (folder.path() / "out.glb").string();
    Context context;
    smooth_file(model, out, anew, context);
    const Scene got = load(out, {}, context);
    EXPECT_FALSE(got.meshes[0].targets[0].normals.empty());
    EXPECT_TRUE(got.meshes[1].targets[0].normals.empty());
}

TEST(SmoothMorphed, SplitVerticesCarryTheirTargets) {
    GltfFile file = morphed_file(two_parts({0, 0, 0}), true);
    const TemporaryFolder folder;
    const std::string model = write(folder, file), out = (folder.path() / "out.glb").string();
    Context context;
    SmoothFileOptions options = anew;
    options.attributes.scope = Scope::face;
    smooth_file(model, out, options, context);
    const Scene before = load(model, {}, context), got = load(out, {}, context);
    for (std::size_t m = 0; m < 2; ++m) {
        const Mesh &mesh = got.meshes[m], &old = before.meshes[m];
        ASSERT_GT(mesh.positions.size(), old.positions.size());
        ASSERT_EQ(mesh.targets[0].normals.size(), mesh.positions.size());
        for (std::size_t c = 0; c < mesh.indices.size(); ++c)
            EXPECT_EQ(mesh.targets[0].positions[mesh.indices[c]], old.targets[0].positions[old.indices[c]]);
    }
}

}  // namespace
}  // namespace rakelight
