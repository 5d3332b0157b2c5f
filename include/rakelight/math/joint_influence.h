// SPDX-License-Identifier: Apache-2.0
// Joint influences of a skinned vertex.
#pragma once
#include <array>
#include <cstdint>

namespace rakelight {

/// Four joints of a vertex with their weights.
struct JointInfluence {
    std::array<std::uint16_t, 4> joints{};  ///< into Skin::joints
    std::array<float, 4> weights{};         ///< all weights of a vertex (four or eight) sum to 1, or all are 0
    bool operator==(const JointInfluence&) const = default;
};

}  // namespace rakelight
