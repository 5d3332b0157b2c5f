// SPDX-License-Identifier: Apache-2.0
#include "geometry/skin.h"

#include <algorithm>
#include <cmath>

#include "math/linear.h"

namespace rakelight::geometry {
namespace {

constexpr std::size_t chunk = 4096;  // vertices at a time

/// Four floats that go together: the compiler makes one vector instruction of each operation, and every instruction set
/// rounds it in the same way.
struct Four {
    float v[4];
};
inline Four operator*(Four a, float s) { return {{a.v[0] * s, a.v[1] * s, a.v[2] * s, a.v[3] * s}}; }
inline Four operator+(Four a, Four b) { return {{a.v[0] + b.v[0], a.v[1] + b.v[1], a.v[2] + b.v[2], a.v[3] + b.v[3]}}; }
inline Four four(const std::array<float, 4>& a) { return {{a[0], a[1], a[2], a[3]}}; }
inline vec3 xyz(Four a) { return {a.v[0], a.v[1], a.v[2]}; }

struct Blended {
    Four x, y, z, w;  ///< columns
};

void add(const SkinInput& in, const JointInfluence& influence, Blended& sum) {
    for (std::size_t k = 0; k < 4; ++k) {
        const float weight = influence.weights[k];
        if (weight == 0) continue;
        const JointColumns& joint = in.joints[influence.joints[k]];
        sum.x = sum.x + four(joint.columns[0]) * weight;
        sum.y = sum.y + four(joint.columns[1]) * weight;
        sum.z = sum.z + four(joint.columns[2]) * weight;
        sum.w = sum.w + four(joint.columns[3]) * weight;
    }
}

bool has_weight(const JointInfluence& influence) {
    return influence.weights[0] != 0 || influence.weights[1] != 0 || influence.weights[2] != 0 ||
           influence.weights[3] != 0;
}

Blended blended(const SkinInput& in, std::size_t v) {
    Blended sum{};
    if (!has_weight(in.influences[v])) {  // the strongest stand first
        const JointColumns& joint = in.joints[0];
        return {four(joint.columns[0]), four(joint.columns[1]), four(joint.columns[2]), four(joint.columns[3])};
    }
    add(in, in.influences[v], sum);
    if (!in.more_influences.empty()) add(in, in.more_influences[v], sum);
    return sum;
}

vec3 unit_or(vec3 d, vec3 fallback) {
    const float squared = dot(d, d);
    if (squared > 1e-30f && squared < 1e30f) return d * (1 / std::sqrt(squared));
    return normalize_or(d, fallback);  // what may under- or overflow
}

vec3 direction(const Blended& m, vec3 d) { return xyz(m.x * d.x + m.y * d.y + m.z * d.z); }

void skin_directions(const SkinInput& in, const SkinOutput& out, const Blended& m, std::size_t v) {
    const vec3 x = xyz(m.x), y = xyz(m.y), z = xyz(m.z);
    const vec3 yz = cross(y, z);
    const float side = dot(x, yz) < 0 ? -1.0f : 1.0f;  // the cofactor matrix turns normals inside out where m mirrors
    if (!in.normals.empty()) {
        const vec3 n = in.normals[v];
        out.normals[v] = unit_or((yz * n.x + cross(z, x) * n.y + cross(x, y) * n.z) * side, n);
    }
    if (!in.tangents.empty()) {
        const vec4 t = in.tangents[v];
        const vec3 turned = unit_or(direction(m, t.xyz()), t.xyz());
        out.tangents[v] = {turned.x, turned.y, turned.z, t.w * side};
    }
}

}  // namespace

void skin_vertices(const SkinInput& in, const SkinOutput& out, Context& context) {
    const std::size_t count = in.positions.size();
    const bool has_directions = !in.normals.empty() || !in.tangents.empty();
    context.parallel_for((count + chunk - 1) / chunk, [&](std::size_t c) {
        for (std::size_t v = c * chunk; v < std::min(count, (c + 1) * chunk); ++v) {
            const Blended m = blended(in, v);
            const vec3 p = in.positions[v];
            out.positions[v] = xyz(m.x * p.x + m.y * p.y + m.z * p.z + m.w);
            if (has_directions) skin_directions(in, out, m, v);
        }
    });
}

}  // namespace rakelight::geometry
