// SPDX-License-Identifier: Apache-2.0
#include "io/obj/merge_corners.h"

#include <algorithm>

namespace rakelight::io::obj {
namespace {

/// One mesh's runs in the order of the file, and the number of their corners, those that several have counted each time.
struct Parts {
    std::vector<UniquePart<Corner>> parts;
    std::size_t corners = 0;
};

/// [chunks][their corners] numbers in the meshes.
using Numbers = std::vector<std::vector<std::uint32_t>>;

std::vector<Parts> parts_of_meshes(const std::vector<ChunkElements>& chunks, const std::vector<ChunkPlaces>& places,
                                   std::size_t meshes, Numbers& numbers) {
    std::vector<Parts> all(meshes);
    for (std::size_t c = 0; c < chunks.size(); ++c)
        for (std::size_t r = 0; r < chunks[c].runs.size(); ++r) {
            Parts& of = all[places[c].runs[r].mesh];
            const std::size_t first = chunks[c].runs[r].first_corner, count = chunks[c].corners_end(r) - first;
            of.parts.push_back({chunks[c].corners.data() + first, count, numbers[c].data() + first});
            of.corners += count;
        }
    return all;
}

void fill_smoothing(const ChunkElements& chunk, const Run& run, std::size_t triangles, std::uint32_t before,
                    std::uint32_t* to) {
    const auto later =
        std::ranges::upper_bound(chunk.smoothing, run.first_triangle, {}, &SmoothingChange::first_triangle);
    std::uint32_t group = later == chunk.smoothing.begin() ? before : std::prev(later)->group;
    std::size_t done = 0;
    for (auto change = later; done < triangles; ++change) {
        const bool is_last = change == chunk.smoothing.end();
        const std::size_t end = is_last ? triangles : std::min(triangles, change->first_triangle - run.first_triangle);
        std::fill(to + done, to + end, group);
        done = end;
        if (is_last) break;
        group = change->group;
    }
}

/// The number of a polygon is that of its first triangle, so that triangles by themselves have their own.
void fill_polygons(const ChunkElements& chunk, const Run& run, std::size_t triangles, std::size_t first,
                   std::uint32_t* to) {
    for (std::size_t t = 0; t < triangles; ++t) to[t] = std::uint32_t(first + t);
    auto polygon = std::ranges::lower_bound(chunk.polygons, run.first_triangle, {}, &CutPolygon::first_triangle);
    for (; polygon != chunk.polygons.end() && polygon->first_triangle < run.first_triangle + triangles; ++polygon) {
        const std::size_t at = polygon->first_triangle - run.first_triangle;
        std::fill(to + at, to + at + polygon->triangles, std::uint32_t(first + at));
    }
}

/// What one chunk adds to the meshes.
void fill(const ChunkElements& chunk, const ChunkPlaces& places, const std::vector<std::uint32_t>& numbers,
          std::vector<ReadMesh>& meshes) {
    for (std::size_t r = 0; r < chunk.runs.size(); ++r) {
        const Run& run = chunk.runs[r];
        ReadMesh& mesh = meshes[places.runs[r].mesh];
        const std::size_t first = places.runs[r].first_index, count = chunk.run_end(r) - run.first_index;
        for (std::size_t i = 0; i < count; ++i)
            mesh.indices[first + i] = numbers[run.first_corner + chunk.indices[run.first_index + i]];
        if (run.topology != Topology::triangles) continue;
        if (!mesh.smoothing.empty())
            fill_smoothing(chunk, run, count / 3, places.smoothing_before, mesh.smoothing.data() + first / 3);
        if (!mesh.polygons.empty()) fill_polygons(chunk, run, count / 3, first / 3, mesh.polygons.data() + first / 3);
    }
}

void make_arrays(ReadMesh& mesh, bool has_smoothing, MemoryCharge& charge) {
    const auto make = [&charge](std::vector<std::uint32_t>& array, std::uint64_t count) {
        charge.grow(count * sizeof(std::uint32_t), "the faces of an OBJ file");
        array.resize(std::size_t(count));
    };
    make(mesh.indices, mesh.index_count);
    if (mesh.key.topology != Topology::triangles) return;
    if (has_smoothing) make(mesh.smoothing, mesh.index_count / 3);
    if (mesh.has_polygons) make(mesh.polygons, mesh.index_count / 3);
}

}  // namespace

void merge_corners(const std::vector<ChunkElements>& chunks, const std::vector<ChunkPlaces>& places,
                   std::vector<ReadMesh>& meshes, bool has_smoothing, MemoryCharge& charge, Context& context) {
    std::uint64_t numbered = 0;
    for (const ChunkElements& chunk : chunks) numbered += chunk.corners.size();
    MemoryCharge working(context.memory(), numbered * sizeof(std::uint32_t), "the faces of an OBJ file");
    Numbers numbers(chunks.size());
    for (std::size_t c = 0; c < chunks.size(); ++c) numbers[c].resize(chunks[c].corners.size());
    const std::vector<Parts> parts = parts_of_meshes(chunks, places, meshes.size(), numbers);
    std::uint64_t bytes = 0;
    for (const Parts& of : parts) {
        if (of.corners > UniqueTable<Corner>::most)
            throw Error(ErrorCode::bad_file, "a mesh has more than 4294967294 vertices");
        bytes += of.parts.capacity() * sizeof(UniquePart<Corner>) + UniqueTable<Corner>::bytes_for(of.corners);
    }
    working.grow(bytes, "the faces of an OBJ file");
    context.parallel_for(meshes.size(),
                         [&](std::size_t m) { meshes[m].corners = merged(parts[m].parts, parts[m].corners); });
    for (const ReadMesh& mesh : meshes)
        charge.grow(mesh.corners.capacity() * sizeof(Corner), "the faces of an OBJ file");
    for (ReadMesh& mesh : meshes) make_arrays(mesh, has_smoothing, charge);
    context.parallel_for(chunks.size(), [&](std::size_t c) { fill(chunks[c], places[c], numbers[c], meshes); });
}

}  // namespace rakelight::io::obj
