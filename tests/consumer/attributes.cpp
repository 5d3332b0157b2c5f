// SPDX-License-Identifier: Apache-2.0
// Uses the component attributes alone: two squares at a right angle get one normal along their common edge; a wrong index is an
// Error that crosses from the library; borders that share no vertex are matched.
#include <rakelight/base/error.h>
#include <rakelight/geometry/attributes.h>
#include <rakelight/geometry/creases.h>
#include <rakelight/geometry/matching_borders.h>
#include <rakelight/geometry/seams.h>
#include <rakelight/math/linear.h>

#include <cstdio>
#include <vector>

using namespace rakelight;

int main() {
    Context context;
    const std::vector<vec3> floor{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const std::vector<vec3> wall{{1, 0, 0}, {1, 0, 1}, {1, 1, 1}, {1, 1, 0}};
    const std::vector<vec2> uv{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const std::vector<std::uint32_t> indices{0, 1, 2, 0, 2, 3}, wrong{0, 1, 4};
    std::vector<AttributeMesh> meshes(2);
    meshes[0] = {.object = 0, .positions = floor, .indices = indices, .texcoords = uv};
    meshes[1] = {.object = 1, .positions = wall, .indices = indices, .texcoords = uv};
    AttributeOptions options;
    options.crease_angle_rad = radians(100);
    std::vector<MeshAttributes> result = compute_attributes(meshes, options, context);
    if (!(result[0].normals[1] == result[1].normals[0])) return std::puts("a seam"), 1;
    options.tangent_mode = TangentMode::mikktspace;
    if (compute_attributes(meshes, options, context)[0].tangents.size() != 4) return std::puts("no tangents"), 1;

    meshes[0].normals = result[0].normals;
    meshes[1].normals = result[1].normals;
    SeamReport seams;
    MatchReport borders;
    join_seams(meshes, {}, seams, context);
    join_borders(match_borders(meshes, {.distance = 0.01}, context), meshes, {}, borders, context);
    dmat4 inverse;
    if (!inverse_affine(look_at({0, 0, 1}, {0, 0, 0}, {0, 1, 0}), inverse)) return std::puts("no inverse"), 1;

    meshes[0].indices = wrong;
    try {
        compute_attributes(meshes, options, context);
        return std::puts("a wrong index was taken"), 1;
    } catch (const Error& error) {
        if (error.code() != ErrorCode::bad_file) return std::puts("another error"), 1;
    }
    std::puts("ok");
    return 0;
}
