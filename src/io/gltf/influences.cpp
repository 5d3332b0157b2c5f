// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/influences.h"

#include <algorithm>
#include <cmath>

#include "base/format_text.h"

namespace rakelight::io::gltf {
namespace {

constexpr std::uint32_t max_sets = 4;   // 16 influences a vertex; more are not seen in the wild
constexpr std::size_t most_joints = 8;  // that a vertex follows
constexpr float sum_tolerance = 2e-3f;  // 8-bit weights miss 1 by up to 4 * 0.5 / 255

struct Weighted {
    std::uint32_t joint = 0;
    float weight = 0;
};

/// The eight strongest, which sum to 1: four and four.
struct Strongest {
    JointInfluence first, next;
};

Strongest strongest(std::vector<Weighted>& all, InfluenceFaults& counts) {
    bool bad = false;
    for (Weighted& w : all)
        if (!(w.weight >= 0) || !std::isfinite(w.weight)) bad = true, w.weight = 0;
    if (bad) ++counts.bad_weights;
    std::sort(all.begin(), all.end(), [](const Weighted& a, const Weighted& b) {
        return a.weight != b.weight ? a.weight > b.weight
                                    : a.joint < b.joint;  // equal vertices: equal sums, to the bit
    });
    if (all.size() > most_joints && all[most_joints].weight > 0) ++counts.surplus;
    const std::size_t count = std::min(all.size(), most_joints);
    float sum = 0;
    for (std::size_t k = 0; k < count; ++k) sum += all[k].weight;
    Strongest kept;
    if (!(sum > 0) || !std::isfinite(sum)) {
        ++counts.no_sums;
        return kept;
    }
    if (std::fabs(sum - 1) > sum_tolerance) ++counts.bad_sums;
    for (std::size_t k = 0; k < count; ++k) {
        JointInfluence& influence = k < 4 ? kept.first : kept.next;
        const float weight = all[k].weight / sum;  // may vanish
        influence.weights[k % 4] = weight;
        influence.joints[k % 4] = weight > 0 ? std::uint16_t(all[k].joint) : std::uint16_t(0);
    }
    return kept;
}

void report(const InfluenceFaults& counts, const Document& document, const Value& primitive) {
    const auto say = [&](Remark kind, std::uint64_t n, const char* what) {
        if (n) document.remark(kind, primitive.place(), format_text("{} vertices {}", n, what));
    };
    say(Remark::dropped, counts.surplus, "have more than eight joints; the strongest eight are kept");
    say(Remark::changed, counts.bad_weights, "have negative or non-finite joint weights, taken as 0");
    say(Remark::changed, counts.bad_sums, "have joint weights that do not sum to 1; scaled");
    say(Remark::changed, counts.no_sums,
        "have joint weights whose sum is zero; they follow their first joint (other programs may choose another)");
}

std::vector<InfluenceSet> read_sets(VertexData& vertices, const Document& document, const Value& primitive) {
    constexpr std::uint32_t joint_types = type_bit(ComponentType::u8) | type_bit(ComponentType::u16);
    std::vector<InfluenceSet> sets;
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

Influences strongest_influences(const std::vector<InfluenceSet>& sets, InfluenceFaults& faults, Context& context) {
    const std::size_t vertices = sets[0].joints.size() / 4;
    const std::uint64_t bytes = vertices * sizeof(JointInfluence);
    MemoryCharge charge(context.memory(), bytes, "joint weights");
    std::vector<JointInfluence> first(vertices);
    MemoryCharge charge_for_next(context.memory(), sets.size() > 1 ? bytes : 0, "joint weights");
    std::vector<JointInfluence> next(sets.size() > 1 ? vertices : 0);
    bool has_next = false;
    std::vector<Weighted> all(4 * sets.size());
    for (std::size_t v = 0; v < vertices; ++v) {
        for (std::size_t s = 0; s < sets.size(); ++s)
            for (std::size_t k = 0; k < 4; ++k)
                all[4 * s + k] = {sets[s].joints[4 * v + k], sets[s].weights[4 * v + k]};
        const Strongest kept = strongest(all, faults);
        first[v] = kept.first;
        if (!next.empty()) next[v] = kept.next;
        has_next = has_next || kept.next.weights[0] > 0;
    }
    if (!has_next) return {{std::move(first), std::move(charge)}, {}};
    return {{std::move(first), std::move(charge)}, {std::move(next), std::move(charge_for_next)}};
}

Influences read_influences(VertexData& vertices, const Document& document, const Value& primitive) {
    const std::vector<InfluenceSet> sets = read_sets(vertices, document, primitive);
    if (sets.empty()) return {};
    InfluenceFaults faults;
    Influences influences = strongest_influences(sets, faults, document.context());
    report(faults, document, primitive);
    return influences;
}

std::uint32_t joints_used(const Mesh& mesh) {
    std::uint32_t used = 0;
    for (const Block<JointInfluence>* block : {&mesh.influences, &mesh.more_influences})
        for (const JointInfluence& influence : *block)
            for (std::size_t k = 0; k < 4; ++k)
                if (influence.weights[k] > 0) used = std::max(used, std::uint32_t(influence.joints[k]) + 1);
    return used;
}

}  // namespace rakelight::io::gltf
