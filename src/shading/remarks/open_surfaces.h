// SPDX-License-Identifier: Apache-2.0
// Says when back faces were left out of an object that has a boundary: there one can look in, and sees nothing.
#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include <rakelight/engines/engine.h>

#include "shading/draw_list.h"

namespace rakelight::shading {

/// Counts boundary edges of objects whose back faces were culled. An object is what stands at one node: all its meshes
/// together, places welded that are equal except for rounding, so that a body of several materials counts as one. Objects
/// with equal arrays are counted once from one prepare to the next.
class OpenSurfaces {
public:
    /// Objects of more triangles or vertices are not looked at, nor what follows when so many were: about 0.1 us each.
    /// A note that few read may take less.
    static constexpr std::uint64_t most_for_warning = 1'000'000, most_for_note = 50'000;

    /// What the scene before had; its arrays may be gone.
    void forget() { boundary_edges_.clear(); }

    /// At most one remark on a picture: a warning where culling of back faces was `asked` for, else a note.
    /// @param is_culled  [draws] not 0: triangles in the window were culled by the side they are seen from; empty: none
    void remark(const DrawList& list, std::span<const std::uint8_t> is_culled, Cull cull, bool asked, Context& context);

private:
    using Key = std::vector<const void*>;  ///< identities of the blocks of positions and indices, mesh by mesh
    struct Part {
        const Draw* begin;
        const Draw* end;
    };
    /// [m] in object space: how far apart vertices may be of what was one place before it was rounded. It is 4 float
    /// ulps of the largest coordinate, or half the diagonal of a step's cube of quantized positions if that is more.
    static double weld_tolerance(const DrawList& list, Part object);
    /// Edges of one triangle only.
    std::uint64_t count(const DrawList& list, Part object, Context& context) const;

    std::map<Key, std::uint64_t> boundary_edges_;
};

}  // namespace rakelight::shading
