// SPDX-License-Identifier: Apache-2.0
// One pixel with all its numbers: which triangles cover it, what became of each, and how those that show were shaded.
#include <algorithm>
#include <cmath>
#include <limits>

#include "cpu_shading/make_material_job.h"
#include "engines/empty_pixel.h"
#include "engines/raster/blend.h"
#include "engines/raster/inspect/depth_plane.h"
#include "engines/raster/inspect/explained_triangles.h"
#include "engines/raster/inspect/kernels/trace_kernel.h"
#include "engines/raster/inspect/open_scene.h"
#include "engines/raster/marks/tile_marks.h"
#include "engines/raster/material_jobs.h"
#include "engines/raster/multisample.h"
#include "engines/raster/occlusion/occlusion.h"
#include "engines/raster/shade/blend_tile.h"
#include "engines/raster/shade/layer_order.h"
#include "engines/raster/shade/shade_tile.h"
#include "engines/raster/shade/sky.h"
#include "engines/raster/tile.h"
#include "engines/raster/visibility/coverage.h"
#include "engines/raster/visibility/visibility_methods.h"
#include "math/flush_denormals.h"
#include "math/isa.h"
#include "shading/choices.h"

namespace rakelight::raster {
namespace {

/// The stages of one pixel: a window of that size lies in one tile.
class PixelStages {
public:
    PixelStages(const OpenScene& of, int x, int y, Context& context)
        : of_(of),
          open_(of, {x, y, 1, 1}, true, context),
          drawn_(of, {x, y, 1, 1}, false, context),
          x_(x),
          y_(y),
          ox_(open_.grid.origin_x(0)),
          oy_(open_.grid.origin_y(0)) {}

    PixelExplanation run() {
        const FlushDenormals guard;
        if (of_.occlusion()) of_.occlusion()->find(job_of(drawn_), 0, scratch_);
        out_.x = x_;
        out_.y = y_;
        out_.background = background();
        for (const SamplePosition at : sample_positions(of_.settings().samples))
            out_.samples.push_back({at, no_triangle, out_.background});
        find_covering();
        find_visible_triangles();
        find_blended();
        for (const std::size_t i : order_) shade(i);
        lay();
        out_.sum = resolved();
        draw();
        summarize(out_, of_);
        sort_by_depth(out_);
        out_.has_marks = !drawn_.marks.is_empty() && !drawn_.marks.items.empty();
        if (out_.has_marks) find_mark();
        return std::move(out_);
    }

private:
    TileJob job_of(const OpenGeometry& g) const {
        return {.front = g.front,
                .binned = g.binned,
                .grid = g.grid,
                .lights = of_.lights(),
                .kernels = *RL_COMMON_ISA::kernels(),
                .has_blended = true,
                .points = g.points,
                .whole_records = true,
                .occlusion = of_.occlusion()};
    }
    vec4 background() {
        if (!has_sky(of_.list())) return empty_pixel(of_.settings());
        fill_sky(job_of(open_), 0, scratch_.color, scratch_);
        return scratch_.color[std::size_t((y_ - oy_) * tile_size + x_ - ox_)];
    }
    const MaterialView& material_of(const CoveringTriangle& t) const { return of_.list().view(t.draw); }
    vec2 place_of(int sample) const {
        const SamplePosition at = out_.samples[std::size_t(sample)].at;
        return {float(at.x) / 16, float(at.y) / 16};
    }

    void find_covering() {
        for (const ScreenTriangle* const item : open_.binned.items) {
            const ScreenTriangle& s = *item;
            std::vector<CoveredSample> covered;
            for (std::size_t k = 0; k < out_.samples.size(); ++k)
                cover(seen_from(out_.samples[k].at, s), {x_, y_, 1, 1}, ox_, oy_, [&](int, int, float depth) {
                    covered.push_back({int(k), depth});
                });
            if (!covered.empty()) add(s, std::move(covered));
        }
    }

