// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/influences.h"

#include <algorithm>
#include <cmath>

namespace rakelight::io::gltf {
namespace {

constexpr std::uint32_t max_sets = 4;   // 16 influences a vertex; more are not seen in the wild
constexpr float sum_tolerance = 2e-3f;  // 8-bit weights miss 1 by up to 4 * 0.5 / 255

struct Weighted {
    std::uint32_t joint = 0;
    float weight = 0;
};

struct Counts {
    std::uint64_t surplus = 0, bad_weights = 0, bad_sums = 0;
};

/// Keeps the four strongest and makes them sum to 1.
JointInfluence strongest(std::vector<Weighted>& all, Counts& counts) {
    bool bad = false;
    for (Weighted& w : all)
        if (!(w.weight >= 0) || !std::isfinite(w.weight)) bad = true, w.weight = 0;
    if (bad) ++counts.bad_weights;
    std::stable_sort(all.begin(), all.end(), [](const Weighted& a, const Weighted& b) { return a.weight > b.weight; });
    if (all.size() > 4 && all[4].weight > 0) ++counts.surplus;
    float sum = 0;
    for (std::size_t k = 0; k < 4; ++k) sum += all[k].weight;
    JointInfluence influence;
    if (!(sum > 0) || !std::isfinite(sum)) return influence;
    if (std::fabs(sum - 1) > sum_tolerance) ++counts.bad_sums;
    for (std::size_t k = 0; k < 4; ++k) {
        influence.weights[k] = all[k].weight / sum;
        influence.joints[k] = all[k].weight > 0 ? std::uint16_t(all[k].joint) : std::uint16_t(0);
    }
    return influence;
}

void report(const Counts& counts, const Document& document, const Value& primitive) {
    const auto say = [&](Remark kind, std::uint64_t n, const char* what) {
        if (n) document.remark(kind, primitive.place(), std::to_string(n) + " vertices " + what);
    };
    say(Remark::dropped, counts.surplus, "have more than four joints; the strongest four are kept");
    say(Remark::changed, counts.bad_weights, "have negative or non-finite joint weights, taken as 0");
    say(Remark::changed, counts.bad_sums, "have joint weights that do not sum to 1; scaled");
}

struct Set {
    std::vector<std::uint32_t> joints;
    std::vector<float> weights;
    MemoryCharge charge;
};

std::vector<Set> read_sets(VertexData& vertices, const Document& document, const Value& primitive) {
    constexpr std::uint32_t joint_types = type_bit(ComponentType::u8) | type_bit(ComponentType::u16);
    std::vector<Set> sets;
    for (std::uint32_t n = 0; n < max_sets; ++n) {
        const std::string number = std::to_string(n);
        const auto joints = vertices.elements("JOINTS_" + number, components(4), joint_types);
        auto weights = vertices.elements("WEIGHTS_" + number, components(4), joint_types | float_only);
        if (!joints && !weights) break;
        if (!joints || !weights) primitive.fail("JOINTS_" + number + " and WEIGHTS_" + number + " must come together");
        weights->normalized = true;  // integers as weights mean nothing else
        MemoryCharge charge(document.context().memory(), joints->count * 32, "joint weights");
        sets.push_back({to_integers(*joints), to_scalars(*weights), std::move(charge)});
    }
    return sets;
}

}  // namespace

Block<JointInfluence> read_influences(VertexData& vertices, const Document& document, const Value& primitive) {
    const std::vector<Set> sets = read_sets(vertices, document, primitive);
    if (sets.empty()) return {};
    MemoryCharge charge(document.context().memory(), vertices.vertex_count() * sizeof(JointInfluence), "joint weights");
    std::vector<JointInfluence> result(std::size_t(vertices.vertex_count()));
    Counts counts;
    std::vector<Weighted> all(4 * sets.size());
    for (std::size_t v = 0; v < result.size(); ++v) {
        for (std::size_t s = 0; s < sets.size(); ++s)
            for (std::size_t k = 0; k < 4; ++k)
                all[4 * s + k] = {sets[s].joints[4 * v + k], sets[s].weights[4 * v + k]};
        result[v] = strongest(all, counts);
    }
    report(counts, document, primitive);
    return {std::move(result), std::move(charge)};
}

std::uint32_t joints_used(const Block<JointInfluence>& influences) {
    std::uint32_t used = 0;
    for (const JointInfluence& influence : influences)
        for (std::size_t k = 0; k < 4; ++k)
            if (influence.weights[k] > 0) used = std::max(used, std::uint32_t(influence.joints[k]) + 1);
    return used;
}

}  // namespace rakelight::io::gltf
