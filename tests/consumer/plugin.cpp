// SPDX-License-Identifier: Apache-2.0
// A plugin of somebody's program: one entry of C, which uses the library inside.
#include <rakelight/base/error.h>
#include <rakelight/geometry/attributes.h>

extern "C" __attribute__((visibility("default"))) int plugin_faces_up() {
    using namespace rakelight;
    try {
        Context context({.threads = 1});
        const std::vector<vec3> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        const std::vector<std::uint32_t> indices{0, 1, 2};
        AttributeMesh mesh;
        mesh.positions = positions;
        mesh.indices = indices;
        return compute_attributes({&mesh, 1}, {}, context)[0].normals[0].z > 0.5f;
    } catch (const Error&) {
        return -1;
    }
}
