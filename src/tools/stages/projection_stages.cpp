// SPDX-License-Identifier: Apache-2.0
// The projection in the textbook's three steps: frustum normalized to 90 degrees, central projection, depth mapped to a
// fixed range. The engine does the first two in one (clip space is their result before the division); each is shown
// here by itself, in double.
#include <algorithm>
#include <cmath>
#include <limits>

#include "tools/stages/plot.h"

namespace rakelight::stages {
namespace {

constexpr Code ray{90, 100, 120}, dot{240, 220, 90};

Cell matrix(const double (&rows)[4][4]) {
    Cell::List all;
    for (const auto& row : rows) all.push_back({cell(row[0]), cell(row[1]), cell(row[2]), cell(row[3])});
    return all;
}

/// Vertices in camera space with the frustum's sides at 45 degrees (parallel projection: at x, y = +-1).
class Normalized {
public:
    Normalized(const Sources& of, const Vertices& vertices) : vertices_(vertices), view_(of.engine.view()) {}

    dvec3 operator()(std::size_t d, std::uint32_t v) const {
        const dvec3 p = vertices_.camera(d, v);
        return {p.x * view_.scale_x, p.y * view_.scale_y, p.z};
    }
    bool is_before_eye(dvec3 p) const { return -p.z >= view_.z_near; }
    double w(dvec3 p) const { return view_.orthographic ? 1 : -p.z; }
    double half_width(double distance) const { return view_.orthographic ? 1 : distance; }

private:
    const Vertices& vertices_;
    const shading::PictureCamera& view_;
};

Stage make_frustum_stage(const Sources& of) {
    const Vertices vertices(of);
    const shading::PictureCamera& view = of.engine.view();
    const Normalized normalized(of, vertices);
    Stage s{.id = "normalized-frustum", .title = "Projection 1: the frustum normalized"};
    s.text = view.orthographic ? "x and y are scaled so that what the camera sees lies between -1 and 1 in both; the "
                                 "projection is parallel, so the frustum is a box."
                               : "x and y are scaled by 1 / tan of half the field of view, so that the frustum opens "
                                 "by 90 degrees in both directions: its sides are the planes x = +-z and "
                                 "y = +-z, whatever the camera. Depth stays as it is.";
    const double far = std::min(view.z_far, vertices.farthest());
    for (const bool from_above : {false, true}) {
        Space space{.caption = from_above ? "From above: distance to the right, x up; in orange the frustum."
                                          : "From the side: distance to the right, y up; in orange the frustum.",
                    .place = [&normalized, from_above](std::size_t d, std::uint32_t v) {
                        const dvec3 p = normalized(d, v);
                        return dvec2{-p.z, from_above ? p.x : p.y};
                    }};
        space.behind.push_back({{0, 0}, {far, 0}, axis});
        for (const double side : {-1.0, 1.0})
            space.before.push_back({{0, side * normalized.half_width(0)}, {far, side * normalized.half_width(far)}});
        for (const double at : {view.z_near, far})
            space.before.push_back({{at, -normalized.half_width(at)}, {at, normalized.half_width(at)}});
        add_plot(s, of, vertices, from_above ? "normalized-frustum-above" : "normalized-frustum", space);
    }
    s.numbers["matrix"] = matrix({{view.scale_x, 0, 0, 0}, {0, view.scale_y, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}});
    add_table(s, vertices, false, {"x", "y", "z"}, [&](std::size_t d, std::uint32_t v) {
        const dvec3 p = normalized(d, v);
        return std::vector<double>{p.x, p.y, p.z};
    });
    return s;
}

/// Rays from the eye to a dozen vertices in front of it, spread over the list, and where they hit a plane.
void add_rays(Space& space, const Vertices& vertices, const Normalized& normalized, double plane) {
    std::vector<dvec3> before;
    for (std::size_t d = 0; d < vertices.draws().size(); ++d)
        for (std::uint32_t v = 0; v < vertices.mesh(d).positions.size();
             v += 1 + std::uint32_t(vertices.mesh(d).positions.size() / 64))
            if (const dvec3 p = normalized(d, v); normalized.is_before_eye(p)) before.push_back(p);
    const double mark = 0.01 * plane;
    for (std::size_t i = 0; i < before.size(); i += 1 + before.size() / 12) {
        const dvec3 p = before[i];
        const double y = p.y / normalized.w(p) * normalized.half_width(plane);
        space.behind.push_back({{0, p.y * normalized.half_width(0)}, {-p.z, p.y}, ray});
        space.before.push_back({{plane, y - mark}, {plane, y + mark}, dot});
        space.before.push_back({{plane - mark, y}, {plane + mark, y}, dot});
    }
}

double nearest_before(const Vertices& vertices, double near) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t d = 0; d < vertices.draws().size(); ++d)
        for (std::uint32_t v = 0; v < vertices.mesh(d).positions.size(); ++v)
            if (const double distance = -vertices.camera(d, v).z; distance >= near)
                nearest = std::min(nearest, distance);
    return std::isfinite(nearest) ? nearest : near;
}

