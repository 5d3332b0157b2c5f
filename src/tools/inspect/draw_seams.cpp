// SPDX-License-Identifier: Apache-2.0
// The heat map: the model in gray, and its seams as lines of even width over it. The lines are drawn into the finished
// picture by its depths, so that they are as wide on a model of twelve triangles as on one of a million.
#include <rakelight/tools/draw_seams.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include <rakelight/scene/validate.h>
#include <rakelight/tools/inspect.h>

#include "engines/check_settings.h"
#include "math/color.h"
#include "math/functions.h"
#include "math/linear.h"
#include "prepare/prepare_scene.h"
#include "render/camera/camera_chooser.h"
#include "scene/placement.h"
#include "tools/inspect/largest_seam.h"
#include "tools/inspect/seam_legend.h"
#include "tools/inspect/seam_normals.h"
#include "tools/inspect/surfaces.h"

namespace rakelight {
namespace {

/// Every placement as a mesh of its own, gray, with the normals before; the cameras where they are.
Scene gray_scene(const Scene& scene, const InspectOptions& options, Context& context) {
    std::vector<std::uint32_t> objects;
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i)
        if (!scene.nodes[i].meshes.empty()) objects.push_back(i);
    const Surfaces surfaces = collect_surfaces(scene, objects, options.prepare.normals);
    std::vector<PartNormals> normals = normals_before(surfaces, options, context);
    Scene gray;
    gray.source = scene.source;
    const std::vector<dmat4> world = world_matrices(scene);
    gray.cameras = scene.cameras;
    for (Camera& camera : gray.cameras) {
        camera.to_world = camera_to_world(scene, camera, world);
        camera.node = no_index;
    }
    Material& material = gray.materials.emplace_back();
    material.model = MaterialModel::classical;
    material.base_color = {0.45f, 0.45f, 0.45f, 1};
    material.double_sided = true;
    for (std::size_t i = 0; i < surfaces.parts.size(); ++i) {
        const Mesh& source = scene.meshes[surfaces.parts[i].mesh];
        Mesh mesh{.positions = source.positions, .indices = source.indices, .normals = source.normals, .material = 0};
        if (normals[i].given.empty()) {
            PartNormals& made = normals[i];
            if (made.made.size() > source.positions.size()) {  // vertices were split
                std::vector<vec3> positions(source.positions.begin(), source.positions.end());
                positions.resize(made.made.size());
                for (std::size_t c = 0; c < made.indices.size(); ++c)
                    positions[made.indices[c]] = source.positions[source.indices[c]];
                mesh.positions = std::move(positions);
            }
            if (!made.indices.empty()) mesh.indices = std::move(made.indices);
            mesh.normals = std::move(made.made);
        }
        Node& node = gray.nodes.emplace_back();
        node.local.matrix = surfaces.meshes[i].to_world;
        node.meshes = {std::uint32_t(gray.meshes.size())};
        gray.meshes.push_back(std::move(mesh));
    }
    return gray;
}

/// A point in the picture [px], and how far it is along the view axis [m].
struct PicturePoint {
    double x, y, depth;
};

class SeamPainter {
public:
    SeamPainter(Frame& frame, const Camera& camera)
        : frame_(frame),
          camera_(camera),
          radius_px_(std::max(1.5, 0.003 * frame.height)),
          heat_deg_(frame.color.size(), 0),
          cover_(frame.color.size(), 0) {
        const bool parallel = camera.projection == Projection::orthographic;
        half_height_ = parallel ? camera.half_height : math::tan(0.5 * camera.vertical_fov_rad);
        std::optional<double> half_width = camera.half_width;
        if (!parallel) half_width.reset();
        if (!parallel && camera.horizontal_fov_rad) half_width = math::tan(0.5 * *camera.horizontal_fov_rad);
        if (half_width) pixel_height_ = half_height_ * frame.width / (*half_width * frame.height);
    }

