// SPDX-License-Identifier: Apache-2.0
// What a skinned vertex follows.
#pragma once
#include <array>
#include <cstdint>

namespace rakelight {

/// Four of the joints that a vertex follows.
struct JointInfluence {
    std::array<std::uint16_t, 4> joints{};  ///< into Skin::joints
    std::array<float, 4> weights{};         ///< those of all blocks of a vertex sum to 1, or all are 0
    bool operator==(const JointInfluence&) const = default;
};

}  // namespace rakelight
