// SPDX-License-Identifier: Apache-2.0
// CornerWeight::fit and CornerWeight::automatic: normals of groups from two rings of neighbors, over all objects.
#pragma once
#include "geometry/fits/fitted_places.h"
#include "geometry/input/corner_weights.h"
#include "geometry/sums/vote_sums.h"

namespace rakelight::geometry {

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
