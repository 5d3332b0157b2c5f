// SPDX-License-Identifier: Apache-2.0
#include "io/stl/join_corners.h"

#include <algorithm>

#include <rakelight/base/error.h>

#include "io/obj/unique_table.h"

namespace rakelight::io::stl {
namespace {

using obj::UniquePart, obj::UniqueTable;

constexpr const char* what = "the vertices of an STL file";
/// Corners that one task joins by itself: its table stays in the cache. A multiple of 3.
constexpr std::size_t part_corners = 3 << 14;

/// The corners of one part, each once. Their numbers in it go to `indices`.
std::vector<Corner> join_part(std::size_t first, std::span<std::uint32_t> indices, const ReadCorners& read,
                              MemoryCharge& charge, Context& context) {
    const std::size_t count = indices.size();
    const MemoryCharge scratch(context.memory(), count * sizeof(Corner) + UniqueTable<Corner>::bytes_for(count), what);
    std::vector<Corner> corners(count);
    read(first, corners);
    UniqueTable<Corner> table;
    table.reserve(count);
    for (std::size_t i = 0; i < count; ++i) indices[i] = table.number_of(corners[i]);
    charge.grow(table.keys().size() * sizeof(Corner), what);
    return {table.keys().begin(), table.keys().end()};
}

}  // namespace

JoinedCorners join_corners(std::uint64_t count, const ReadCorners& read, Context& context) {
    if (count > UniqueTable<Corner>::most) throw Error(ErrorCode::bad_file, "a mesh has more than 4294967294 vertices");
    JoinedCorners out{{}, {}, MemoryCharge(context.memory(), count * sizeof(std::uint32_t), what)};
    out.indices.resize(std::size_t(count));
    // 1. Each part by itself.
    const std::size_t part_count = (out.indices.size() + part_corners - 1) / part_corners;
    const auto indices_of = [&out](std::size_t part) {
        const std::size_t first = part * part_corners;
        return std::span(out.indices).subspan(first, std::min(part_corners, out.indices.size() - first));
    };
    MemoryCharge working(context.memory());
    std::vector<std::vector<Corner>> corners(part_count);
    context.parallel_for(part_count, [&](std::size_t p) {
        corners[p] = join_part(p * part_corners, indices_of(p), read, working, context);
    });
    // 2. The parts, in the order of the file.
    std::uint64_t total = 0;
    for (const auto& part : corners) total += part.size();
    working.grow(total * sizeof(std::uint32_t) + UniqueTable<Corner>::bytes_for(std::size_t(total)), what);
    std::vector<std::vector<std::uint32_t>> numbers(part_count);
    std::vector<UniquePart<Corner>> parts;
    for (std::size_t p = 0; p < part_count; ++p) {
        numbers[p].resize(corners[p].size());
        parts.push_back({corners[p].data(), corners[p].size(), numbers[p].data()});
    }
    out.vertices = obj::merged(parts, std::size_t(total));
    out.charge.grow(out.vertices.capacity() * sizeof(Corner), what);
    // 3. Numbers in a part become numbers in the mesh.
    context.parallel_for(part_count, [&](std::size_t p) {
        for (std::uint32_t& index : indices_of(p)) index = numbers[p][index];
    });
    return out;
}

}  // namespace rakelight::io::stl
