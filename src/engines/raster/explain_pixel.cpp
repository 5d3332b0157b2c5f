// SPDX-License-Identifier: Apache-2.0
// One pixel with all its numbers: which triangles cover it, what became of each, and how those that show were shaded.
#include <algorithm>
#include <cmath>
#include <limits>

#include "engines/raster/coverage.h"
#include "engines/raster/inspection.h"
#include "engines/raster/tile.h"
#include "engines/raster/visibility_methods.h"
#include "math/flush_denormals.h"

namespace rakelight::raster {
namespace {

/// The stages of one pixel: a window of that size lies in one tile.
class PixelStages {
public:
    PixelStages(const Inspection& of, int x, int y, Context& context)
        : of_(of), open_(of, {x, y, 1, 1}, true, context), drawn_(of, {x, y, 1, 1}, false, context), x_(x), y_(y) {}

    PixelExplanation run() {
        const FlushDenormals guard;
        out_.x = x_;
        out_.y = y_;
        out_.background = out_.sum = of_.settings().background;
        find_covering();
        decide();
        for (const std::size_t i : order_) shade(i);
        draw();
        sort_by_depth();
        out_.has_marks = !drawn_.marks.is_empty() && !drawn_.marks.items.empty();
        return std::move(out_);
    }

private:
    TileJob job_of(const Inspection::Geometry& g) const {
        return {g.front, g.binned, g.grid, of_.lights(), *scalar::kernels(), true, g.points, false, true};
    }
    const MaterialView& material_of(const CoveringTriangle& t) const {
        return of_.list().materials[of_.list().draws[t.draw].material].view;
    }

    void find_covering() {
        const Binned& binned = open_.binned;
        const int ox = open_.grid.origin_x(0), oy = open_.grid.origin_y(0);
        for (const ScreenTriangle* const item : binned.items) {
            const ScreenTriangle& s = binned.at(item);
            cover(s, {x_, y_, 1, 1}, ox, oy, [&](int, int, float depth) { add(s, depth); });
        }
    }

    void add(const ScreenTriangle& s, float depth) {
        const Mesh& mesh = of_.list().scene.meshes[of_.list().draws[s.draw].mesh];
        const ClipVolume volume(of_.view());
        CoveringTriangle t;
        t.draw = s.draw;
        t.triangle = s.triangle;
        t.is_back = s.is_back;
        t.depth_key = depth;
        t.distance = of_.distance_of(depth);
        for (std::size_t k = 0; k < 3; ++k) {
            t.vertex[k] = mesh.indices[3 * std::size_t(s.triangle) + k];
            t.is_clipped |= (outcode(open_.front.clip[s.draw][t.vertex[k]], volume) & cutting_planes) != 0;
        }
        const MaterialView& m = material_of(t);
        screen_.push_back(&s);
        seen_order_.push_back(SurfaceOrder(open_.front, s).at(x_, y_, depth));
        if (m.blend || m.alpha_cutoff >= 0) t.alpha = trace(s, nullptr).alpha;
        out_.triangles.push_back(t);
    }

    /// Shades the pixel of a triangle with the recorder.
    PixelTrace trace(const ScreenTriangle& s, ShadedLayer* layer) {
        const TileJob job = job_of(open_);
        const int ox = open_.grid.origin_x(0), oy = open_.grid.origin_y(0);
        const ScreenTriangle* const only = &s;
        make_records(job, s.draw, {&only, 1}, ox, oy, scratch_);
        scratch_.pixel[0] = (y_ - oy) * tile_size + x_ - ox;
        scratch_.triangle[0] = 0;
        const ShadeJob batch = make_job(job, s.draw, ox, oy, 1, scratch_);
        std::vector<TracedLight> lights(of_.lights().size());
        PixelTrace pixel;
        trace::trace_pixel(&batch, &pixel, lights.data());
        if (!layer) return pixel;
        layer->is_unlit = batch.unlit != 0;
        layer->reflection_model = batch.reflection_model;
        layer->reflection_form = batch.reflection_form;
        if (pixel.is_lit_at_corners)
            layer->corners = trace_corners(open_.front, open_.points, s, batch);
        else if (!layer->is_unlit)
            layer->lights = std::move(lights);
        return pixel;
    }

