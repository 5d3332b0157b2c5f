// SPDX-License-Identifier: Apache-2.0
// The source of a mesh's normals, from its part of the world file, its file and the picture's options.
#pragma once
#include <rakelight/geometry/attributes.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

struct NormalRule {
    bool keeps_given = true;       ///< the mesh's own normals count; those that are missing are made
    Scope scope = Scope::model;    ///< over which they are smoothed
    bool joins_seams = false;      ///< kept normals are joined where meshes meet: <rakelight/geometry/seams.h>
    bool groups = false;           ///< smoothing groups count, inside an object; across objects the crease angle does
    double crease_angle_rad = -1;  ///< the mesh's own; < 0: by the picture's options
};

/// [rad] The crease angle that a mesh's part has in its world file; < 0: none.
double own_crease_angle(const Mesh& mesh);

/// @param source  of the picture's options: all but `automatic` overrule the mesh's own choice
NormalRule normal_rule(const Scene& scene, const Mesh& mesh, NormalSource source);

}  // namespace rakelight
