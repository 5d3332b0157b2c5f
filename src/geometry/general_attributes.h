// SPDX-License-Identifier: Apache-2.0
// The general path: every option, in double.
#pragma once
#include <functional>
#include <memory>

#include <rakelight/geometry/attributes.h>

#include "geometry/attribute_plan.h"
#include "geometry/sums/vote_sums.h"

namespace rakelight::geometry {

/// @param base  what an earlier plan of the same meshes left; empty: nothing
/// @throws Error as group()
AttributePlan plan_from(GroupingBase base, std::span<const AttributeMesh> meshes, const AttributeOptions& options,
                        Context& context);
/// @param input  of meshes like those of the plan
std::vector<MeshAttributes> accumulate(const AttributePlan::Impl& plan, const AttributeInput& input, Context& context);

/// @param wanted  [vertices] 0: what comes out at its place is not needed; empty: all are
std::vector<MeshAttributes> general_attributes(std::span<const AttributeMesh> meshes, const AttributeOptions& options,
                                               std::span<const std::uint8_t> wanted, GeneralScratch& scratch,
                                               Context& context);
std::vector<MeshAttributes> general_attributes(std::span<const AttributeMesh> meshes, const AttributeOptions& options,
                                               Context& context);

/// Some places and their faces, grouped by the general path. Their normals are fitted among all others before tangents are
/// made.
class GroupedPart {
public:
    /// @param wanted  [vertices] 0: what comes out at its place is not needed
    /// @throws Error as group()
    GroupedPart(std::span<const AttributeMesh> meshes, const AttributeOptions& options,
                std::span<const std::uint8_t> wanted, GeneralScratch& scratch, Context& context);
    ~GroupedPart();
    GroupedPart(const GroupedPart&) = delete;
    GroupedPart& operator=(const GroupedPart&) = delete;

    const AttributeInput& input() const { return input_; }
    const Topology& topology() const;
    /// Of normals, before the fit.
    VoteSums sums() const;
    /// @param fit  replaces the normals of groups
    std::vector<MeshAttributes> finish(const std::function<void(VoteSums&)>& fit) const;

private:
    AttributeInput input_;
    std::shared_ptr<AttributePlan::Impl> plan_;
    GeneralScratch& scratch_;
    Context& context_;
};

/// The general path's result for one mesh, in the form of the buffers.
SplitAttributes split_from(const AttributeMesh& mesh, const MeshAttributes& result, const AttributeBuffers& out);

/// @param out  [meshes] large enough: checked by the caller
/// @throws Error as compute_attributes(); the scratch may then have lost its memory
std::vector<SplitAttributes> general_attributes_into(std::span<const AttributeMesh> meshes,
                                                     const AttributeOptions& options,
                                                     std::span<const AttributeBuffers> out, GeneralScratch& scratch,
                                                     Context& context);

}  // namespace rakelight::geometry
