// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/plausibility.h"

#include <algorithm>
#include <cmath>

#include "math/linear.h"

namespace rakelight::io::gltf {
namespace {

/// Beyond these, squares of lengths leave float's range (1e38 and 1e-38).
constexpr float too_large = 1e18f, too_small = 1e-18f;
constexpr float texcoord_limit = 16777216;  // 2^24: a float there has no fraction left to sample with

class Remarks {
public:
    Remarks(const Document& document, const std::string& place) : document_(document), place_(place) {}
    void say(const std::string& what) const { document_.remark(Remark::warning, place_, what); }
    void count(std::uint64_t n, const char* what) const {
        if (n) say(std::to_string(n) + " " + what);
    }

private:
    const Document& document_;
    const std::string& place_;
};

template <class T, class Test>
std::uint64_t count_if(const Block<T>& block, Test test) {
    return std::uint64_t(std::count_if(block.begin(), block.end(), test));
}

bool has_area(const Mesh& mesh) {
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const dvec3 a = cast<double>(mesh.positions[mesh.indices[i]]),
                    b = cast<double>(mesh.positions[mesh.indices[i + 1]]),
                    c = cast<double>(mesh.positions[mesh.indices[i + 2]]);
        const dvec3 n = cross(b - a, c - a);
        if (n.x != 0 || n.y != 0 || n.z != 0) return true;  // true for NaN too: that is counted elsewhere
    }
    return false;
}

void on_positions(const Remarks& remarks, const Mesh& mesh) {
    vec3 low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
    std::uint64_t bad = 0;
    for (const vec3& p : mesh.positions) {
        if (!is_finite(p)) {
            ++bad;
            continue;
        }
        low = min(low, p);
        high = max(high, p);
    }
    remarks.count(bad, "positions are not finite");
    if (bad == mesh.positions.size()) return;
    const float farthest = std::max({-low.x, -low.y, -low.z, high.x, high.y, high.z});
    const float extent = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
    if (farthest > too_large) remarks.say("its positions are so large that their squares overflow");
    if (mesh.topology == Topology::points) return;
    if (extent == 0)
        remarks.say("all its vertices lie at one point");
    else if (extent < too_small)
        remarks.say("its extent is so small that areas underflow");
    else if (mesh.topology == Topology::triangles && !has_area(mesh))
        remarks.say("all its triangles have zero area");
}

void on_directions(const Remarks& remarks, const Mesh& mesh) {
    remarks.count(count_if(mesh.normals, [](const vec3& n) { return !is_finite(n); }), "normals are not finite");
    remarks.count(count_if(mesh.normals, [](const vec3& n) { return n == vec3{0, 0, 0}; }), "normals are zero");
    remarks.count(count_if(mesh.tangents, [](const vec4& t) { return !is_finite(t.xyz()) || !std::isfinite(t.w); }),
                  "tangents are not finite");
    remarks.count(count_if(mesh.tangents, [](const vec4& t) { return t.w == 0; }),
                  "tangents have no handedness (w = 0)");
}

void on_texcoords(const Remarks& remarks, const Mesh& mesh, bool is_textured) {
    for (const Block<vec2>& set : mesh.texcoords) {
        const auto is_bad = [](const vec2& t) { return !std::isfinite(t.x) || !std::isfinite(t.y); };
        remarks.count(count_if(set, is_bad), "texture coordinates are not finite");
        const auto is_huge = [&](const vec2& t) {
            return !is_bad(t) && std::max(std::fabs(t.x), std::fabs(t.y)) > texcoord_limit;
        };
        remarks.count(count_if(set, is_huge), "texture coordinates are so large that nothing can be sampled there");
        const auto differs = [&](const vec2& t) { return !(t == set[0]); };
        if (is_textured && set.size() > 1 && mesh.topology == Topology::triangles &&
            std::none_of(set.begin(), set.end(), differs))
            remarks.say("all its texture coordinates are equal");
    }
}

}  // namespace

void remark_on_mesh(const Document& document, const Mesh& mesh, const Material* material, const std::string& place) {
    const Remarks remarks(document, place);
    on_positions(remarks, mesh);
    on_directions(remarks, mesh);
    on_texcoords(remarks, mesh, material && (material->base_color_texture || material->normal_texture));
}

void remark_on_quantization(const Document& document, const Accessors& accessors, const Value& primitive) {
    if (document.uses("KHR_mesh_quantization")) return;
    const Value attributes = primitive.object("attributes");
    for (const char* name : {"POSITION", "NORMAL", "TANGENT"}) {
        const std::uint32_t accessor = attributes.index(name);
        if (accessor == none) continue;
        const Elements elements = accessors.description(accessor, {name, ~0u, ~0u}, primitive);
        if (elements.type != ComponentType::f32)
            document.remark(Remark::warning, primitive.place(),
                            std::string(name) + " has integers though the file does not use KHR_mesh_quantization");
    }
}

}  // namespace rakelight::io::gltf