    void paint(std::span<const SeamLine> lines) {
        for (const SeamLine& line : lines) add(line);
        for (std::size_t p = 0; p < cover_.size(); ++p) {
            if (!(cover_[p] > 0)) continue;
            const vec3 heat = heat_color(heat_deg_[p]), under = frame_.color[p].xyz();
            const vec3 color = under * (1 - cover_[p]) + heat * cover_[p];
            frame_.color[p] = {color.x, color.y, color.z, frame_.color[p].w};
        }
    }

    /// Where a point is in the frame; nothing where it is not in the picture.
    std::optional<SeamPlace> place_of(dvec3 position) const {
        const dvec3 c = to_camera(position);
        if (-c.z < camera_.z_near) return {};
        const PicturePoint p = project(c);
        const Window& w = frame_.window;
        const double x = p.x - w.x, y = p.y - w.y;
        if (!(x >= 0 && y >= 0 && x < w.width && y < w.height)) return {};
        const std::size_t at = std::size_t(y) * std::size_t(w.width) + std::size_t(x);
        return SeamPlace{x, y, double(frame_.depth[at]) < p.depth - reach_m(p.depth)};
    }

private:
    /// [m] A line lies on a surface that is so near to it.
    double reach_m(double depth) const { return 2.5 * radius_px_ * half_height_at(depth) / (0.5 * frame_.height); }

    dvec3 to_camera(dvec3 p) const {
        const dvec3 d = p - camera_.to_world[3].xyz();
        return {dot(d, camera_.to_world[0].xyz()), dot(d, camera_.to_world[1].xyz()),
                dot(d, camera_.to_world[2].xyz())};
    }

    /// Half of the visible height at a depth [m].
    double half_height_at(double depth) const {
        return camera_.projection == Projection::orthographic ? half_height_ : half_height_ * depth;
    }

    PicturePoint project(dvec3 c) const {
        const double half = 0.5 * frame_.height, scale = half / half_height_at(-c.z);
        return {0.5 * frame_.width + c.x * scale * pixel_height_, half - c.y * scale, -c.z};
    }

    void add(const SeamLine& line) {
        dvec3 a = to_camera(line.a), b = to_camera(line.b);
        double deg_a = line.deg_a, deg_b = line.deg_b;
        const double near = camera_.z_near;
        if (-a.z < near && -b.z < near) return;
        const auto cut = [&](dvec3& out, double& deg, dvec3 in, double in_deg) {  // at the near plane
            if (-out.z >= near) return;
            const double t = (-in.z - near) / (out.z - in.z);
            out = in + (out - in) * t;
            deg = in_deg + (deg - in_deg) * t;
        };
        cut(a, deg_a, b, deg_b);
        cut(b, deg_b, a, deg_a);
        walk(project(a), project(b), deg_a, deg_b);
    }

    /// The part t0..t1 of the line inside the whole picture, not only the window (Liang & Barsky 1984).
    bool clip(const PicturePoint& a, const PicturePoint& b, double& t0, double& t1) const {
        const double high[2] = {frame_.width + radius_px_, frame_.height + radius_px_};
        const double from[2] = {a.x, a.y}, along[2] = {b.x - a.x, b.y - a.y};
        for (int k = 0; k < 2; ++k) {
            if (along[k] == 0) {
                if (from[k] < -radius_px_ || from[k] > high[k]) return false;
                continue;
            }
            const double u = (-radius_px_ - from[k]) / along[k], v = (high[k] - from[k]) / along[k];
            t0 = std::fmax(t0, std::fmin(u, v));
            t1 = std::fmin(t1, std::fmax(u, v));
        }
        return t0 <= t1;
    }

    void walk(const PicturePoint& a, const PicturePoint& b, double deg_a, double deg_b) {
        double t0 = 0, t1 = 1;
        if (!clip(a, b, t0, t1)) return;
        const double pixels = (t1 - t0) * std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
        if (!std::isfinite(pixels)) return;  // of coordinates so large that their differences overflow
        const int steps = 1 + int(pixels / (0.5 * radius_px_));
        const bool parallel = camera_.projection == Projection::orthographic;
        for (int i = 0; i <= steps; ++i) {
            const double t = t0 + (t1 - t0) * i / steps;
            // In perspective 1 / depth is linear along the picture, and so is what is divided by depth.
            const double wa = parallel ? 1 - t : (1 - t) / a.depth, wb = parallel ? t : t / b.depth;
            const double w = wb / (wa + wb);
            dot_at({a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.depth + (b.depth - a.depth) * w},
                   deg_a + (deg_b - deg_a) * w);
        }
    }

