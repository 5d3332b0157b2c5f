// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/inspect/inspect_pixels.h"

#include <algorithm>
#include <limits>

#include "engines/empty_pixel.h"
#include "engines/raster/inspect/depth_plane.h"
#include "engines/raster/inspect/kernels/trace_kernel.h"
#include "engines/raster/inspect/note_samples.h"
#include "engines/raster/inspect/open_scene.h"
#include "engines/raster/occlusion/occlusion.h"
#include "engines/raster/shade/blend_tile.h"
#include "engines/raster/shade/channels_tile.h"
#include "engines/raster/shade/shade_tile.h"
#include "engines/raster/shade/sky.h"
#include "engines/raster/visibility/coverage.h"
#include "engines/raster/visibility/visibility_methods.h"
#include "math/flush_denormals.h"

namespace rakelight::raster {
namespace {

vec3 rgb(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

void allocate(PixelStageData& d, std::size_t pixels, std::size_t lights) {
    d.overdraw.assign(pixels, 0);
    d.faces.assign(pixels, 0);
    d.distance.assign(pixels, std::numeric_limits<float>::infinity());
    d.depth_key.assign(pixels, -1);
    d.depth_slope.assign(pixels, {});
    d.draw.assign(pixels, no_index);
    d.triangle.assign(pixels, no_index);
    d.normal.assign(pixels, {});
    d.emission.assign(pixels, {});
    d.own_color.assign(pixels, {});
    d.color.assign(pixels, {});
    d.lights.resize(lights);
    for (TermPictures& t : d.lights) {
        t.ambient.assign(pixels, {});
        t.diffuse.assign(pixels, {});
        t.specular.assign(pixels, {});
    }
}

bool any_job(const FrontEnd& front, const auto& holds) {
    return std::any_of(front.jobs.begin(), front.jobs.end(), holds);
}

/// What only some pictures have.
void allocate_effects(PixelStageData& d, std::size_t pixels, const FrontEnd& front, std::size_t all_lights) {
    if (d.lights.size() < all_lights) d.other_lights.assign(pixels, {});
    if (any_job(front, [](const MaterialJob& job) { return job.environment != nullptr; })) {
        d.around_diffuse.assign(pixels, {});
        d.around_specular.assign(pixels, {});
    }
    if (any_job(front, [](const MaterialJob& job) { return job.behind != nullptr; })) d.transmitted.assign(pixels, {});
    if (any_job(front, [](const MaterialJob& job) { return job.fog.kind != 0; })) {
        d.fog.assign(pixels, {});
        d.fog_share.assign(pixels, 1);
    }
    if (any_job(front, [&front](const MaterialJob& job) { return front.shadows || job.relief.self_shadow; }))
        d.seen.assign(d.lights.size(), std::vector<float>(pixels, -1));
    if (any_job(front, [](const MaterialJob& job) { return job.relief.technique >= shading::relief_parallax; })) {
        d.relief_shift.assign(pixels, {});
        d.relief_height.assign(pixels, -1);
    }
}

void allocate_layers(PixelStageData& d, std::size_t pixels) {
    d.opaque.assign(pixels, {});
    d.layer_count.assign(pixels, 0);
    d.layers.resize(most_layers);
    for (BlendedLayer& layer : d.layers) {
        layer.color.assign(pixels, {});
        layer.alpha.assign(pixels, 0);
    }
}

void allocate_samples(PixelStageData& d, std::size_t pixels) {
    d.center_color.assign(pixels, {});
    d.samples_covered.assign(pixels, 0);
    d.visible_triangles.assign(pixels, 0);
    d.sample_spread.assign(pixels, 0);
}

/// The stages of one tile of both geometries.
class TileStages {
public:
    TileStages(const OpenScene& of, const OpenGeometry& open, const OpenGeometry& drawn, std::size_t tile,
               PixelStageData& out)
        : of_(of),
          open_(open),
          drawn_(drawn),
          tile_(tile),
          job_(tile_job(of, drawn)),
          area_(drawn.grid.pixels(tile)),
          ox_(drawn.grid.origin_x(tile)),
          oy_(drawn.grid.origin_y(tile)),
          lights_(of.lights().size()),
          out_(out) {}

    void run() {
        count();
        find_visible(job_, tile_, s_);
        note_visible();
        const bool blends = shade_opaque(job_, tile_, s_);
        if (!out_.opaque.empty()) copy_color(out_.opaque);
        s_.on_layer = [this](std::size_t pixel, std::uint32_t number, float alpha) {
            note_layer(pixel, number, alpha);
        };
        if (blends) blend_transparent(job_, tile_, s_);
        copy_color(out_.center_color.empty() ? out_.color : out_.center_color);
        for (std::size_t k = 0; k < out_.layers.size(); ++k) fill_up(k);
        trace_visible();
        if (!out_.layer_count.empty()) trace_blended();
        if (of_.settings().samples > 1)
            note_samples(job_, tile_, of_.settings(), s_, out_);  // the scratch is its own now
    }

private:
    std::size_t at(int x, int y) const {
        return std::size_t(y + oy_) * std::size_t(of_.settings().width) + std::size_t(x + ox_);
    }

    std::size_t at(std::size_t pixel) const { return at(int(pixel) % tile_size, int(pixel) / tile_size); }

    template <class Visit>
    void for_each_pixel(const Visit& visit) const {  // of the tile's area, by its number in the tile
        for (int y = area_.y - oy_; y < area_.y - oy_ + area_.height; ++y)
            for (int x = area_.x - ox_; x < area_.x - ox_ + area_.width; ++x) visit(std::size_t(y * tile_size + x));
    }

    void copy_color(std::vector<vec4>& to) const {
        for_each_pixel([&](std::size_t p) { to[at(p)] = s_.color[p]; });
    }

    /// A blended surface was laid over a pixel of the tile.
    void note_layer(std::size_t pixel, std::uint32_t number, float alpha) {
        const std::size_t p = at(pixel);
        std::uint8_t& n = out_.layer_count[p];
        if (n < out_.layers.size()) {
            out_.layers[n].color[p] = s_.color[pixel];
            out_.layers[n].alpha[p] = alpha;
        }
        n = std::uint8_t(n + (n < 255));
        laid_.push_back({std::uint32_t(pixel), number});
    }

    /// Pixels with fewer layers keep what they have.
    void fill_up(std::size_t layer) {
        for_each_pixel([&](std::size_t pixel) {
            const std::size_t p = at(pixel);
            if (out_.layer_count[p] <= layer) out_.layers[layer].color[p] = out_.centers()[p];
        });
    }

    template <class Visit>
    void for_each_triangle(const Binned& binned, const Visit& visit) const {
        for (std::uint32_t i = binned.offsets[tile_]; i < binned.offsets[tile_ + 1]; ++i) visit(*binned.items[i]);
    }

    void count() {
        s_.overdraw.assign(tile_pixels, 0);
        count_overdraw(job_, tile_, s_);
        for_each_pixel([&](std::size_t p) {
            out_.overdraw[at(p)] = std::uint16_t(std::min<std::uint32_t>(s_.overdraw[p], 65535));
        });
        for_each_triangle(open_.binned, [&](const ScreenTriangle& s) {
            const std::uint8_t face = !of_.is_culled(s.draw, s.is_back) ? 4 : s.is_back ? 1 : 2;
            cover(s, area_, ox_, oy_, [&](int x, int y, float) { out_.faces[at(x, y)] |= face; });
        });
    }

    void note_visible() {
        const std::uint32_t first = drawn_.binned.offsets[tile_];
        for (int y = area_.y - oy_; y < area_.y - oy_ + area_.height; ++y)
            for (int x = area_.x - ox_; x < area_.x - ox_ + area_.width; ++x) {
                const auto p = std::size_t(y * tile_size + x);
                if (s_.visible[p] < 0) continue;
                const ScreenTriangle& t = *drawn_.binned.items[first + std::uint32_t(s_.visible[p])];
                visible_.push_back({x, y, &t});
                out_.distance[at(x, y)] = of_.distance_of(s_.depth[p]);
                const DepthPlane plane = depth_plane(t, x + ox_, y + oy_, ox_, oy_);
                out_.depth_key[at(x, y)] = s_.depth[p];
                out_.depth_slope[at(x, y)] = {plane.slope_x, plane.slope_y};
                out_.draw[at(x, y)] = t.draw;
                out_.triangle[at(x, y)] = t.triangle;
            }
    }

    /// The shading of each visible surface with the recorder.
    void trace_visible() {
        const ScreenTriangle* last = nullptr;
        for (const Visible& v : visible_) {
            const std::size_t p = at(v.x, v.y);
            const Traced pixel = trace(*v.triangle, v.triangle != last, v.x, v.y);
            last = v.triangle;
            out_.normal[p] = rgb(pixel.trace.normal);
            add_terms(p, pixel, 1, 0);
            note_effects(p, v.triangle->draw, pixel);
        }
    }

    /// Those of the surfaces that are laid over, in their order; weights as blend_transparent() has them.
    void trace_blended() {
        const bool is_sky = has_sky(of_.list());
        if (is_sky) fill_sky(job_, tile_, s_.color, s_);
        for_each_pixel([&](std::size_t pixel) {
            const std::size_t p = at(pixel);
            const vec4 background = is_sky ? s_.color[pixel] : empty_pixel(of_.settings());
            alpha_[pixel] = out_.draw[p] == no_index ? background.w : 1;
            if (out_.draw[p] == no_index && out_.layer_count[p] > 0) out_.own_color[p] = background.xyz();
        });
        const ScreenTriangle* last = nullptr;
        for (const Laid& laid : laid_) {
            const ScreenTriangle& t = *drawn_.binned.items[drawn_.binned.offsets[tile_] + laid.number];
            const int x = int(laid.pixel) % tile_size, y = int(laid.pixel) / tile_size;
            const Traced pixel = trace(t, &t != last, x, y);
            last = &t;
            float& alpha = alpha_[laid.pixel];
            const float own = pixel.trace.alpha >= 0 ? std::min(pixel.trace.alpha, 1.0f) : 0, under = alpha * (1 - own);
            alpha = own + under;
            if (alpha > 0) add_terms(at(x, y), pixel, own / alpha, under / alpha);
        }
    }

    struct Traced {
        PixelTrace trace;
        bool is_lit;
    };

    /// @param is_new  another triangle than that of the call before
    Traced trace(const ScreenTriangle& t, bool is_new, int x, int y) {
        const ScreenTriangle* const only = &t;
        if (is_new) make_records(job_, t.draw, {&only, 1}, ox_, oy_, s_);
        s_.pixel[0] = y * tile_size + x;
        s_.batch_triangle[0] = 0;
        ShadeJob batch = make_job(job_, t.draw, ox_, oy_, 1, s_);
        if (job_.occlusion && !of_.list().view(t.draw).blend) job_.occlusion->give(batch, s_);
        std::fill(lights_.begin(), lights_.end(), TracedLight{});
        PixelTrace pixel;
        trace::trace_pixel(&batch, &pixel, lights_.data(), nullptr, nullptr);
        if (is_new && pixel.is_lit_at_corners) corners_ = trace_corners(drawn_.front, drawn_.points, t, batch);
        if (pixel.is_lit_at_corners) interpolate(corners_, pixel);
        return {pixel, batch.unlit == 0};
    }

    /// Shadows, fog and relief at the visible surface.
    void note_effects(std::size_t p, std::uint32_t draw, const Traced& pixel) {
        const bool is_lit_here = pixel.is_lit && !pixel.trace.is_lit_at_corners;
        for (std::size_t i = 0; i < out_.seen.size(); ++i)
            if (is_lit_here && arrives(i)) out_.seen[i][p] = lights_[i].seen;
        if (!out_.fog.empty()) out_.fog_share[p] = share_through_fog(pixel.trace);
        if (out_.relief_shift.empty() || !pixel.trace.map[role_height].is_used) return;
        const int set = of_.list().view(draw).map[role_height].texcoord_set == 0 ? 0 : 1;
        const float(&flat)[2] = pixel.trace.texcoord[set], (&bumped)[2] = pixel.trace.relief_texcoord[set];
        out_.relief_shift[p] = {bumped[0] - flat[0], bumped[1] - flat[1]};
        out_.relief_height[p] = pixel.trace.relief_height;
    }

    /// Something of the light that may be shadowed: not beyond its range nor beside its cone.
    bool arrives(std::size_t light) const {
        const TracedLight& l = lights_[light];
        float sum = 0;
        for (std::size_t c = 0; c < 3; ++c) sum += l.ambient_color[c] + l.diffuse_color[c] + l.specular_color[c];
        return sum > 0;
    }

    static float share_through_fog(const PixelTrace& t) { return t.has_fog ? t.fog_share : 1; }

    /// What trace() left, laid over the terms that exist. Of a surface in fog, what is seen of it.
    void add_terms(std::size_t p, const Traced& pixel, float own, float under) {
        const PixelTrace& t = pixel.trace;
        const float share = share_through_fog(t);
        const auto lay = [&](vec3& to, vec3 term) { to = term * own + to * under; };
        const auto add = [&](vec3& to, const float(&term)[3]) { lay(to, rgb(term) * share); };
        lay(out_.own_color[p], pixel.is_lit ? vec3{} : vec3{t.base_color[0], t.base_color[1], t.base_color[2]} * share);
        add(out_.emission[p], t.emission);
        for (std::size_t i = 0; i < out_.lights.size(); ++i) {
            add(out_.lights[i].ambient[p], lights_[i].ambient);
            add(out_.lights[i].diffuse[p], lights_[i].diffuse);
            add(out_.lights[i].specular[p], lights_[i].specular);
        }
        if (!out_.other_lights.empty()) lay(out_.other_lights[p], terms_of_other_lights() * share);
        if (!out_.around_diffuse.empty()) {
            add(out_.around_diffuse[p], t.environment[0]);
            add(out_.around_specular[p], t.environment[2]);
        }
        if (!out_.transmitted.empty()) add(out_.transmitted[p], t.transmitted);
        if (!out_.fog.empty()) lay(out_.fog[p], rgb(t.fog_color) * (1 - share));
    }

    vec3 terms_of_other_lights() const {
        vec3 sum{};
        for (std::size_t i = out_.lights.size(); i < lights_.size(); ++i)
            sum += rgb(lights_[i].ambient) + rgb(lights_[i].diffuse) + rgb(lights_[i].specular);
        return sum;
    }

    /// The terms of flat and Gouraud shading: those of the corners, interpolated, times what the pixel reflects.
    void interpolate(const std::vector<TracedCorner>& corners, const PixelTrace& pixel) {
        for (std::size_t i = 0; i < lights_.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c) {
                float ambient = 0, diffuse = 0, specular = 0;
                for (std::size_t k = 0; k < corners.size(); ++k) {
                    const float weight = corners.size() == 1 ? 1 : pixel.barycentric[k];
                    ambient += weight * corners[k].lights[i].ambient[c];
                    diffuse += weight * corners[k].lights[i].diffuse[c];
                    specular += weight * corners[k].lights[i].specular[c];
                }
                lights_[i].ambient[c] = pixel.k_ambient[c] * ambient;
                lights_[i].diffuse[c] = pixel.k_diffuse[c] * diffuse;
                lights_[i].specular[c] = pixel.k_specular[c] * specular;
            }
    }

    struct Visible {
        int x, y;
        const ScreenTriangle* triangle;
    };
    /// A blended surface at a pixel of the tile, of this number in the tile's list.
    struct Laid {
        std::uint32_t pixel, number;
    };
    const OpenScene& of_;
    const OpenGeometry &open_, &drawn_;
    std::size_t tile_;
    TileJob job_;
    Window area_;
    int ox_, oy_;
    TileScratch s_;
    std::vector<Visible> visible_;
    std::vector<Laid> laid_;  ///< in the order in which they were
    std::vector<TracedLight> lights_;
    std::vector<TracedCorner> corners_;                           ///< of the triangle that was traced last
    std::vector<float> alpha_ = std::vector<float>(tile_pixels);  ///< of the picture, while layers are laid
    PixelStageData& out_;
};

}  // namespace

PixelStageData inspect_pixels(const Inspection& inspection, const Inspection::Geometry& with_culled,
                              const Inspection::Geometry& without, std::size_t max_lights, Context& context) {
    const OpenScene& of = inspection.opened();
    const OpenGeometry &open = with_culled.opened(), &drawn = without.opened();
    PixelStageData out;
    const std::size_t pixels = std::size_t(of.settings().width) * std::size_t(of.settings().height);
    allocate(out, pixels, std::min(max_lights, of.lights().size()));
    allocate_effects(out, pixels, drawn.front, of.lights().size());
    if (std::any_of(of.list().materials.begin(), of.list().materials.end(),
                    [](const DrawMaterial& m) { return m.factors.blend != 0; }))
        allocate_layers(out, pixels);
    if (of.settings().samples > 1) allocate_samples(out, pixels);
    context.parallel_for(drawn.grid.count(), [&](std::size_t tile) {
        const FlushDenormals guard;
        if (!context.cancelled()) TileStages(of, open, drawn, tile, out).run();
    });
    context.throw_if_cancelled();
    if (!out.layer_count.empty())
        out.layers.resize(
            std::min<std::size_t>(most_layers, *std::max_element(out.layer_count.begin(), out.layer_count.end())));
    return out;
}

}  // namespace rakelight::raster