    /// Who wins: the rules of find_visible() and blend_transparent().
    void decide() {
        const Visibility method = of_.settings().visibility;
        double standing = std::numeric_limits<double>::infinity();
        std::size_t visible = out_.triangles.size();
        for (std::size_t i = 0; i < out_.triangles.size(); ++i) {
            CoveringTriangle& t = out_.triangles[i];
            const MaterialView& m = material_of(t);
            if (of_.is_culled(t.draw, t.is_back))
                t.fate = t.is_back ? Fate::culled_back : Fate::culled_front;
            else if (!m.blend && m.alpha_cutoff >= 0 && !(t.alpha >= m.alpha_cutoff))
                t.fate = Fate::masked_out;
            else if (!m.blend && is_seen_before(method, seen_order_[i], standing, true)) {
                standing = seen_order_[i];
                visible = i;
            }
        }
        if (visible < out_.triangles.size()) {
            out_.triangles[visible].fate = Fate::visible;
            order_.push_back(visible);
        }
        std::vector<std::size_t> blended;
        for (std::size_t i = 0; i < out_.triangles.size(); ++i) {
            CoveringTriangle& t = out_.triangles[i];
            const bool is_later = visible == out_.triangles.size() || i > visible;
            if (t.fate != Fate::hidden || !material_of(t).blend ||
                !is_seen_before(method, seen_order_[i], standing, is_later))
                continue;
            t.fate = Fate::blended;
            blended.push_back(i);
        }
        const auto place = [this](std::size_t i) { return blending_place(open_.front, *screen_[i]); };
        std::stable_sort(blended.begin(), blended.end(),
                         [&](std::size_t a, std::size_t b) { return place(a) < place(b); });
        order_.insert(order_.end(), blended.begin(), blended.end());
    }

    /// Adds a layer over what is there: the formulas of store_batch().
    void shade(std::size_t i) {
        ShadedLayer layer;
        layer.triangle = i;
        layer.is_blended = out_.triangles[i].fate == Fate::blended;
        layer.trace = trace(*screen_[i], &layer);
        layer.before = out_.sum;
        const auto finite = [](float v) { return std::isfinite(v) ? v : 0.0f; };
        const float opacity = layer.is_blended ? std::clamp(finite(layer.trace.alpha), 0.0f, 1.0f) : 1.0f;
        const float(&rgb)[3] = layer.trace.color;
        const vec4 c = {finite(rgb[0]), finite(rgb[1]), finite(rgb[2]), opacity}, to = layer.before;
        const float under = to.w * (1 - c.w), alpha = c.w + under;
        if (!layer.is_blended)
            out_.sum = c;
        else if (alpha > 0)
            out_.sum = {(c.x * c.w + to.x * under) / alpha, (c.y * c.w + to.y * under) / alpha, (c.z * c.w + to.z * under) / alpha, alpha};
        layer.after = out_.sum;
        out_.layers.push_back(std::move(layer));
    }

    /// The pixel by the engine's own stages.
    void draw() {
        const TileJob job = job_of(drawn_);
        find_visible(job, 0, scratch_);
        if (shade_opaque(job, 0, scratch_)) blend_transparent(job, 0, scratch_);
        out_.color = scratch_.color[std::size_t((y_ - drawn_.grid.origin_y(0)) * tile_size + x_ - drawn_.grid.origin_x(0))];
    }

    void sort_by_depth() {
        std::vector<std::size_t> order(out_.triangles.size()), place(order.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
        std::stable_sort(order.begin(), order.end(),
                         [this](std::size_t a, std::size_t b) { return out_.triangles[a].depth_key > out_.triangles[b].depth_key; });
        std::vector<CoveringTriangle> sorted;
        for (const std::size_t i : order) {
            place[i] = sorted.size();
            sorted.push_back(out_.triangles[i]);
        }
        out_.triangles = std::move(sorted);
        for (ShadedLayer& layer : out_.layers) layer.triangle = place[layer.triangle];
    }

    const Inspection& of_;
    Inspection::Geometry open_, drawn_;
    int x_, y_;
    TileScratch scratch_;
    std::vector<const ScreenTriangle*> screen_;  ///< of out_.triangles while in the order of the scene
    std::vector<double> seen_order_;             ///< the same: what the method of visibility compares
    std::vector<std::size_t> order_;             ///< of the layers
    PixelExplanation out_;
};

}  // namespace

std::vector<TracedCorner> trace_corners(const FrontEnd& front, const LightPoints& points, const ScreenTriangle& s,
                                        const ShadeJob& job) {
    std::vector<TracedCorner> out;
    for (const LitCorner& corner : lit_corners(front, points, s)) {
        TracedCorner traced{corner, std::vector<TracedLight>(std::size_t(job.light_count))};
        float received[3][3];
        trace::trace_point(&job, mean_roughness(*job.material), corner.position, corner.normal, received,
                           traced.lights.data());
        out.push_back(std::move(traced));
    }
    return out;
}

PixelExplanation Inspection::explain(int x, int y, Context& context) const {
    if (x < 0 || y < 0 || x >= settings_.width || y >= settings_.height)
        throw Error(ErrorCode::usage, "pixel " + std::to_string(x) + "," + std::to_string(y) + " is not in the picture of " +
                                          std::to_string(settings_.width) + " x " + std::to_string(settings_.height) + " pixels",
                    {}, "0,0 is the top left one");
    return PixelStages(*this, x, y, context).run();
}

}  // namespace rakelight::raster
