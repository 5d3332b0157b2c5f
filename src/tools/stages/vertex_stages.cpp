// SPDX-License-Identifier: Apache-2.0
// The spaces that vertices go through, from the file to the screen. Tables are the engine's numbers; pictures are plots
// of them.
#include <algorithm>
#include <cmath>

#include "tools/stages/plot.h"

namespace rakelight::stages {
namespace {

using shading::ClipVertex;

std::vector<double> list(dvec3 p) { return {p.x, p.y, p.z}; }

Stage make_model_stage(const Sources& of) {
    const Vertices vertices(of);
    Stage s{.id = "model",
            .title = "Model space",
            .text =
                "Each mesh as in its file: every object is at its own origin, so several are in one place. Vertices "
                "and triangles are read once and never changed."};
    add_plot(s, of, vertices, "model",
             {.caption = "All meshes in their own coordinates, seen obliquely.",
              .place = [&](std::size_t d, std::uint32_t v) { return oblique(vertices.model(d, v)); }});
    add_table(s, vertices, false, {"x", "y", "z"},
              [&](std::size_t d, std::uint32_t v) { return list(vertices.model(d, v)); });
    return s;
}

/// Rotates the world about its vertical axis. The camera then looks to the right in the oblique view, a little into the
/// picture: seen along its own axis, a frustum would look like a frame.
class SeenFromAside {
public:
    explicit SeenFromAside(const shading::PictureCamera& view) {
        const dvec3 back = view.camera_to_world[2].xyz();
        const double length = std::sqrt(back.x * back.x + back.z * back.z);
        if (length < 1e-6) return;  // straight up or down: seen from aside as it is
        // The picture's right is (1, 0, -1), into it (-1, 0, -1): between them, nearer to the right.
        const dvec2 to{0.25881904510252074, -0.96592582628906831}, from{-back.x / length, -back.z / length};
        cos_ = from.x * to.x + from.y * to.y;
        sin_ = from.x * to.y - from.y * to.x;
    }
    dvec2 operator()(dvec3 p) const { return oblique({cos_ * p.x - sin_ * p.z, p.y, sin_ * p.x + cos_ * p.z}); }

private:
    double cos_ = 1, sin_ = 0;
};

Stage make_world_stage(const Sources& of) {
    const Vertices vertices(of);
    Stage s{.id = "world",
            .title = "World space",
            .text =
                "Each object's placement, a 4 x 4 matrix, brings its vertices to their place in one common space, in "
                "meters, Y up. "
                "The camera and the lights stand there too. The placement is computed in double precision."};
    const shading::PictureCamera& view = of.engine.view();
    const dvec3 eye = view.camera_to_world[3].xyz();
    const SeenFromAside seen(view);
    Space space{.caption =
                    "The objects in place, and in orange the camera with its frustum; rotated about the vertical so "
                    "that the camera looks to the right.",
                .place = [&](std::size_t d, std::uint32_t v) { return seen(vertices.world(d, v)); }};
    const std::array<dvec3, 8> corners = frustum(view, std::min(view.z_far, vertices.farthest()));
    const auto at = [&](std::size_t i) { return seen(transform_point(view.camera_to_world, corners[i])); };
    for (std::size_t i = 0; i < 4; ++i) {
        space.before.push_back({at(i), at((i + 1) % 4)});
        space.before.push_back({at(i + 4), at((i + 1) % 4 + 4)});
        space.before.push_back({view.orthographic ? at(i) : seen(eye), at(i + 4)});
    }
    add_plot(s, of, vertices, "world", space);
    s.numbers["eye"] = {eye.x, eye.y, eye.z};
    add_table(s, vertices, false, {"x", "y", "z"},
              [&](std::size_t d, std::uint32_t v) { return list(vertices.world(d, v)); });
    return s;
}

Stage make_camera_stage(const Sources& of) {
    const Vertices vertices(of);
    Stage s{.id = "camera",
            .title = "Camera space",
            .text =
                "The world turned and moved so that the eye is the origin, x goes right, y up, and the camera looks "
                "along -z. "
                "Seen from the right: the eye on the left, the near plane as a vertical line."};
    const shading::PictureCamera& view = of.engine.view();
    const double far = std::min(view.z_far, vertices.farthest());
    const auto half_height = [&](double distance) { return (view.orthographic ? 1 : distance) / view.scale_y; };
    Space space{.caption = "Distance to the right, y up; in orange what the camera can see, from the near plane on.",
                .place = [&](std::size_t d, std::uint32_t v) {
                    const dvec3 p = vertices.camera(d, v);
                    return dvec2{-p.z, p.y};
                }};
    space.behind.push_back({{0, 0}, {far, 0}, axis});
    for (const double y : {-1.0, 1.0}) space.before.push_back({{0, y * half_height(0)}, {far, y * half_height(far)}});
    for (const double at : {view.z_near, far}) space.before.push_back({{at, -half_height(at)}, {at, half_height(at)}});
    add_plot(s, of, vertices, "camera", space);
    s.numbers["near"] = view.z_near;
    s.numbers["far"] = cell(view.z_far);
    add_table(s, vertices, false, {"x", "y", "z"},
              [&](std::size_t d, std::uint32_t v) { return list(vertices.camera(d, v)); });
    return s;
}

Stage make_device_stage(const Sources& of) {
    const Vertices vertices(of);
    Stage s{.id = "device",
            .title = "Normalized device coordinates",
            .text =
                "After the division by w: the picture is the square from -1 to 1. This is the central projection. The "
                "depth that is compared is near / distance "
                "in perspective: 1 at the near plane, 0 at infinity, straight on the screen, so that it can be stepped "
                "from pixel to pixel. Vertices behind the near plane have no place here (nan is listed)."};
    const double near = of.engine.view().z_near, nan = std::nan("");
    const auto device = [&](std::size_t d, std::uint32_t v) {
        return double(vertices.clip(d, v).distance) < near ? dvec3{nan, nan, nan} : vertices.device(d, v);
    };
    Space space{.caption = "x to the right, y up; in orange the square that becomes the picture.",
                .only_transformed = true,
                .place =
                    [&](std::size_t d, std::uint32_t v) {
                        const dvec3 p = device(d, v);
                        return dvec2{p.x, p.y};
                    },
                .fixed = fit({-1.2, -1.2}, {1.2, 1.2}, of.engine.settings().width, of.engine.settings().height)};
    const dvec2 corners[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    for (std::size_t k = 0; k < 4; ++k) space.before.push_back({corners[k], corners[(k + 1) % 4]});
    add_plot(s, of, vertices, "device", space);
    add_table(s, vertices, true, {"x", "y", "depth key"},
              [&](std::size_t d, std::uint32_t v) { return list(device(d, v)); });
    return s;
}

Stage make_screen_stage(const Sources& of) {
    const Vertices vertices(of);
    Stage s{.id = "screen",
            .title = "Screen",
            .text =
                "Stretched to pixels: 0, 0 is the outer corner of the top left one, y goes down. Corners are rounded "
                "to 1/256 pixel; from here on coverage is decided in whole numbers, "
                "so that triangles which share an edge leave no gap and cover nothing twice."};
    const shading::PictureCamera& view = of.engine.view();
    const double nan = std::nan("");
    const auto screen = [&](std::size_t d, std::uint32_t v) {
        const ClipVertex c = vertices.clip(d, v);
        return double(c.distance) < view.z_near ? dvec2{nan, nan} : view.screen(c);
    };
    add_plot(s, of, vertices, "screen",
             {.caption = "The triangles as they lie on the picture.",
              .only_transformed = true,
              .place =
                  [&](std::size_t d, std::uint32_t v) {
                      const dvec2 p = screen(d, v);
                      return dvec2{p.x, -p.y};  // y is down already
                  },
              .fixed = Fit{}});
    add_table(s, vertices, true, {"x [px]", "y [px]", "x [1/256 px]", "y [1/256 px]"},
              [&](std::size_t d, std::uint32_t v) {
                  const dvec2 p = screen(d, v);
                  if (std::isnan(p.x)) return std::vector<double>(4, nan);
                  const raster::SnappedPlace snapped = raster::snapped_place(view, vertices.clip(d, v));
                  return std::vector<double>{p.x, p.y, double(snapped.x), double(snapped.y)};
              });
    return s;
}

}  // namespace

constinit const StageKind model_stage{make_model_stage}, world_stage{make_world_stage}, camera_stage{make_camera_stage};
constinit const StageKind device_stage{make_device_stage}, screen_stage{make_screen_stage};

}  // namespace rakelight::stages