    void add(const ScreenTriangle& s, std::vector<CoveredSample> covered) {
        const Mesh& mesh = of_.list().scene.meshes[of_.list().draws[s.draw].mesh];
        const ClipVolume volume(of_.view());
        CoveringTriangle t;
        t.draw = s.draw;
        t.triangle = s.triangle;
        t.is_back = s.is_back;
        for (std::size_t k = 0; k < 3; ++k) {
            t.vertex[k] = mesh.indices[3 * std::size_t(s.triangle) + k];
            t.is_clipped |= (outcode(open_.front.clip[s.draw][t.vertex[k]], volume) & cutting_planes) != 0;
        }
        const MaterialView& m = material_of(t);
        const SurfaceOrder order(open_.front, s);
        std::vector<double>& seen = seen_order_.emplace_back();
        for (CoveredSample& c : covered) {
            seen.push_back(order.at(x_, y_, c.depth_key));
            if (m.blend || mask_cutoff(open_.front, s.draw) >= 0) c.alpha = trace(s, place_of(c.sample), nullptr).alpha;
        }
        const auto nearest =
            std::max_element(covered.begin(), covered.end(),
                             [](const CoveredSample& a, const CoveredSample& b) { return a.depth_key < b.depth_key; });
        t.plane = depth_plane(seen_from(out_.samples[std::size_t(nearest->sample)].at, s), x_, y_, ox_, oy_);
        t.samples = std::move(covered);
        screen_.push_back(&s);
        out_.triangles.push_back(std::move(t));
    }

    /// As shading has it: of what is opaque.
    void give_openness(std::uint32_t draw, ShadeJob& batch) {
        if (!of_.occlusion() || of_.list().view(draw).blend) return;
        if (out_.samples.size() > 1)
            of_.occlusion()->give_to_fragments(batch, ox_, oy_, scratch_);
        else
            of_.occlusion()->give(batch, scratch_);
    }

    /// Shades the pixel of a triangle with the recorder.
    /// @param place  [px] where, from the pixel's center
    PixelTrace trace(const ScreenTriangle& s, vec2 place, ShadedLayer* layer) {
        const TileJob job = job_of(open_);
        const ScreenTriangle* const only = &s;
        make_records(job, s.draw, {&only, 1}, ox_, oy_, scratch_);
        scratch_.pixel[0] = (y_ - oy_) * tile_size + x_ - ox_;
        scratch_.batch_triangle[0] = 0;
        scratch_.offset_x[0] = place.x;
        scratch_.offset_y[0] = place.y;
        ShadeJob batch = make_job(job, s.draw, ox_, oy_, 1, scratch_);
        use_offsets(batch, scratch_);
        give_openness(s.draw, batch);
        std::vector<TracedLight> lights(of_.lights().size());
        PixelTrace pixel;
        std::vector<TracedParts> parts(layer ? lights.size() + 1 : 0);
        if (layer) layer->texels.resize(texture_role_count);
        trace::trace_pixel(&batch, &pixel, lights.data(), layer ? layer->texels.data() : nullptr,
                           layer ? parts.data() : nullptr);
        if (!layer) return pixel;
        layer->is_unlit = batch.unlit != 0;
        layer->reflection_model = batch.reflection_model;
        layer->reflection_form = batch.reflection_form;
        if (batch.reflection_model == shading::reflects_ward)
            layer->ward_form = shading::ward_form_of(
                of_.list().scene_material(of_.list().material(of_.list().draws[s.draw])), of_.settings().ward_form);
        if (pixel.is_lit_at_corners)
            layer->corners = trace_corners(open_.front, open_.points, s, batch);
        else if (!layer->is_unlit)
            layer->lights = std::move(lights);
        layer->parts = std::move(parts);
        return pixel;
    }

    /// Who wins at each sample: the rule of find_visible().
    void find_visible_triangles() {
        std::vector<double> standing(out_.samples.size(), std::numeric_limits<double>::infinity());
        for (std::size_t i = 0; i < out_.triangles.size(); ++i) {
            CoveringTriangle& t = out_.triangles[i];
            const MaterialView& m = material_of(t);
            const float cutoff = mask_cutoff(open_.front, t.draw);
            for (std::size_t k = 0; k < t.samples.size(); ++k) {
                CoveredSample& c = t.samples[k];
                const auto sample = std::size_t(c.sample);
                if (of_.is_culled(t.draw, t.is_back)) {
                    c.fate = t.is_back ? Fate::culled_back : Fate::culled_front;
                } else if (!m.blend && cutoff >= 0 && !(c.alpha >= cutoff)) {
                    c.fate = Fate::masked_out;
                } else if (!m.blend &&
                           is_seen_before(of_.settings().visibility, seen_order_[i][k], standing[sample], true)) {
                    standing[sample] = seen_order_[i][k];
                    out_.samples[sample].triangle = i;
                }
            }
        }
        for (std::size_t k = 0; k < out_.samples.size(); ++k) {
            const std::size_t i = out_.samples[k].triangle;
            if (i == no_triangle) continue;
            covered_sample(i, k)->fate = Fate::visible;
            if (std::find(order_.begin(), order_.end(), i) == order_.end()) order_.push_back(i);
        }
    }

