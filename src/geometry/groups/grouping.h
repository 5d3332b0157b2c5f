// SPDX-License-Identifier: Apache-2.0
// Grouping: weld -> creases and smoothing groups -> mirrored texture coordinates.
#pragma once
#include <memory>
#include <span>

#include "geometry/creases/crease_edges.h"
#include "geometry/groups/join_rules.h"
#include "geometry/input/block_array.h"

namespace rakelight::geometry {

/// The part of the grouping that does not depend on the crease angle; shared by plans of one model. Each is computed on
/// demand and null until then.
struct GroupingBase {
    std::shared_ptr<const std::vector<std::uint32_t>> places;  ///< [vertices] as Topology::places
    std::shared_ptr<FaceNormals> normals;                      ///< [triangles]
    std::shared_ptr<CornerBins> corners;                       ///< by place
    std::shared_ptr<const CreaseEdges> creases;                ///< of automatic creases
    std::span<const std::uint8_t> wanted;  ///< [vertices] 0: its place is not divided; empty: all are
    GeneralScratch* scratch = nullptr;     ///< source of memory; null: allocate

    /// Returns the memory, if it is not shared.
    void release();
    const FaceNormals& face_normals(const AttributeInput& input, Context& context);
};

/// Whether a weld with options `a` is valid for options `b`.
bool same_weld(const AttributeOptions& a, const AttributeOptions& b);

struct Grouped {
    Topology topology;
    bool may_cancel = true;  ///< false: no group's normals can cancel
};

/// @param base existing parts are used, missing parts are added
Grouped make_groups(GroupingBase& base, const AttributeInput& input, const AttributeOptions& options, Context& context);

/// The creases of the rule, from the base or added to it.
const CreaseEdges& crease_edges(GroupingBase& base, const AttributeInput& input, const AttributeOptions& options,
                                Context& context);

/// Splits groups whose normals cancelled.
/// @param selected [output vertices] not 0: the group of this representative
void take_apart(Topology& topology, GroupingBase& base, const AttributeInput& input, const AttributeOptions& options,
                JoinRule rule, const std::vector<std::uint8_t>& selected, Context& context);

}  // namespace rakelight::geometry
