// SPDX-License-Identifier: Apache-2.0
// Seam-free normals for interleaved vertex buffers, as engines keep them: position, normal and texture coordinates of a
// vertex lie side by side. Two triangles that share an edge are two objects with a buffer each; their normals are written in place.
#include <array>
#include <cstddef>
#include <cstdio>
#include <utility>
#include <vector>

#include <rakelight/base/error.h>
#include <rakelight/base/interleaved.h>
#include <rakelight/geometry/attributes.h>

namespace {

struct Vertex {
    rakelight::vec3 position, normal;
    rakelight::vec2 texcoord;
};

}  // namespace

int main() {
    using namespace rakelight;
    std::array<std::vector<Vertex>, 2> buffers{{
        {{{0, 0, 0}, {}, {0, 0}}, {{1, 0, 0}, {}, {1, 0}}, {{1, 1, 0}, {}, {1, 1}}},
        {{{1, 1, 0}, {}, {0, 0}}, {{1, 0, 0}, {}, {1, 0}}, {{2, 0, -1}, {}, {1, 1}}},
    }};
    const std::vector<std::uint32_t> indices{0, 1, 2};
    std::array<std::vector<vec3>, 2> positions;
    std::vector<AttributeMesh> meshes(2);
    for (std::size_t m = 0; m < 2; ++m) {
        positions[m] = packed<vec3>({.buffer = std::as_bytes(std::span(std::as_const(buffers[m]))),
                                     .offset = offsetof(Vertex, position),
                                     .stride = sizeof(Vertex),
                                     .vertex_count = buffers[m].size()});
        meshes[m] = {.object = std::uint32_t(m), .positions = positions[m], .indices = indices};
    }
    try {
        Context context;
        const std::vector<MeshAttributes> result = compute_attributes(meshes, {.tangents = false}, context);
        for (std::size_t m = 0; m < 2; ++m)
            if (!write_interleaved<vec3>(result[m].normals, {.buffer = std::as_writable_bytes(std::span(buffers[m])),
                                                             .offset = offsetof(Vertex, normal),
                                                             .stride = sizeof(Vertex),
                                                             .vertex_count = buffers[m].size()}))
                return 1;
    } catch (const Error& error) {
        std::fprintf(stderr, "interleaved: %s\n", error.what());
        return 1;
    }
    const vec3 n = buffers[0][1].normal;
    std::printf("the normal at the shared edge: %.4f %.4f %.4f\n", double(n.x), double(n.y), double(n.z));
    return n == buffers[1][1].normal && buffers[0][2].normal == buffers[1][0].normal ? 0 : 1;
}