    /// Null: the triangle does not cover the sample.
    CoveredSample* covered_sample(std::size_t triangle, std::size_t sample) {
        for (CoveredSample& c : out_.triangles[triangle].samples)
            if (c.sample == int(sample)) return &c;
        return nullptr;
    }

    /// What is laid over which samples: the rules of blend_transparent().
    void find_blended() {
        std::vector<std::size_t> blended;
        for (std::size_t i = 0; i < out_.triangles.size(); ++i) {
            CoveringTriangle& t = out_.triangles[i];
            bool is_laid = false;
            for (std::size_t k = 0; k < t.samples.size() && material_of(t).blend; ++k) {
                CoveredSample& c = t.samples[k];
                if (c.fate != Fate::hidden || !is_before_visible(i, c, seen_order_[i][k])) continue;
                c.fate = Fate::blended;
                is_laid = true;
            }
            if (is_laid) blended.push_back(i);
        }
        const auto place = [this](std::size_t i) { return blending_place(open_.front, *screen_[i]); };
        std::stable_sort(blended.begin(), blended.end(),
                         [&](std::size_t a, std::size_t b) { return place(a) < place(b); });
        for (std::size_t k = 0; k < out_.samples.size(); ++k) sort_layers(k, blended);
        // Layers are told in the order of the first sample that shows them.
        for (const std::vector<std::size_t>& layers : layers_of_)
            for (const std::size_t i : layers)
                if (std::find(order_.begin(), order_.end(), i) == order_.end()) order_.push_back(i);
    }

    /// Those of a sample, far to near.
    /// @param blended  of the pixel, triangle by triangle
    void sort_layers(std::size_t sample, const std::vector<std::size_t>& blended) {
        std::vector<std::size_t>& layers = layers_of_.emplace_back();
        const auto place = [&](std::size_t i) {
            return LayerPlace{covered_sample(i, sample)->depth_key, std::uint32_t(i)};
        };
        for (const std::size_t i : blended) {
            const CoveredSample* const c = covered_sample(i, sample);
            if (!c || c->fate != Fate::blended) continue;
            layers.push_back(i);
            if (has_depth(of_.settings().visibility)) insert_last_layer(layers.begin(), layers.end(), place);
        }
    }

    bool is_before_visible(std::size_t i, const CoveredSample& c, double order) {
        const std::size_t visible = out_.samples[std::size_t(c.sample)].triangle;
        if (visible == no_triangle) return true;
        double standing = 0;
        const std::vector<CoveredSample>& its = out_.triangles[visible].samples;
        for (std::size_t k = 0; k < its.size(); ++k)
            if (its[k].sample == c.sample) standing = seen_order_[visible][k];
        return is_seen_before(of_.settings().visibility, order, standing, i > visible);
    }

    /// Adds a layer: shaded once for all samples that show it, at the middle of those.
    void shade(std::size_t i) {
        ShadedLayer layer;
        layer.triangle = i;
        std::uint32_t shown = 0;
        for (const CoveredSample& c : out_.triangles[i].samples)
            if (c.fate == Fate::visible || c.fate == Fate::blended) {
                shown |= 1u << c.sample;
                layer.is_blended = c.fate == Fate::blended;
            }
        if (out_.samples.size() > 1) layer.place = middle_of(int(out_.samples.size()), shown);
        layer.trace = trace(*screen_[i], layer.place, &layer);
        const auto finite = [](float v) { return std::isfinite(v) ? v : 0.0f; };
        const float opacity = layer.is_blended ? std::clamp(finite(layer.trace.alpha), 0.0f, 1.0f) : 1.0f;
        const float(&rgb)[3] = layer.trace.color;
        const vec4 color = {finite(rgb[0]), finite(rgb[1]), finite(rgb[2]), opacity};
        for (std::size_t k = 0; k < out_.samples.size(); ++k)
            if (shown >> k & 1u) layer.samples.push_back({int(k), 0, {}, {}});
        colors_.push_back(color);
        out_.layers.push_back(std::move(layer));
    }

