// SPDX-License-Identifier: Apache-2.0
// Which side of a surface is lit: the one that is seen. Vertex normals belong to one side of their triangle, and are
// turned round where the other one is seen.
#pragma once
#include <rakelight/engines/engine.h>

#include "shading/draw_list.h"

namespace rakelight::shading {

/// On which side the normals of one draw's triangles stand.
/// - Where the format gives the winding a meaning (glTF): on the front, as RenderSettings::front_face has it.
/// - Meshes without normals are lit with those of their triangles: on the front too.
/// - Else (OBJ and the like, whose files wind as they please) as geometry/normal_sides.h finds it, piece by piece of
///   smooth surface: by the winding, unless the piece as a whole is wound against its normals.
class LitSide {
public:
    LitSide(const DrawList& list, const Draw& draw, FrontFace front_face) {
        if (!list.material(draw).classical || list.scene.meshes[draw.mesh].normals.empty()) return;
        const geometry::NormalSides& sides = list.normal_sides[draw.mesh];
        if (!sides.against.empty()) against_ = sides.against.data();
        front_turns_ = (front_face == FrontFace::clockwise) != (!against_ && sides.all_against);
    }

    /// Whether a triangle's normals are turned round.
    /// @param is_back  it is seen from behind
    bool is_turned(std::uint32_t triangle, bool is_back) const {
        return (is_back != front_turns_) != (against_ && against_[triangle] != 0);
    }

    // The same for who turns many triangles: normals are turned where the front is seen, and the other way round for
    // the triangles that say 1; null: none do.
    bool front_turns() const { return front_turns_; }
    const std::int32_t* against() const { return against_; }

private:
    bool front_turns_ = false;
    const std::int32_t* against_ = nullptr;
};

}  // namespace rakelight::shading
