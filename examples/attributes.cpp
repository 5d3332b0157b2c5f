// SPDX-License-Identifier: Apache-2.0
// Seam-free normals for buffers of your own: no scene, no file. Two squares that meet at a right angle along x = 1 are two
// objects; the one is stored about its own origin, as engines do.
#include <cstdio>
#include <vector>

#include <rakelight/base/error.h>
#include <rakelight/geometry/attributes.h>

int main() {
    using namespace rakelight;
    const std::vector<vec3> floor{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const std::vector<vec3> wall{{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0}};  // in the world from x = 1 on
    const std::vector<std::uint32_t> floor_indices{0, 1, 2, 0, 2, 3}, wall_indices{0, 1, 2, 0, 2, 3};

    std::vector<AttributeMesh> meshes(2);  // spans: nothing is copied
    meshes[0] = {.object = 0, .positions = floor, .indices = floor_indices};
    meshes[1] = {.object = 1, .positions = wall, .indices = wall_indices};
    meshes[1].to_world[3] = {1, 0, 0, 1};  // the last column: moved along x
    AttributeOptions options;
    options.crease_angle_rad = radians(100);  // sharper edges stay sharp; 90 degrees is smooth here
    try {
        Context context;  // threads and a memory limit
        const std::vector<MeshAttributes> result = compute_attributes(meshes, options, context);
        for (std::size_t m = 0; m < result.size(); ++m)  // a mesh with creases inside has more vertices than it had
            for (std::size_t v = 0; v < result[m].normals.size(); ++v) {
                const vec3 n = result[m].normals[v];
                std::printf("object %zu, vertex %zu: %.4f %.4f %.4f\n", m, v, double(n.x), double(n.y), double(n.z));
            }
        const bool is_closed =
            result[0].normals[1] == result[1].normals[0] && result[0].normals[2] == result[1].normals[3];
        std::puts(is_closed ? "no seam: both objects have the same bits along the edge" : "a seam");
        return is_closed ? 0 : 1;
    } catch (const Error& error) {
        std::fprintf(stderr, "attributes: %s\n", error.what());
        return 1;
    }
}
