// SPDX-License-Identifier: Apache-2.0
// What Assimp's reader of FBX leaves out: which edges of a mesh without normals are smooth. Read from the file itself.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <rakelight/math/vector.h>

namespace rakelight::import_helper {

/// A geometry of the file. Broken numbers are kept: FbxSmoothing checks them.
struct FbxGeometry {
    enum class Kind : std::uint8_t { none, by_polygon, by_edge, other };
    Kind kind = Kind::none;
    bool has_normals = false;
    std::vector<double> points;           ///< x, y, z of each point
    std::vector<std::int32_t> corners;    ///< points; the last corner of a polygon is -1 - point
    std::vector<std::int32_t> edges;      ///< the corner where each begins
    std::vector<std::int32_t> smoothing;  ///< a mask of groups a polygon, or 1 for each smooth edge
    std::vector<std::int32_t> materials;  ///< a number a polygon, or one for all
};

/// The geometries that have smoothing groups and no normals, of text or binary files of version 7.
/// @throws std::exception: the file is broken, or too large for the memory of this process
std::vector<FbxGeometry> read_fbx_geometries(std::span<const std::byte> file);

}  // namespace rakelight::import_helper
