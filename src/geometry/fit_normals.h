// SPDX-License-Identifier: Apache-2.0
// CornerWeight::fit and CornerWeight::automatic: normals of groups from two rings of neighbors, over all objects.
#pragma once
#include <span>

#include "geometry/vote_sums.h"

namespace rakelight::geometry {

inline bool is_fitted(CornerWeight weight) { return weight == CornerWeight::fit || weight == CornerWeight::automatic; }

/// How the faces of a group spread around its normal by the weight `max`.
enum class Spread : std::uint8_t {
    unknown,
    mild,  ///< they go around, and all are within mild_cosine: nothing is fitted by `automatic`
    wide,  ///< they go around, and some are not
};

/// Vertices with their normals by sums, before some are fitted.
struct FitInput {
    const Topology& topology;
    const AttributeInput& input;
    std::span<const vec3>
        by_max;  ///< [output vertices] of representatives: unit, world, by the weight `max`; zero: no votes
    std::span<const Spread> spread;  ///< [output vertices] or empty: not known
    bool is_automatic;               ///< CornerWeight::automatic
};
/// Cosine of the spread of faces below which `automatic` fits nothing: 1 degree, where the weight of Max errs by 0.3 of the
/// spread in the mean.
constexpr double mild_cosine = 0.99984769515639123;

/// [output vertices] Of representatives: unit normals in the world; zero: nothing was fitted.
/// @param scratch  source of memory
/// @param choices  not null: gets what the weight `automatic` chose
/// @throws Error bad_file: over the memory budget
BlockArray<vec3> fit_groups(const FitInput& from, GeneralScratch& scratch, Context& context,
                            NormalChoices* choices = nullptr);

/// Replaces the normals of groups after sum_groups(): the direction alone, weights stay. Groups with authored members and
/// groups without votes keep theirs. Otherwise as fit_groups().
void fit_normals(VoteSums& sums, const Topology& topology, const AttributeInput& input, const AttributeOptions& options,
                 GeneralScratch& scratch, Context& context, NormalChoices* choices = nullptr);

}  // namespace rakelight::geometry
