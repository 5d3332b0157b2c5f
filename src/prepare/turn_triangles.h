// SPDX-License-Identifier: Apache-2.0
// Scenes whose triangles turn clockwise as seen from their front: turned round, everything is made for them as for
// others.
#pragma once
#include <map>

#include <rakelight/context.h>
#include <rakelight/scene.h>

namespace rakelight {

/// Corners 1 and 2 of every triangle change places.
class TriangleTurner {
public:
    /// A second call turns them back. Blocks that meshes share stay shared, and those that nothing has replaced between
    /// the two calls are the first ones again.
    /// @throws Error bad_file: more memory than the budget has
    Scene turned(Scene scene, Context& context);

private:
    template <class T>
    using Known =
        std::map<const void*, std::pair<Block<T>, Block<T>>>;  ///< by identity; the block itself keeps it alive
    template <class T>
    void turn(Block<T>& block, Known<T>& known, Context& context);
    Known<std::uint32_t> indices_;
    Known<vec3> hints_;
};

}  // namespace rakelight