    /// Lays all layers of each sample, in its order.
    void lay() {
        for (std::size_t k = 0; k < out_.samples.size(); ++k) {
            int place = 0;
            if (out_.samples[k].triangle != no_triangle) lay(out_.samples[k].triangle, k, place++);
            for (const std::size_t i : layers_of_[k]) lay(i, k, place++);
        }
    }

    void lay(std::size_t triangle, std::size_t sample, int place) {
        const auto number = std::size_t(std::find(order_.begin(), order_.end(), triangle) - order_.begin());
        ShadedLayer& layer = out_.layers[number];
        vec4& to = out_.samples[sample].color;
        for (LaidSample& laid : layer.samples) {
            if (laid.sample != int(sample)) continue;
            laid.place = place;
            laid.before = to;
            if (layer.is_blended)
                lay_over(colors_[number], to);
            else
                to = colors_[number];
            laid.after = to;
        }
    }

    vec4 resolved() const {
        std::vector<vec4> colors;
        for (const SeenSample& s : out_.samples) colors.push_back(s.color);
        return colors.size() == 1 ? colors[0] : mean_of_samples(colors.data(), colors.size());
    }

    /// The pixel by the engine's own stages.
    void draw() {
        const TileJob job = job_of(drawn_);
        if (of_.settings().samples > 1) {
            find_visible_samples(job, 0, scratch_);
            shade_samples(job, 0, scratch_);
            finish_samples(job, 0, scratch_);
        } else {
            find_visible(job, 0, scratch_);
            if (shade_opaque(job, 0, scratch_)) blend_transparent(job, 0, scratch_);
        }
        out_.color = scratch_.color[std::size_t((y_ - oy_) * tile_size + x_ - ox_)];
    }

    void find_mark() {
        TileJob job = job_of(drawn_);
        job.marks = &drawn_.marks;
        find_visible(job, 0, scratch_);
        const Draw* const draw = TileMarks(job, 0, scratch_).draw_at(std::size_t((y_ - oy_) * tile_size + x_ - ox_));
        if (!draw) return;
        const DrawList& list = of_.list();
        out_.mark = {draw->node, draw->mesh, list.materials[draw->material].scene_material,
                     list.scene.meshes[draw->mesh].topology == Topology::points};
    }

    const OpenScene& of_;
    OpenGeometry open_, drawn_;
    int x_, y_, ox_, oy_;
    TileScratch scratch_;
    std::vector<const ScreenTriangle*> screen_;        ///< of out_.triangles while in the order of the scene
    std::vector<std::vector<double>> seen_order_;      ///< [their samples]: what the method of visibility compares
    std::vector<std::size_t> order_;                   ///< of the layers
    std::vector<vec4> colors_;                         ///< [layers] with their opacity
    std::vector<std::vector<std::size_t>> layers_of_;  ///< [samples] the blended ones, far to near
    PixelExplanation out_;
};

}  // namespace

std::vector<TracedCorner> trace_corners(const FrontEnd& front, const LightPoints& points, const ScreenTriangle& s,
                                        const ShadeJob& job) {
    std::vector<TracedCorner> out;
    for (const LitCorner& corner : lit_corners(front, points, s)) {
        const auto lights = std::size_t(job.light_count);
        TracedCorner traced{corner, std::vector<TracedLight>(lights), std::vector<TracedParts>(lights)};
        float received[3][3];
        trace::trace_point(&job, cpu_shading::mean_roughness(*job.material), corner.position, corner.normal, received,
                           traced.lights.data(), traced.parts.data());
        out.push_back(std::move(traced));
    }
    return out;
}

PixelExplanation explain_pixel(const OpenScene& of, int x, int y, Context& context) {
    return PixelStages(of, x, y, context).run();
}

}  // namespace rakelight::raster
