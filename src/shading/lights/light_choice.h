// SPDX-License-Identifier: Apache-2.0
// Whether light is looked for in the environment or on triangles that emit.
#pragma once
namespace rakelight::shading {

/// Half of all samples each where both are there: how bright they are at a point is not known before its shadow rays. The
/// density of a sample is its own times `probability`; so is that of light which a ray finds by chance, for weights.
struct LightChoice {
    bool has_environment = false, has_emitters = false;

    double probability_of_environment() const { return has_environment ? (has_emitters ? 0.5 : 1) : 0; }
    double probability_of_emitters() const { return has_emitters ? 1 - probability_of_environment() : 0; }

    struct Pick {
        bool is_environment;
        double probability;
        double rest;  ///< [0, 1) what the choice leaves of u
    };
    /// @param u  0..1, 1 excluded. One of both must be there.
    Pick pick(double u) const {
        const double share = probability_of_environment();
        if (u < share) return {true, share, u / share};
        return {false, 1 - share, (u - share) / (1 - share)};
    }
};

}  // namespace rakelight::shading