/// What there is up to a distance: a plot from the eye on, with all of the model in the frustum.
Fit fit_to(double reach, const Sources& of, const Vertices& vertices, const Normalized& normalized) {
    double tall = 0.2 * reach;
    for (std::size_t d = 0; d < vertices.draws().size(); ++d)
        for (std::uint32_t v = 0; v < vertices.mesh(d).positions.size(); ++v)
            if (const dvec3 p = normalized(d, v); normalized.is_before_eye(p) && -p.z <= reach)
                tall = std::max(tall, std::min(std::fabs(p.y), normalized.half_width(reach)));
    return fit({0, -tall}, {reach, tall}, of.engine.settings().width, of.engine.settings().height);
}

Stage make_central_stage(const Sources& of) {
    const Vertices vertices(of);
    const shading::PictureCamera& view = of.engine.view();
    const Normalized normalized(of, vertices);
    const double nan = std::nan(""), plane = std::max(0.5 * nearest_before(vertices, view.z_near), view.z_near);
    Stage s{.id = "central-projection",
            .title = view.orthographic ? "Projection 2: parallel projection" : "Projection 2: central projection"};
    s.text = view.orthographic
                 ? "Along the view axis onto a plane: x and y stay, depth is dropped. w stays 1, so nothing has to be "
                   "divided."
                 : "From the eye onto the plane at distance 1: the last row of the matrix makes w = -z, the distance "
                   "along the view axis, and the division by w makes x / w and y / w, "
                   "between -1 and 1 for what is in the frustum, and z = -1 for all. It is right only for what lies "
                   "before the eye: in the pipeline the division waits until clipping is done. "
                   "Vertices behind the near plane have no place here (nan is listed).";
    const double reach = std::min(1.05 * vertices.farthest(), 8 * plane);
    Space space{.caption = std::string(view.orthographic ? "Rays along the view axis" : "Rays from the eye") +
                           " through the plane (orange) to some of the vertices, and in yellow where they meet it. The "
                           "plane is drawn at " +
                           digits(plane) + " m: the picture on any other is the same" +
                           (view.orthographic ? "." : ", larger or smaller."),
                .place =
                    [&](std::size_t d, std::uint32_t v) {
                        const dvec3 p = normalized(d, v);
                        return normalized.is_before_eye(p) ? dvec2{-p.z, p.y} : dvec2{nan, nan};
                    },
                .fixed = fit_to(reach, of, vertices, normalized)};
    space.behind.push_back({{0, 0}, {plane, 0}, axis});
    add_rays(space, vertices, normalized, plane);
    space.before.push_back({{plane, -normalized.half_width(plane)}, {plane, normalized.half_width(plane)}});
    add_plot(s, of, vertices, "central-projection", space);
    s.numbers["matrix"] = view.orthographic ? matrix({{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 1}})
                                            : matrix({{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, -1, 0}});
    add_table(s, vertices, false, {"w", "x / w", "y / w"}, [&](std::size_t d, std::uint32_t v) {
        const dvec3 p = normalized(d, v);
        if (!normalized.is_before_eye(p)) return std::vector<double>{normalized.w(p), nan, nan};
        return std::vector<double>{normalized.w(p), p.x / normalized.w(p), p.y / normalized.w(p)};
    });
    return s;
}

