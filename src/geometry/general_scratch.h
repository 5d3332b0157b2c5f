// SPDX-License-Identifier: Apache-2.0
// Memory of the general path that a workspace keeps for the next call.
#pragma once
#include "geometry/corner_bins.h"
#include "geometry/topology.h"
#include "geometry/vote_sums.h"

namespace rakelight::geometry {

/// What grouping needs; valid contents are none of its business.
struct GroupingScratch {
    FaceNormals normals;
    CornerBins corners;
    LargeArray<std::uint16_t> keys;  ///< of CornerSort
};

struct GeneralScratch {
    GroupingScratch grouping;
    LargeArray<NormalRow> normals;
    LargeArray<TangentRow> tangents;
    std::size_t bytes() const {
        return grouping.normals.bytes() + grouping.corners.corners.bytes() + grouping.keys.bytes() + normals.bytes() +
               tangents.bytes() + grouping.corners.begin.capacity() * sizeof(std::uint32_t);
    }
};

}  // namespace rakelight::geometry
