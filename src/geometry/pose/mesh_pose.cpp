// SPDX-License-Identifier: Apache-2.0
#include "geometry/pose/mesh_pose.h"

#include <algorithm>
#include <array>
#include <limits>

#include "geometry/pose/morph.h"
#include "math/linear.h"

namespace rakelight::geometry {
namespace {

constexpr std::size_t chunk = 1024;  // vertices at a time, as morph.cpp has them

std::vector<WeightedTarget> counting(const MeshPose& pose, Block<vec3> MorphTarget::*offsets) {
    std::vector<WeightedTarget> result;
    for (std::size_t t = 0; t < pose.targets.size(); ++t)
        if (pose.weight(t) != 0 && !(pose.targets[t].*offsets).empty())
            result.push_back({pose.weight(t), (pose.targets[t].*offsets).span()});
    return result;
}

/// A block to be filled by the caller.
template <class T>
std::vector<T> room_for(const Block<T>& block) {
    return std::vector<T>(block.size());
}

void morph(const MeshPose& pose, PosedArrays& arrays, Context& context) {
    const auto positions = counting(pose, &MorphTarget::positions);
    const auto normals = counting(pose, &MorphTarget::normals);
    const auto tangents = counting(pose, &MorphTarget::tangents);
    if (!positions.empty()) {
        auto out = room_for(arrays.positions);
        morph_positions(arrays.positions, positions, out, context);
        arrays.positions = std::move(out);
    }
    if (!normals.empty() && !arrays.normals.empty()) {
        auto out = room_for(arrays.normals);
        morph_normals(arrays.normals, normals, out, context);
        arrays.normals = std::move(out);
    }
    if (!tangents.empty() && !arrays.tangents.empty()) {
        auto out = room_for(arrays.tangents);
        morph_tangents(arrays.tangents, tangents, out, context);
        arrays.tangents = std::move(out);
    }
}

void skin(const MeshPose& pose, PosedArrays& arrays, Context& context) {
    auto positions = room_for(arrays.positions);
    auto normals = room_for(arrays.normals);
    auto tangents = room_for(arrays.tangents);
    skin_vertices(
        {arrays.positions, arrays.normals, arrays.tangents, pose.influences, pose.more_influences, pose.joints},
        {positions, normals, tangents}, context);
    arrays = {std::move(positions), std::move(normals), std::move(tangents)};
}

/// Posed positions from `first` on.
std::span<const vec3> posed_positions(const MeshPose& pose, std::span<const WeightedTarget> targets, std::size_t first,
                                      std::span<vec3> morphed, std::span<vec3> skinned) {
    std::span<const vec3> at = pose.positions.span().subspan(first, morphed.size());
    if (!targets.empty()) {
        morph_some_positions(pose.positions, targets, first, morphed);
        at = morphed;
    }
    if (pose.joints.empty()) return at;
    const auto influences = pose.influences.span().subspan(first, morphed.size());
    const auto more = pose.more_influences.empty() ? std::span<const JointInfluence>()
                                                   : pose.more_influences.span().subspan(first, morphed.size());
    skin_some_vertices({at, {}, {}, influences, more, pose.joints}, {skinned, {}, {}});
    return skinned;
}

}  // namespace

bool MeshPose::moves() const {
    const auto offsets = [this](const MorphTarget& t) {
        return !t.positions.empty() || (!t.normals.empty() && !normals.empty()) ||
               (!t.tangents.empty() && !tangents.empty());
    };
    for (std::size_t t = 0; t < std::min(targets.size(), weights.size()); ++t)
        if (weights[t] != 0 && offsets(targets[t])) return true;
    return !joints.empty();
}

PosedArrays posed_arrays(const MeshPose& pose, Context& context) {
    PosedArrays arrays{pose.positions, pose.normals, pose.tangents};
    morph(pose, arrays, context);
    if (!pose.joints.empty()) skin(pose, arrays, context);
    return arrays;
}

void extend_box(std::span<const vec3> positions, vec3& low, vec3& high) {
    for (const vec3& p : positions) {
        if (!is_finite(p)) continue;
        low = min(low, p);
        high = max(high, p);
    }
}

Box empty_box() {
    const float big = std::numeric_limits<float>::max();
    return {{big, big, big}, {-big, -big, -big}};
}

Box posed_box(const MeshPose& pose, Context& context) {
    const std::size_t count = pose.positions.size();
    const std::vector<WeightedTarget> targets = counting(pose, &MorphTarget::positions);
    std::vector<Box> boxes((count + chunk - 1) / chunk, empty_box());
    context.parallel_for(boxes.size(), [&](std::size_t c) {
        const std::size_t first = c * chunk, vertices = std::min(chunk, count - first);
        std::array<vec3, chunk> morphed, skinned;
        extend_box(posed_positions(pose, targets, first, std::span(morphed).first(vertices),
                                   std::span(skinned).first(vertices)),
                   boxes[c].low, boxes[c].high);
    });
    Box whole = empty_box();
    for (const Box& box : boxes) whole = {min(whole.low, box.low), max(whole.high, box.high)};
    return whole;
}

}  // namespace rakelight::geometry
