// SPDX-License-Identifier: Apache-2.0
// Posed vertices against other programs: three.js, and where that departs from glTF an evaluation in double (tests/poses).
#include <gtest/gtest.h>
#include <rakelight/prepare/prepare.h>
#include <rakelight/scene/motion.h>
#include <rakelight/world/load.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "math/linear.h"
#include "scene/placement.h"
#include "support/shared.h"

namespace rakelight {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

fs::path folder() { return test::source_dir() / "tests/poses"; }

Json read(const fs::path& path) {
    std::ifstream in(path);
    return Json::parse(in);
}

/// [node of the file, primitive, vertex] -> place in the world.
class Places {
public:
    explicit Places(const Scene& posed) : posed_(posed), world_(world_matrices(posed)) {
        for (std::uint32_t n = 0; n < posed.nodes.size(); ++n)
            for (const std::uint32_t m : posed.nodes[n].meshes)
                meshes_[{posed.nodes[n].source_node, posed.meshes[m].source_primitive}] = {n, m};
    }
    bool has(std::uint32_t node, std::uint32_t primitive) const { return meshes_.contains({node, primitive}); }
    dvec3 at(std::uint32_t node, std::uint32_t primitive, std::uint32_t vertex) const {
        const auto [n, m] = meshes_.at({node, primitive});
        const Mesh& mesh = posed_.meshes[m];
        return transform_point(world_[n] * translation(mesh.origin), cast<double>(mesh.positions[vertex]));
    }
    vec3 normal(std::uint32_t node, std::uint32_t primitive, std::uint32_t vertex) const {
        const auto [n, m] = meshes_.at({node, primitive});
        const dmat3 turn = cofactor(upper_left(world_[n]));
        const double side = determinant(upper_left(world_[n])) < 0 ? -1 : 1;
        return cast<float>(normalize_or(turn * cast<double>(posed_.meshes[m].normals[vertex]) * side, dvec3{0, 0, 0}));
    }

private:
    const Scene& posed_;
    std::vector<dmat4> world_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<std::uint32_t, std::uint32_t>> meshes_;
};

Scene posed(const Scene& scene, const Json& pose, Context& context) {
    Scene at = scene;
    if (!pose["clip"].is_null()) {
        const ClipTime clip{pose["clip"], pose["time"]};
        at = scene_at(at, std::span(&clip, 1));
    }
    return posed_scene(at, context);
}

/// @return points that were compared
std::size_t compare(const Json& reference, const fs::path& model) {
    Context context;
    const Scene scene = load(model.string(), {}, context);
    const double size = reference["size"], tolerance = reference.value("tolerance", 1e-5) * size;
    std::size_t count = 0;
    for (const Json& pose : reference["poses"]) {
        const std::string where =
            model.filename().string() + " clip " + pose["clip"].dump() + " time " + pose["time"].dump();
        const Scene standing = posed(scene, pose, context);
        const Places places(standing);
        for (const Json& p : pose["points"]) {
            if (!places.has(p[0], p[1])) {
                ADD_FAILURE() << where << ": nothing stands for node " << p[0] << " primitive " << p[1];
                break;
            }
            const dvec3 wanted{p[3], p[4], p[5]}, got = places.at(p[0], p[1], p[2]);
            EXPECT_LE(length(got - wanted), tolerance) << where << " node " << p[0] << " vertex " << p[2];
            ++count;
            if (testing::Test::HasFailure()) return count;
        }
        for (const Json& p : pose.value("normals", Json::array())) {
            const vec3 wanted{p[3], p[4], p[5]}, got = places.normal(p[0], p[1], p[2]);
            EXPECT_LE(length(got - wanted), 1e-5f) << where << " normal of node " << p[0] << " vertex " << p[2];
        }
    }
    return count;
}

fs::path model_of(const Json& reference) {
    const std::string name = reference["model"];
    return name.starts_with("cases/") ? folder() / name : test::shared_dir() / "assets" / name;
}

class PoseReference : public testing::TestWithParam<std::string> {};

TEST_P(PoseReference, PutsVerticesWhereOtherProgramsDo) {
    const Json reference = read(folder() / "positions" / GetParam());
    const fs::path model = model_of(reference);
    if (!fs::exists(model)) GTEST_SKIP() << model << " is not there";
    EXPECT_GT(compare(reference, model), 0u);
}

std::vector<std::string> all_references() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder() / "positions")) names.push_back(entry.path().filename());
    // The eight strongest joints of a vertex are kept: where there are more, the reference that says what of these.
    std::erase_if(names, [&](const std::string& name) {
        return fs::exists(folder() / "positions" / (fs::path(name).stem().string() + ".strongest8.json"));
    });
    std::sort(names.begin(), names.end());
    return names;
}

INSTANTIATE_TEST_SUITE_P(All, PoseReference, testing::ValuesIn(all_references()), [](const auto& of) {
    std::string name = of.param;
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return name;
});

}  // namespace
}  // namespace rakelight