/// The third row of the projection, scale and offset of z: near plane to `low`, far plane to 1.
struct DepthRow {
    double scale, offset;
    DepthRow(const shading::PictureCamera& view, double low) {
        const double near = view.z_near, far = view.z_far;
        if (view.orthographic) {  // scale z + offset is `low` at -near and 1 at -far
            scale = (low - 1) / (far - near);
            offset = low + scale * near;
        } else {  // (scale z + offset) / -z is; far may be infinite
            scale = std::isfinite(far) ? (low * near - far) / (far - near) : -1;
            offset = std::isfinite(far) ? (low - 1) * near * far / (far - near) : (low - 1) * near;
        }
    }
    Cell rows(const shading::PictureCamera& view) const {
        const double w = view.orthographic ? 0 : -1;
        return matrix({{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, scale, offset}, {0, 0, w, 1 + w}});
    }
};

Stage make_depth_mapping_stage(const Sources& of) {
    const Vertices vertices(of);
    const shading::PictureCamera& view = of.engine.view();
    const Normalized normalized(of, vertices);
    const DepthRow from_zero(view, 0), from_minus(view, -1);
    const double nan = std::nan("");
    Stage s{.id = "depth-mapping", .title = "Projection 3: depth mapped to a fixed range"};
    s.text =
        "The third row of the matrix keeps the depth that the projection alone would lose: the near plane becomes 0 "
        "(or -1, as OpenGL has it) and the far plane 1, so that the frustum becomes a box. "
        "Lines stay lines. ";
    s.text += view.orthographic
                  ? "In parallel projection the mapping is even."
                  : "In perspective the mapping is uneven: 1 / distance, scaled and moved, so most of the range is "
                    "spent near the near plane. The engine compares near / distance, the same "
                    "turned round, from 1 at the near plane to 0 at infinity.";
    const auto mapped = [&](const DepthRow& row, dvec3 p) { return (row.scale * p.z + row.offset) / normalized.w(p); };
    double low = 1, high = 0;
    for (std::size_t d = 0; d < vertices.draws().size(); ++d)
        for (std::uint32_t v = 0; v < vertices.mesh(d).positions.size(); ++v)
            if (const dvec3 p = normalized(d, v); normalized.is_before_eye(p))
                low = std::min(low, mapped(from_zero, p)), high = std::max(high, mapped(from_zero, p));
    high = std::min(high, 1.0);
    const double part = high > low ? high - low : 1;
    for (const bool stretched : {false, true}) {
        if (stretched && part > 0.7) break;
        const double start = stretched ? low : 0, width = stretched ? part : 1;
        Space space{.caption = stretched ? "The part of the depths that the model takes, " + digits(low) + " to " +
                                               digits(high) + ", stretched."
                                         : "From the side: mapped depth from 0 to 1 to the right, y from -1 to 1 up; "
                                           "in orange the box that the frustum became.",
                    .place =
                        [&, start, width](std::size_t d, std::uint32_t v) {
                            const dvec3 p = normalized(d, v);
                            return normalized.is_before_eye(p)
                                       ? dvec2{3 * (mapped(from_zero, p) - start) / width, p.y / normalized.w(p)}
                                       : dvec2{nan, nan};
                        },
                    .fixed = fit({-0.1, -1.1}, {3.1, 1.1}, of.engine.settings().width, of.engine.settings().height)};
        const dvec2 corners[] = {{0, -1}, {3, -1}, {3, 1}, {0, 1}};
        for (std::size_t k = 0; k < 4; ++k) space.before.push_back({corners[k], corners[(k + 1) % 4]});
        add_plot(s, of, vertices, stretched ? "depth-mapping-model" : "depth-mapping", space);
    }
    s.numbers["near"] = view.z_near;
    s.numbers["far"] = cell(view.z_far);
    s.numbers["matrix of steps 2 and 3, depth from 0 to 1"] = from_zero.rows(view);
    s.numbers["matrix of steps 2 and 3, depth from -1 to 1"] = from_minus.rows(view);
    add_table(
        s, vertices, false, {"distance", "depth, 0 to 1", "depth, -1 to 1", "depth key"},
        [&](std::size_t d, std::uint32_t v) {
            const dvec3 p = normalized(d, v);
            if (!normalized.is_before_eye(p)) return std::vector<double>{-p.z, nan, nan, nan};
            return std::vector<double>{-p.z, mapped(from_zero, p), mapped(from_minus, p), vertices.depth_key(-p.z)};
        });
    return s;
}

}  // namespace

constinit const StageKind frustum_stage{make_frustum_stage}, central_stage{make_central_stage},
    depth_mapping_stage{make_depth_mapping_stage};

}  // namespace rakelight::stages
