// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "math/linear.h"
#include "prepare/normals/missing_normals.h"
#include "prepare/repair/repair.h"
#include "scene/is_normal.h"

namespace rakelight {
namespace {

constexpr float unit_tolerance = 1e-3f;       // below this a vector counts as unit and its block stays shared
constexpr float quantized_tolerance = 2e-2f;  // normal precision of unit vectors stored as bytes, about 1 / 127
constexpr float huge_texcoord = 1e6f;         // beyond this, float texel coordinates have no fractional digits

/// Statistics of an array of directions, in one pass.
struct DirectionCheck {
    std::size_t broken = 0;  ///< zero or not finite
    float off_unit = 0;      ///< largest | |v|^2 - 1 | of the others
};

template <class T>
vec3 direction(const T& v) {
    return {v.x, v.y, v.z};
}

template <class T>
DirectionCheck check_directions(const Block<T>& block) {
    DirectionCheck check;
    for (const T& v : block) {
        const vec3 d = direction(v);
        const float off = std::fabs(dot(d, d) - 1);
        if (off <= 2 * unit_tolerance) {
            check.off_unit = std::max(check.off_unit, off);
        } else if (!is_normal(d)) {
            ++check.broken;
        } else {
            check.off_unit = std::isfinite(off) ? std::max(check.off_unit, off) : std::numeric_limits<float>::max();
        }
    }
    return check;
}

/// Whether any tangent is parallel to its normal within 0.06 degrees.
bool has_parallel_tangents(const Mesh& mesh) {
    constexpr double min_sine = 1e-3;
    for (std::size_t v = 0; v < mesh.tangents.size(); ++v) {
        const dvec3 n = cast<double>(mesh.normals[v]), t = cast<double>(mesh.tangents[v].xyz());
        if (n == dvec3{}) continue;  // to be made
        const dvec3 across = cross(n, t);
        if (!(dot(across, across) > min_sine * min_sine * dot(n, n) * dot(t, t))) return true;
    }
    return false;
}

void report_lengths(const char* what, float off_unit, std::vector<Finding>& findings) {
    if (off_unit <= 2 * unit_tolerance) return;
    findings.push_back({off_unit <= 2 * quantized_tolerance ? Remark::note : Remark::changed,
                        std::string(what) + " that are not of unit length were made so"});
}

}  // namespace

void repair_texcoords(Mesh& mesh, bool is_textured, std::vector<Finding>& findings) {
    for (Block<vec2>& set : mesh.texcoords) {
        if (set.empty()) continue;
        bool finite = true, huge = false, varies = false;
        const vec2 first = set[0];
        for (const vec2& uv : set) {
            if (!std::isfinite(uv.x) || !std::isfinite(uv.y))
                finite = false;
            else if (std::fabs(uv.x) > huge_texcoord || std::fabs(uv.y) > huge_texcoord)
                huge = true;
            varies = varies || !(uv == first);
        }
        if (huge)
            findings.push_back({Remark::warning, "texture coordinates beyond 1e6: the texture has no detail there"});
        if (!varies && is_textured)
            findings.push_back(
                {Remark::warning,
                 "all texture coordinates are the same: the texture has one color and no tangent direction"});
        if (finite) continue;
        findings.push_back({Remark::changed, "texture coordinates that are not finite were set to 0"});
        std::vector<vec2> values(set.begin(), set.end());
        for (vec2& uv : values)
            if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) uv = {0, 0};
        set = std::move(values);
    }
}

void repair_normals(Mesh& mesh, std::vector<Finding>& findings) {
    const DirectionCheck check = check_directions(mesh.normals);
    if (check.broken == 0 && check.off_unit <= 2 * unit_tolerance) return;
    const NormalGaps gaps = drop_if_all_gaps(mesh, findings);
    if (mesh.normals.empty()) return;
    report_lengths("normals", check.off_unit, findings);
    std::vector<vec3> normals(mesh.normals.begin(), mesh.normals.end());
    for (std::size_t v = 0; v < normals.size(); ++v) {
        const bool is_gap = !gaps.at.empty() && gaps.at[v] != 0;
        normals[v] = cast<float>(normalize_or(cast<double>(normals[v]), dvec3{0, 0, is_gap ? 0.0 : 1.0}));
    }
    mesh.normals = std::move(normals);
}

void repair_tangents(Mesh& mesh, std::vector<Finding>& findings) {
    if (mesh.tangents.empty()) return;
    if (mesh.normals.empty()) {
        findings.push_back({Remark::note, "tangents without normals are not used"});  // as glTF 2.0 says
        mesh.tangents = {};
        return;
    }
    const DirectionCheck check = check_directions(mesh.tangents);
    const bool signs_exact =
        std::all_of(mesh.tangents.begin(), mesh.tangents.end(), [](const vec4& t) { return std::fabs(t.w) == 1; });
    const bool signs_right = signs_exact || std::all_of(mesh.tangents.begin(), mesh.tangents.end(), [](const vec4& t) {
                                 return std::fabs(std::fabs(t.w) - 1) <= unit_tolerance;  // false for NaN
                             });
    const char* const fault = check.broken > 0              ? "tangents that are zero or not finite"
                              : !signs_right                ? "tangents whose w is not +1 or -1"
                              : has_parallel_tangents(mesh) ? "tangents that are parallel to their normals"
                                                            : nullptr;
    if (fault) {
        findings.push_back({Remark::warning, std::string(fault) + ": all of the mesh are computed anew"});
        mesh.tangents = {};
        return;
    }
    if (signs_exact && check.off_unit <= 2 * unit_tolerance) return;
    report_lengths("tangents", check.off_unit, findings);
    std::vector<vec4> tangents(mesh.tangents.begin(), mesh.tangents.end());
    for (vec4& t : tangents) {
        const dvec3 d = normalize_or(cast<double>(t.xyz()), dvec3{1, 0, 0});
        t = {float(d.x), float(d.y), float(d.z), t.w < 0 ? -1.0f : 1.0f};
    }
    mesh.tangents = std::move(tangents);
}

}  // namespace rakelight
