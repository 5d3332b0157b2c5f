// SPDX-License-Identifier: Apache-2.0
// The stages that vertices go through. Tables are the engine's numbers; pictures are plots of them.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include <rakelight/error.h>

#include "math/linear.h"
#include "tools/stages/stage.h"

namespace rakelight::stages {
namespace {

using raster::ClipVertex;
using raster::Draw;

constexpr std::size_t listed_vertices = 48, drawn_triangles = 150000, listed_polygons = 48;
constexpr Code ground{16, 18, 24}, wire{150, 190, 230}, frame{240, 170, 60}, red{255, 80, 60}, axis{70, 80, 100};

Json cell(double v) { return std::isfinite(v) ? Json(v) : Json(v > 0 ? "inf" : v < 0 ? "-inf" : "nan"); }

/// The vertices of the scene in every space, draw by draw.
class Vertices {
public:
    explicit Vertices(const Sources& of) : of_(of) {}

    const std::vector<Draw>& draws() const { return of_.engine.list().draws; }
    const Mesh& mesh(std::size_t d) const { return of_.engine.list().scene.meshes[draws()[d].mesh]; }
    bool is_transformed(std::size_t d) const { return !of_.drawn.front.clip[d].empty(); }

    dvec3 model(std::size_t d, std::uint32_t v) const { return cast<double>(mesh(d).positions[v]); }
    dvec3 world(std::size_t d, std::uint32_t v) const { return transform_point(draws()[d].to_world, model(d, v)); }
    dvec3 camera(std::size_t d, std::uint32_t v) const { return transform_point(of_.engine.view().world_to_camera, world(d, v)); }
    /// The engine's own; not there for objects that are wholly outside.
    ClipVertex clip(std::size_t d, std::uint32_t v) const { return of_.drawn.front.clip[d][v]; }
    double depth_key(const ClipVertex& c) const {
        const raster::View& view = of_.engine.view();
        return view.orthographic ? 1 - (double(c.distance) - view.near) / (view.far - view.near) : view.near / double(c.distance);
    }
    dvec3 device(std::size_t d, std::uint32_t v) const {
        const ClipVertex c = clip(d, v);
        return {double(c.x) / double(c.w), double(c.y) / double(c.w), depth_key(c)};
    }

private:
    const Sources& of_;
};

using Place = std::function<dvec2(std::size_t draw, std::uint32_t vertex)>;

/// Maps a rectangle of a plot into a picture with equal scales, y up.
struct Fit {
    double scale = 1, x = 0, y = 0;
    dvec2 operator()(dvec2 p) const { return {x + p.x * scale, y - p.y * scale}; }
};

Fit fit(dvec2 low, dvec2 high, int width, int height) {
    const double w = std::max(high.x - low.x, 1e-30), h = std::max(high.y - low.y, 1e-30);
    Fit f;
    f.scale = std::min(width * 0.9 / w, height * 0.9 / h);
    f.x = width * 0.5 - (low.x + high.x) * 0.5 * f.scale;
    f.y = height * 0.5 + (low.y + high.y) * 0.5 * f.scale;
    return f;
}

struct Extent {
    dvec2 low{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
    dvec2 high{-std::numeric_limits<double>::max(), -std::numeric_limits<double>::max()};
    void add(dvec2 p) {
        if (!std::isfinite(p.x) || !std::isfinite(p.y)) return;
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    bool is_empty() const { return low.x > high.x; }
};

/// Every so many-th triangle's outline, so that large models stay lines.
class WirePlot {
public:
    WirePlot(const Sources& of, const Vertices& vertices, bool only_transformed) : of_(of), vertices_(vertices) {
        std::size_t total = 0;
        for (std::size_t d = 0; d < vertices.draws().size(); ++d)
            if (!only_transformed || vertices.is_transformed(d)) draws_.push_back(d), total += vertices.mesh(d).triangle_count();
        step_ = total / drawn_triangles + 1;
    }

    Extent extent(const Place& place) const {
        Extent e;
        visit([&](std::size_t d, const std::uint32_t* index) {
            for (int k = 0; k < 3; ++k) e.add(place(d, index[k]));
        });
        return e;
    }
    void draw(Canvas& canvas, const Fit& f, const Place& place) const {
        visit([&](std::size_t d, const std::uint32_t* index) {
            const dvec2 p[3] = {f(place(d, index[0])), f(place(d, index[1])), f(place(d, index[2]))};
            for (int k = 0; k < 3; ++k) canvas.line(p[k], p[(k + 1) % 3], wire);
        });
    }
    std::string note() const { return step_ > 1 ? " One of " + std::to_string(step_) + " triangles is drawn." : ""; }
    Canvas canvas() const { return {of_.engine.settings().width, of_.engine.settings().height, ground}; }

private:
    template <class Visit>
    void visit(const Visit& visit) const {
        std::size_t n = 0;
        for (const std::size_t d : draws_) {
            const Mesh& mesh = vertices_.mesh(d);
            for (std::size_t t = 0; t < mesh.triangle_count(); ++t)
                if (n++ % step_ == 0) visit(d, mesh.indices.data() + 3 * t);
        }
    }
    const Sources& of_;
    const Vertices& vertices_;
    std::vector<std::size_t> draws_;
    std::size_t step_ = 1;
};

/// A parallel view from the right, above and in front (isometric).
dvec2 oblique(dvec3 p) { return {(p.x - p.z) * 0.70710678118654752, p.y * 0.81649658092772603 - (p.x + p.z) * 0.40824829046386302}; }

/// Rows of numbers and the range of each column, for all vertices of a space.
void add_table(Stage& stage, const Sources& of, const Vertices& vertices, bool only_transformed, std::vector<std::string> columns,
               const std::function<std::vector<double>(std::size_t, std::uint32_t)>& values) {
    std::vector<double> low(columns.size(), std::numeric_limits<double>::infinity()), high(columns.size(), -std::numeric_limits<double>::infinity());
    std::size_t count = 0;
    for (std::size_t d = 0; d < vertices.draws().size(); ++d) {
        if (only_transformed && !vertices.is_transformed(d)) continue;
        const std::string& object = of.engine.list().scene.nodes[vertices.draws()[d].node].name;
        for (std::uint32_t v = 0; v < vertices.mesh(d).positions.size(); ++v, ++count) {
            const std::vector<double> row = values(d, v);
            for (std::size_t c = 0; c < row.size(); ++c) {
                if (!std::isfinite(row[c])) continue;
                low[c] = std::min(low[c], row[c]);
                high[c] = std::max(high[c], row[c]);
            }
            if (count >= listed_vertices) continue;
            Json cells = {object, v};
            for (const double value : row) cells.push_back(cell(value));
            stage.rows.push_back(std::move(cells));
        }
    }
    stage.numbers["vertices"] = count;
    for (std::size_t c = 0; c < columns.size(); ++c) stage.numbers["range of " + columns[c]] = {cell(low[c]), cell(high[c])};
    stage.columns = {"object", "vertex"};
    stage.columns.insert(stage.columns.end(), columns.begin(), columns.end());
    stage.rows_note = "The first " + std::to_string(stage.rows.size()) + " of " + std::to_string(count) + " vertices";
}

Stage model_stage(const Sources& of, const Vertices& vertices) {
    Stage s{.id = "model", .title = "Model space", .text = "Each mesh as its file has it: every object about its own origin, so several lie in one place. "
            "Vertices and triangles are read once and never changed."};
    const WirePlot plot(of, vertices, false);
    const Place place = [&](std::size_t d, std::uint32_t v) { return oblique(vertices.model(d, v)); };
    const Extent e = plot.extent(place);
    Canvas canvas = plot.canvas();
    if (!e.is_empty()) plot.draw(canvas, fit(e.low, e.high, canvas.width(), canvas.height()), place);
    s.pictures.push_back({"model", "All meshes in their own coordinates, seen obliquely." + plot.note(), std::move(canvas)});
    add_table(s, of, vertices, false, {"x", "y", "z"}, [&](std::size_t d, std::uint32_t v) {
        const dvec3 p = vertices.model(d, v);
        return std::vector<double>{p.x, p.y, p.z};
    });
    return s;
}

/// The corners of the frustum at the near plane and at a distance, in the world; [0..3] near, [4..7] far.
std::array<dvec3, 8> frustum(const raster::View& view, double far) {
    std::array<dvec3, 8> corners;
    for (std::size_t i = 0; i < 8; ++i) {
        const double distance = i < 4 ? view.near : far, w = view.orthographic ? 1 : distance;
        const double x = (i % 4 == 1 || i % 4 == 2 ? 1 : -1) * w / view.scale_x, y = (i % 4 >= 2 ? 1 : -1) * w / view.scale_y;
        corners[i] = transform_point(view.camera_to_world, dvec3{x, y, -distance});
    }
    return corners;
}

double farthest(const Vertices& vertices) {
    double far = 0;
    for (std::size_t d = 0; d < vertices.draws().size(); ++d)
        for (std::uint32_t v = 0; v < vertices.mesh(d).positions.size(); ++v) {
            const double distance = -vertices.camera(d, v).z;
            if (std::isfinite(distance)) far = std::max(far, distance);
        }
    return far;
}

Stage world_stage(const Sources& of, const Vertices& vertices) {
    Stage s{.id = "world", .title = "World space", .text = "Each object's placement, a 4 x 4 matrix, brings its vertices to their place in one common space, in meters, Y up. "
            "The camera and the lights stand there too. The placement is computed in double precision."};
    const WirePlot plot(of, vertices, false);
    const Place place = [&](std::size_t d, std::uint32_t v) { return oblique(vertices.world(d, v)); };
    Extent e = plot.extent(place);
    const raster::View& view = of.engine.view();
    const std::array<dvec3, 8> corners = frustum(view, std::min(view.far, farthest(vertices)));
    for (const dvec3& c : corners) e.add(oblique(c));
    const dvec3 eye = view.camera_to_world[3].xyz();
    e.add(oblique(eye));
    Canvas canvas = plot.canvas();
    const Fit f = fit(e.low, e.high, canvas.width(), canvas.height());
    plot.draw(canvas, f, place);
    for (std::size_t i = 0; i < 4; ++i) {
        canvas.line(f(oblique(corners[i])), f(oblique(corners[(i + 1) % 4])), frame);
        canvas.line(f(oblique(corners[i + 4])), f(oblique(corners[(i + 1) % 4 + 4])), frame);
        canvas.line(f(oblique(view.orthographic ? corners[i] : eye)), f(oblique(corners[i + 4])), frame);
    }
    s.pictures.push_back({"world", "The objects in place, and in orange the camera with what it can see." + plot.note(), std::move(canvas)});
    s.numbers["eye"] = {eye.x, eye.y, eye.z};
    add_table(s, of, vertices, false, {"x", "y", "z"}, [&](std::size_t d, std::uint32_t v) {
        const dvec3 p = vertices.world(d, v);
        return std::vector<double>{p.x, p.y, p.z};
    });
    return s;
}

Stage camera_stage(const Sources& of, const Vertices& vertices) {
    Stage s{.id = "camera", .title = "Camera space", .text = "The world turned and moved so that the eye is the origin, x goes right, y up, and the camera looks along -z. "
            "Seen from the right: the eye on the left, the near plane as a vertical line."};
    const WirePlot plot(of, vertices, false);
    const Place place = [&](std::size_t d, std::uint32_t v) {
        const dvec3 p = vertices.camera(d, v);
        return dvec2{-p.z, p.y};
    };
    const raster::View& view = of.engine.view();
    const double far = std::min(view.far, farthest(vertices));
    const auto half_height = [&](double distance) { return (view.orthographic ? 1 : distance) / view.scale_y; };
    Extent e = plot.extent(place);
    for (const double y : {-1.0, 1.0}) e.add({far, y * half_height(far)});
    e.add({0, 0});
    Canvas canvas = plot.canvas();
    const Fit f = fit(e.low, e.high, canvas.width(), canvas.height());
    canvas.line(f({0, 0}), f({far, 0}), axis);
    plot.draw(canvas, f, place);
    for (const double y : {-1.0, 1.0}) canvas.line(f({0, y * half_height(0)}), f({far, y * half_height(far)}), frame);
    for (const double at : {view.near, far}) canvas.line(f({at, -half_height(at)}), f({at, half_height(at)}), frame);
    s.pictures.push_back({"camera", "Distance to the right, y up; in orange what the camera can see, from the near plane on." + plot.note(), std::move(canvas)});
    s.numbers["near"] = view.near;
    s.numbers["far"] = cell(view.far);
    add_table(s, of, vertices, false, {"x", "y", "z"}, [&](std::size_t d, std::uint32_t v) {
        const dvec3 p = vertices.camera(d, v);
        return std::vector<double>{p.x, p.y, p.z};
    });
    return s;
}

Stage clip_stage(const Sources& of, const Vertices& vertices) {
    Stage s{.id = "clip-space", .title = "Clip space, before the division", .text = "x and y are scaled so that the frustum's sides become the planes x = +-w and y = +-w: in perspective, where w is the "
            "distance along the view axis, a frustum of 90 degrees. Here the engine goes from double to single precision. Clipping is done here, because "
            "behind the eye w is negative, and a division would wrap such points round to the front."};
    const WirePlot plot(of, vertices, true);
    const bool parallel = of.engine.view().orthographic;
    const Place place = [&](std::size_t d, std::uint32_t v) {
        const ClipVertex c = vertices.clip(d, v);
        return dvec2{double(c.distance), double(c.y)};
    };
    Extent e = plot.extent(place);
    e.add({0, 0});
    if (e.is_empty()) e.add({1, 1});
    const double far = e.high.x;
    for (const double y : {-1.0, 1.0}) e.add({far, y * (parallel ? 1 : far)});
    Canvas canvas = plot.canvas();
    const Fit f = fit(e.low, e.high, canvas.width(), canvas.height());
    canvas.line(f({0, 0}), f({far, 0}), axis);
    plot.draw(canvas, f, place);
    for (const double y : {-1.0, 1.0}) canvas.line(f({0, parallel ? y : 0}), f({far, y * (parallel ? 1 : far)}), frame);
    const double near = of.engine.view().near, w = parallel ? 1 : near;
    canvas.line(f({near, -w}), f({near, w}), frame);
    s.pictures.push_back({"clip-space", std::string(parallel ? "Distance" : "w") + " to the right, y up; in orange the planes y = +-w and the near plane." + plot.note(), std::move(canvas)});
    add_table(s, of, vertices, true, {"x", "y", "w", "distance"}, [&](std::size_t d, std::uint32_t v) {
        const ClipVertex c = vertices.clip(d, v);
        return std::vector<double>{double(c.x), double(c.y), double(c.w), double(c.distance)};
    });
    return s;
}

Stage clipping_stage(const Sources& of, const Vertices& vertices) {
    Stage s{.id = "clipped", .title = "Clipped polygons", .text = "Triangles that pass the near or the far plane, or leave the guard band (a million pixels round the picture), are cut to polygons of up to 9 "
            "corners before the division (Sutherland and Hodgman). The sides of the picture only reject what is wholly outside: rasterization leaves out the rest for less than cutting costs."};
    static constexpr std::pair<unsigned, const char*> planes[] = {{raster::clip_near, "near"}, {raster::clip_far, "far"}, {raster::clip_guard_left, "guard band left"},
        {raster::clip_guard_right, "guard band right"}, {raster::clip_guard_bottom, "guard band bottom"}, {raster::clip_guard_top, "guard band top"},
        {raster::clip_left, "left"}, {raster::clip_right, "right"}, {raster::clip_bottom, "bottom"}, {raster::clip_top, "top"}};
    const raster::View& view = of.engine.view();
    const raster::ClipVolume volume(view);
    std::array<std::uint64_t, std::size(planes)> passing{}, outside{};
    std::uint64_t clipped = 0;
    Canvas canvas(of.engine.settings().width, of.engine.settings().height, ground);
    for (std::size_t d = 0; d < vertices.draws().size(); ++d) {
        if (!vertices.is_transformed(d)) continue;
        const Mesh& mesh = vertices.mesh(d);
        for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
            const std::uint32_t* index = mesh.indices.data() + 3 * t;
            const ClipVertex v[3] = {vertices.clip(d, index[0]), vertices.clip(d, index[1]), vertices.clip(d, index[2])};
            const unsigned codes[3] = {outcode(v[0], volume), outcode(v[1], volume), outcode(v[2], volume)};
            const unsigned any = codes[0] | codes[1] | codes[2], all = codes[0] & codes[1] & codes[2];
            for (std::size_t p = 0; p < std::size(planes); ++p) {
                outside[p] += (all & planes[p].first) != 0;
                passing[p] += all == 0 && (any & planes[p].first) != 0;
            }
            if (all != 0 || any == ~0u || (any & raster::cutting_planes) == 0) continue;
            ++clipped;
            ClipVertex polygon[raster::max_clipped_vertices];
            const std::size_t corners = clip_triangle(v, any & raster::cutting_planes, volume, polygon);
            for (std::size_t k = 0; k < corners; ++k) canvas.line(view.screen(polygon[k]), view.screen(polygon[(k + 1) % corners]), red);
            if (s.rows.size() >= listed_polygons) continue;
            Json corner_list = Json::array();
            for (std::size_t k = 0; k < corners; ++k) corner_list.push_back({cell(double(polygon[k].x)), cell(double(polygon[k].y)), cell(double(polygon[k].w))});
            s.rows.push_back({of.engine.list().scene.nodes[vertices.draws()[d].node].name, t, corners, corner_list});
        }
    }
    s.numbers["triangles clipped"] = clipped;
    for (std::size_t p = 0; p < std::size(planes); ++p) {
        s.numbers[std::string("wholly outside of: ") + planes[p].second] = outside[p];
        s.numbers[std::string("passing, not wholly outside: ") + planes[p].second] = passing[p];
    }
    s.columns = {"object", "triangle", "corners", "x, y, w of each"};
    s.rows_note = clipped == 0 ? "Nothing had to be clipped." : "The first " + std::to_string(s.rows.size()) + " of " + std::to_string(clipped) + " clipped triangles";
    s.pictures.push_back({"clipped", clipped == 0 ? "No polygon was clipped." : "The polygons that are left, on the screen.", std::move(canvas)});
    return s;
}

Stage device_stage(const Sources& of, const Vertices& vertices) {
    Stage s{.id = "device", .title = "Normalized device coordinates", .text = "After the division by w: the picture is the square from -1 to 1. This is the central projection. The depth that is compared is near / distance "
            "in perspective: 1 at the near plane, 0 at infinity, straight on the screen, so that it can be stepped from pixel to pixel. Vertices behind the near plane have no place here (NaN is listed)."};
    const WirePlot plot(of, vertices, true);
    const double near = of.engine.view().near;
    const Place place = [&](std::size_t d, std::uint32_t v) {
        if (double(vertices.clip(d, v).distance) < near) return dvec2{std::nan(""), 0};
        const dvec3 p = vertices.device(d, v);
        return dvec2{p.x, p.y};
    };
    Canvas canvas = plot.canvas();
    const Fit f = fit({-1.2, -1.2}, {1.2, 1.2}, canvas.width(), canvas.height());
    plot.draw(canvas, f, place);
    const dvec2 corners[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    for (std::size_t k = 0; k < 4; ++k) canvas.line(f(corners[k]), f(corners[(k + 1) % 4]), frame);
    s.pictures.push_back({"device", "x to the right, y up; in orange the square that becomes the picture." + plot.note(), std::move(canvas)});
    add_table(s, of, vertices, true, {"x", "y", "depth key"}, [&](std::size_t d, std::uint32_t v) {
        const double nan = std::nan("");
        if (double(vertices.clip(d, v).distance) < near) return std::vector<double>{nan, nan, nan};
        const dvec3 p = vertices.device(d, v);
        return std::vector<double>{p.x, p.y, p.z};
    });
    return s;
}

Stage screen_stage(const Sources& of, const Vertices& vertices) {
    Stage s{.id = "screen", .title = "Screen", .text = "Stretched to pixels: 0, 0 is the outer corner of the top left one, y goes down. Corners are rounded to 1/256 pixel; from here on coverage is decided in whole numbers, "
            "so that triangles which share an edge leave no gap and cover nothing twice."};
    const WirePlot plot(of, vertices, true);
    const raster::View& view = of.engine.view();
    const Place place = [&](std::size_t d, std::uint32_t v) {
        const ClipVertex c = vertices.clip(d, v);
        return double(c.distance) < view.near ? dvec2{std::nan(""), 0} : view.screen(c);
    };
    Canvas canvas = plot.canvas();
    Fit identity;  // y is down already
    const Place flipped = [&](std::size_t d, std::uint32_t v) {
        const dvec2 p = place(d, v);
        return dvec2{p.x, -p.y};
    };
    plot.draw(canvas, identity, flipped);
    s.pictures.push_back({"screen", "The triangles as they lie on the picture." + plot.note(), std::move(canvas)});
    add_table(s, of, vertices, true, {"x [px]", "y [px]", "x [1/256 px]", "y [1/256 px]"}, [&](std::size_t d, std::uint32_t v) {
        const dvec2 p = place(d, v);
        if (std::isnan(p.x)) return std::vector<double>(4, p.x);
        const raster::ScreenPoint snapped = snap_to_screen(view, vertices.clip(d, v));
        return std::vector<double>{p.x, p.y, double(snapped.x), double(snapped.y)};
    });
    return s;
}

}  // namespace

std::vector<Stage> vertex_stages(const Sources& of) {
    const Vertices vertices(of);
    std::vector<Stage> stages;
    stages.push_back(model_stage(of, vertices));
    stages.push_back(world_stage(of, vertices));
    stages.push_back(camera_stage(of, vertices));
    stages.push_back(clip_stage(of, vertices));
    stages.push_back(clipping_stage(of, vertices));
    stages.push_back(device_stage(of, vertices));
    stages.push_back(screen_stage(of, vertices));
    return stages;
}

}  // namespace rakelight::stages
