// SPDX-License-Identifier: Apache-2.0
#include "prepare/variants.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace rakelight {
namespace {

constexpr float rounding = 2e-6f;
/// Limit of variants searched for an equal one, so that many instances take linear time.
constexpr std::size_t searched = 16;

bool near(float a, float b) { return std::fabs(a - b) <= rounding; }
bool near(vec2 a, vec2 b) { return near(a.x, b.x) && near(a.y, b.y); }
bool near(vec3 a, vec3 b) { return near(a.x, b.x) && near(a.y, b.y) && near(a.z, b.z); }
bool near(vec4 a, vec4 b) { return near(a.xyz(), b.xyz()) && a.w == b.w; }

template <class Array>
bool all_near(const Array& a, const Array& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) { return near(x, y); });
}
template <class T>
bool all_near(const Block<T>& a, const Block<T>& b) {
    return a == b || all_near(a.span(), b.span());
}

/// Of one mesh.
bool are_alike(const MeshAttributes& a, const MeshAttributes& b) {
    return a.indices == b.indices && a.source_vertex == b.source_vertex && all_near(a.normals, b.normals) &&
           all_near(a.tangents, b.tangents) && all_near(a.bitangents, b.bitangents);
}

}  // namespace

bool same_surface(const Mesh& a, const Mesh& b) {
    if (a.positions.size() != b.positions.size() || a.texcoords.size() != b.texcoords.size()) return false;
    if (!(a.indices == b.indices) &&
        !std::equal(a.indices.begin(), a.indices.end(), b.indices.begin(), b.indices.end()))
        return false;
    for (std::size_t set = 0; set < a.texcoords.size(); ++set)
        if (!all_near(a.texcoords[set], b.texcoords[set])) return false;
    return all_near(a.normals, b.normals) && all_near(a.tangents, b.tangents) && all_near(a.bitangents, b.bitangents);
}

std::vector<std::size_t> first_alike(std::span<const std::uint32_t> numbers, std::span<const MeshAttributes> results) {
    std::map<std::uint32_t, std::vector<std::size_t>> firsts;  // by mesh
    std::vector<std::size_t> alike(results.size());
    for (std::size_t r = 0; r < results.size(); ++r) {
        std::vector<std::size_t>& known = firsts[numbers[r]];
        const auto end = known.begin() + std::ptrdiff_t(std::min(known.size(), searched));
        const auto same =
            std::find_if(known.begin(), end, [&](std::size_t first) { return are_alike(results[first], results[r]); });
        alike[r] = same == end ? r : *same;
        if (alike[r] == r) known.push_back(r);
    }
    return alike;
}

std::vector<Instance> drawn_instances(const Scene& scene) {
    std::vector<Instance> instances;
    for (std::uint32_t node = 0; node < scene.nodes.size(); ++node) {
        const auto& meshes = scene.nodes[node].meshes;
        for (std::uint32_t slot = 0; slot < meshes.size(); ++slot)
            if (scene.meshes[meshes[slot]].triangle_count() > 0) instances.push_back({node, slot, meshes[slot]});
    }
    return instances;
}

std::uint32_t MeshVariants::place(const Instance& instance, Mesh result) {
    std::vector<std::uint32_t>& made = made_[instance.mesh];
    std::uint32_t number = no_index;
    for (std::size_t i = 0; i < std::min(made.size(), searched) && number == no_index; ++i)
        if (same_surface(scene_.meshes[made[i]], result)) number = made[i];
    if (number == no_index && keep_shared_ && !made.empty()) {
        number = made[0];
        ++kept_;
    }
    if (number == no_index) {
        if (made.empty()) {
            number = instance.mesh;
            scene_.meshes[number] = std::move(result);
        } else {
            number = added_.add(std::move(result));
        }
        made.push_back(number);
    }
    share(instance, number);
    return number;
}

void MeshVariants::share(const Instance& instance, std::uint32_t number) {
    scene_.nodes[instance.node].meshes[instance.slot] = number;
}

}  // namespace rakelight