    /// A disc with a soft rim on the surface that the point lies on.
    void dot_at(const PicturePoint& p, double deg) {
        if (!(deg > continuous_deg)) return;
        const Window& window = frame_.window;
        const double reach = reach_m(p.depth);
        const double reach_px = radius_px_ + 0.5;
        const int left = std::max(window.x, int(std::floor(p.x - reach_px)));
        const int right = std::min(window.x + window.width - 1, int(std::floor(p.x + reach_px)));
        const int top = std::max(window.y, int(std::floor(p.y - reach_px)));
        const int bottom = std::min(window.y + window.height - 1, int(std::floor(p.y + reach_px)));
        for (int y = top; y <= bottom; ++y)
            for (int x = left; x <= right; ++x) {
                const double dx = x + 0.5 - p.x, dy = y + 0.5 - p.y;
                const double cover = std::clamp(reach_px - std::sqrt(dx * dx + dy * dy), 0.0, 1.0);
                const std::size_t at =
                    std::size_t(y - window.y) * std::size_t(window.width) + std::size_t(x - window.x);
                if (cover == 0 || !(std::fabs(double(frame_.depth[at]) - p.depth) <= reach)) continue;
                cover_[at] = std::max(cover_[at], float(cover));
                heat_deg_[at] = std::max(heat_deg_[at], float(deg));
            }
    }

    Frame& frame_;
    const Camera& camera_;
    double radius_px_, half_height_ = 1, pixel_height_ = 1;  ///< the last: of a pixel's width
    std::vector<float> heat_deg_, cover_;                    ///< [pixels]
};

}  // namespace

Frame draw_seams(const Scene& scene, const Inspection& inspection, const InspectOptions& options,
                 const ViewRequest& view, const RenderSettings& settings, Context& context, SeamMarks marks) {
    check_settings(settings);
    check_options(options.prepare);
    validate(scene);
    const double aspect = double(settings.width) / double(settings.height);
    const Scene gray = gray_scene(scene, options, context);
    const Camera camera = valid::choose_camera(gray, view, aspect, settings.visibility, context);
    RenderSettings with_depth = settings;
    with_depth.channels |= channel_depth;
    Frame frame = render(gray, camera, with_depth, context);
    SeamPainter painter(frame, camera);
    painter.paint(inspection.seam_lines);
    if (marks == SeamMarks::legend) {
        const std::optional<LargestSeam> largest = largest_seam(inspection);
        draw_seam_legend(frame, inspection, largest ? painter.place_of(largest->position) : std::nullopt);
    }
    return frame;
}

// Grows lighter with the angle, so that colors are in order in gray too.
vec3 heat_color(double seam_deg) {
    struct Stop {
        double deg;
        std::uint8_t srgb[3];
    };
    // Five samples of "plasma" (Nathaniel J. Smith and Stefan van der Walt 2015, CC0).
    constexpr Stop stops[] = {{continuous_deg, {13, 8, 135}},
                              {1, {126, 3, 168}},
                              {5, {204, 71, 120}},
                              {20, {248, 149, 64}},
                              {60, {240, 249, 33}}};
    const auto color = [](const Stop& s) {
        return vec3{linear_from_srgb8(s.srgb[0]), linear_from_srgb8(s.srgb[1]), linear_from_srgb8(s.srgb[2])};
    };
    const Stop* above = std::begin(stops) + 1;
    while (above + 1 != std::end(stops) && above->deg < seam_deg) ++above;
    const Stop& below = above[-1];
    const double t = std::clamp((seam_deg - below.deg) / (above->deg - below.deg), 0.0, 1.0);
    return color(below) * float(1 - t) + color(*above) * float(t);
}

}  // namespace rakelight
