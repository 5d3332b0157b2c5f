// SPDX-License-Identifier: Apache-2.0
// Last pass over an OBJ file: the faces, lines and points of one chunk, with references into the whole file, and the
// changes of state among them (o, g, usemtl, s). Their meaning depends on the chunks before: obj_faces.h joins the
// chunks.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

#include "io/obj/obj_remarks.h"
#include "io/obj/obj_vertices.h"
#include "io/obj/unique_table.h"

namespace rakelight::io::obj {

/// Indices of one corner into VertexData, 0-based; `no_index` where the corner has no such thing.
struct Corner {
    std::uint32_t position = no_index, texcoord = no_index, normal = no_index;
    bool operator==(const Corner&) const = default;
};

inline std::uint64_t hash_of(const Corner& c, HashKey key) {
    return folded_product((std::uint64_t(c.position) << 32 | c.texcoord) ^ key.a, c.normal ^ key.b);
}

/// An `o`, `g` or `usemtl` line that counts.
struct StateChange {
    enum class Kind : std::uint8_t { object, group, material } kind = Kind::object;
    std::string name;
    std::uint64_t line = 0;
};

/// Elements that follow one another and go into one mesh: of one topology, all with normals or without, no change of state between
/// them. It ends where the next one begins.
struct Run {
    Topology topology = Topology::triangles;
    bool has_normals = false;
    std::size_t changes = 0;                                            ///< of the chunk's changes, those before it
    std::size_t first_index = 0, first_corner = 0, first_triangle = 0;  ///< into the chunk's
    std::size_t vertices_end =
        0;  ///< first byte after the last v, vt or vn line before it in the chunk; 0: there is none
};

/// A polygon that was cut into several triangles of the chunk.
struct CutPolygon {
    std::size_t first_triangle = 0, triangles = 0;
};

/// The smoothing group of the chunk's triangles from this one on.
struct SmoothingChange {
    std::size_t first_triangle = 0;
    std::uint32_t group = 0;
};

/// A face that was read, for writing the file back.
struct FaceRecord {
    std::size_t line_begin = 0, first_index = 0;  ///< in the file; into the chunk's indices
    std::uint32_t corners = 0;
};

/// What one chunk holds. Corner numbers count from the first corner of their run.
struct ChunkElements {
    std::vector<StateChange> changes;
    std::vector<Run> runs;
    std::vector<Corner> corners;         ///< of each run its own, each once, in order of first use
    std::vector<std::uint32_t> indices;  ///< three per triangle, two per segment, one per point: corner numbers
    std::vector<CutPolygon> polygons;
    std::vector<SmoothingChange> smoothing;
    std::vector<FaceRecord> faces;  ///< where they are kept
    std::vector<std::uint32_t>
        places;                  ///< of the corners of kept faces that have more than three: place among their indices
    std::uint64_t drawable = 0;  ///< triangles, segments and points whose corners are all finite
    Remarks remarks;

    std::size_t run_end(std::size_t run) const {
        return run + 1 < runs.size() ? runs[run + 1].first_index : indices.size();
    }
    std::size_t corners_end(std::size_t run) const {
        return run + 1 < runs.size() ? runs[run + 1].first_corner : corners.size();
    }
};

/// Arrays that are used for one chunk after the other.
struct ChunkScratch {
    ChunkElements elements;
    UniqueTable<Corner> table;
    std::vector<Corner> corners;  ///< of the element at hand
    std::vector<dvec3> polygon;
    std::vector<std::uint32_t> triangles;
};

/// At most as many bytes are kept of each byte of the chunk: two bytes of text can name a corner, and make a triangle of a polygon.
inline constexpr std::uint64_t most_kept_per_byte = 24;

/// @param keep_faces  ChunkElements::faces and places are wanted
/// @throws Error bad_file: a polygon for which there is no memory; failed: cancelled
ChunkElements read_chunk(std::string_view file, const ChunkContents& chunk, const Contents& contents,
                         const VertexData& data, bool keep_faces, ChunkScratch& scratch, Context& context);

}  // namespace rakelight::io::obj
