// SPDX-License-Identifier: Apache-2.0
// Which side of a surface is lit: the one that is seen. Vertex normals belong to one side of their triangle, and are
// turned round where the other one is seen.
#pragma once
#include "engines/raster/front_end.h"

namespace rakelight::raster {

/// On which side the normals of one draw's triangles stand.
/// - Where the format gives the winding a meaning (glTF): on the front, as RenderSettings::front_face has it.
/// - Meshes without normals are lit with those of their triangles: on the front too.
/// - Else (OBJ and the like, whose files wind as they please) as geometry/normal_sides.h finds it, piece by piece of
///   smooth surface: by the winding, unless the piece as a whole is wound against its normals.
class LitSide {
public:
    LitSide(const FrontEnd& front, std::uint32_t number) {
        const Draw& draw = front.list.draws[number];
        const bool is_clockwise = front.settings.front_face == FrontFace::clockwise;
        if (!front.list.materials[draw.material].classical || front.list.scene.meshes[draw.mesh].normals.empty())
            return;
        const geometry::NormalSides& sides = front.list.normal_sides[draw.mesh];
        if (!sides.against.empty()) against_ = sides.against.data();
        front_turns_ = is_clockwise != (!against_ && sides.all_against);
    }

    /// Whether a triangle's normals are turned round.
    bool is_turned(const ScreenTriangle& s) const {
        return (s.is_back != front_turns_) != (against_ && against_[s.triangle] != 0);
    }

    // The same for kernels: RecordJob::turned and ::against.
    bool front_turns() const { return front_turns_; }
    const std::int32_t* against() const { return against_; }

private:
    bool front_turns_ = false;
    const std::int32_t* against_ = nullptr;
};

}  // namespace rakelight::raster
