// SPDX-License-Identifier: Apache-2.0
// The faces, strips and edges of a PLY file: polygons as triangles, and what faces say of their corners.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "io/ply/ply_cursor.h"
#include "io/vertex_table.h"

namespace rakelight::io::ply {

/// Numbers that faces have for themselves.
struct CornerValue {
    vec2 uv{};               ///< v down
    vec4 color{1, 1, 1, 1};  ///< linear
    bool operator==(const CornerValue&) const = default;
};

struct Faces {
    std::vector<std::uint32_t> triangles, polygons;  ///< [3T]; [T] Mesh::polygons, or empty where all are triangles
    std::vector<std::uint32_t> lines;                ///< [2L]
    /// [3T] Where faces have texture coordinates or colors of their own, else empty.
    std::vector<CornerValue> values;
    bool have_texcoords = false, have_colors = false;
    MemoryCharge charge;

    explicit Faces(MemoryBudget& memory) : charge(memory) {}
    bool has_values() const { return have_texcoords || have_colors; }
    /// Adds the triangles of one face, strip or polygon; the arrays stay in step.
    /// @param corners  [3T] vertices
    /// @param values   [3T], or empty: the face says nothing of its corners
    void add(std::span<const std::uint32_t> corners, std::span<const CornerValue> values);
};

/// Cuts polygons into triangles.
class PolygonCutter {
public:
    /// @param corners  [n] vertices, n >= 3  @return [3 (n - 2)] numbers of corners, until the next call
    std::span<const std::uint32_t> cut(std::span<const std::uint32_t> corners, const VertexTable& vertices,
                                       MemoryCharge& charge);

private:
    std::vector<std::uint32_t> triangles_;
    std::vector<dvec3> places_;
};

/// Reads the faces. Those with fewer than 3 corners, or with vertex numbers out of range, are left out with a remark.
/// @param takes_colors  vertices have none
void read_faces(Cursor& cursor, const Element& element, Format format, const VertexTable& vertices, bool takes_colors,
                Faces& out, const std::string& path, Context& context);
/// Strips of triangles: each list of vertex numbers is one, and -1 begins another.
void read_strips(Cursor& cursor, const Element& element, const VertexTable& vertices, Faces& out,
                 const std::string& path, Context& context);
void read_edges(Cursor& cursor, const Element& element, const VertexTable& vertices, Faces& out,
                const std::string& path, Context& context);

}  // namespace rakelight::io::ply
