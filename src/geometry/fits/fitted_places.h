// SPDX-License-Identifier: Apache-2.0
// Where normals are fitted, with the faces, neighbors and planes there.
#pragma once
#include <span>
#include <vector>

#include "geometry/fits/group_planes.h"
#include "geometry/fits/place_faces.h"

namespace rakelight::geometry {

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

struct FittedPlace {
    std::uint32_t group = 0;
    bool is_border = false;
    PlaceFaces faces;
};
struct FittedPlaces {
    std::vector<FittedPlace> places;  ///< groups ascend
    GroupRings rings;                 ///< at them and their neighbors; elsewhere nothing is known
    FacePlanes planes;                ///< at them; for CornerWeight::automatic

    void release(GeneralScratch& scratch);
};
/// @throws Error bad_file: over the memory budget
FittedPlaces find_fitted_places(const FitInput& from, GeneralScratch& scratch, Context& context);

}  // namespace rakelight::geometry
