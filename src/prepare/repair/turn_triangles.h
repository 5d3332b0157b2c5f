// SPDX-License-Identifier: Apache-2.0
// Reversed winding: of scenes with clockwise front faces, and of back sides.
#pragma once
#include <map>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

/// Swaps corners 1 and 2 of every triangle.
class TriangleTurner {
public:
    /// A second call restores the winding. Shared blocks stay shared, and blocks that were not replaced in between are
    /// the original ones again.
    /// @throws Error bad_file: over the memory budget
    Scene turned(Scene scene, Context& context);

private:
    template <class T>
    using Known =
        std::map<const void*, std::pair<Block<T>, Block<T>>>;  ///< by identity; the stored block keeps it alive
    template <class T>
    void turn(Block<T>& block, Known<T>& known, Context& context);
    Known<std::uint32_t> indices_;
    Known<vec3> hints_;
};

/// The surface with reversed winding and normals, without tangents.
Mesh back_side(Mesh mesh);

}  // namespace rakelight
