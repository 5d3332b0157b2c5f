// SPDX-License-Identifier: Apache-2.0
// Uses the installed library from every layer: attributes without a scene, the facade, the way of one picture, inspection.
#include <rakelight/rakelight.h>

#include <cmath>
#include <cstdio>
#include <vector>

using namespace rakelight;

// consumer [MODEL]: a model of a rare format, for which the installed library must find its helper.
int main(int argc, char** argv) {
#ifdef IMPORT_HELPER
    Context context({.import_helper = IMPORT_HELPER});
#else
    Context context;
#endif
    if (argc > 1 && load(argv[1], {}, context).meshes.size() != 1) return std::puts("the model has no mesh"), 1;
    const std::vector<vec3> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const std::vector<std::uint32_t> indices{0, 1, 2};
    AttributeMesh mesh;
    mesh.positions = positions;
    mesh.indices = indices;
    const std::vector<MeshAttributes> attributes = compute_attributes({&mesh, 1}, {}, context);
    if (attributes.size() != 1 || std::fabs(attributes[0].normals[0].z - 1) > 1e-6f)
        return std::puts("wrong normal"), 1;

    const Inspection found = inspect(load("builtin:teapot", {}, context), {}, context);
    if (found.objects.size() != 6) return std::puts("wrong number of objects"), 1;

    PictureRequest request;
    request.input = "builtin:teapot";
    request.output = "consumer.png";
    request.settings.width = 64;
    request.settings.height = 48;
    const PictureResult result = render_picture(request, context);
    if (result.width != 64 || result.stats.pixels_covered == 0) return std::puts("empty picture"), 1;
    // As the README has it, with warnings as errors.
    Scene scene = load("builtin:teapot", {}, context);
    scene = smooth(scene, {.scope = Scope::model}, context);
    scene.lights.push_back({.type = LightType::point, .position = {0, 3, 4}, .diffuse = {1, 0.9f, 0.8f}});
    Session session;
    session.set(scene);
    const Camera camera = choose_camera(scene, {.side = "isometric"}, 4.0 / 3, context);
    Frame frame;
    session.render(camera, {.width = 64, .height = 48, .samples = 4}, frame, context);
    if (encode(frame, ".png").empty() || to_srgb8(frame).size() != 64 * 48) return std::puts("no picture"), 1;

    if (build_info().version != RAKELIGHT_VERSION) return std::puts("header and library differ"), 1;
    std::puts("ok");
    return 0;
}
