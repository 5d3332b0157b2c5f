// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/inspect_pixels.h"

#include <algorithm>
#include <limits>

#include "engines/raster/coverage.h"
#include "engines/raster/tile.h"
#include "math/flush_denormals.h"

namespace rakelight::raster {
namespace {

vec3 rgb(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

void allocate(PixelStageData& d, std::size_t pixels, std::size_t lights) {
    d.overdraw.assign(pixels, 0);
    d.culled.assign(pixels, 0);
    d.distance.assign(pixels, std::numeric_limits<float>::infinity());
    d.draw.assign(pixels, none);
    d.triangle.assign(pixels, none);
    d.normal.assign(pixels, {});
    d.emission.assign(pixels, {});
    d.color.assign(pixels, {});
    d.lights.resize(lights);
    for (TermPictures& t : d.lights) {
        t.ambient.assign(pixels, {});
        t.diffuse.assign(pixels, {});
        t.specular.assign(pixels, {});
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

/// The stages of one tile of both geometries.
class TileStages {
public:
    TileStages(const Inspection& of, const Inspection::Geometry& open, const Inspection::Geometry& drawn,
               std::size_t tile, PixelStageData& out)
        : of_(of),
          open_(open),
          drawn_(drawn),
          tile_(tile),
          job_{drawn.front, drawn.binned, drawn.grid, of.lights(), *scalar::kernels(), true, drawn.points, false, true, &drawn.marks},
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
        s_.on_layer = [this](std::size_t pixels) { note_layer(pixels); };
        if (blends) blend_transparent(job_, tile_, s_);
        copy_color(out_.color);
        for (std::size_t k = 0; k < out_.layers.size(); ++k) fill_up(k);
        trace_all();
    }

private:
    std::size_t at(int x, int y) const { return std::size_t(y + oy_) * std::size_t(of_.settings().width) + std::size_t(x + ox_); }

    std::size_t at(std::size_t pixel) const { return at(int(pixel) % tile_size, int(pixel) / tile_size); }

    template <class Visit>
    void for_each_pixel(const Visit& visit) const {  // of the tile's area, by its number in the tile
        for (int y = area_.y - oy_; y < area_.y - oy_ + area_.height; ++y)
            for (int x = area_.x - ox_; x < area_.x - ox_ + area_.width; ++x) visit(std::size_t(y * tile_size + x));
    }

    void copy_color(std::vector<vec4>& to) const {
        for_each_pixel([&](std::size_t p) { to[at(p)] = s_.color[p]; });
    }

    /// A blended triangle was laid over `count` pixels.
    void note_layer(std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            const auto pixel = std::size_t(s_.pixel[i]), p = at(pixel);
            std::uint8_t& n = out_.layer_count[p];
            if (n < out_.layers.size()) {
                out_.layers[n].color[p] = s_.color[pixel];
                out_.layers[n].alpha[p] = s_.alpha[i] >= 0 ? std::min(s_.alpha[i], 1.0f) : 0;
            }
            n = std::uint8_t(n + (n < 255));
        }
    }

    /// Pixels with fewer layers keep what they have.
    void fill_up(std::size_t layer) {
        for_each_pixel([&](std::size_t pixel) {
            const std::size_t p = at(pixel);
            if (out_.layer_count[p] <= layer) out_.layers[layer].color[p] = out_.color[p];
        });
    }

    template <class Visit>
    void for_each_triangle(const Binned& binned, const Visit& visit) const {
        for (std::uint32_t i = binned.offsets[tile_]; i < binned.offsets[tile_ + 1]; ++i) visit(binned.at(binned.items[i]));
    }

    void count() {
        for_each_triangle(drawn_.binned, [&](const ScreenTriangle& s) {
            cover(s, area_, ox_, oy_, [&](int x, int y, float) {
                std::uint16_t& n = out_.overdraw[at(x, y)];
                n = std::uint16_t(n + (n < 65535));
            });
        });
        for_each_triangle(open_.binned, [&](const ScreenTriangle& s) {
            if (!of_.is_culled(s.draw, s.is_back)) return;
            cover(s, area_, ox_, oy_, [&](int x, int y, float) { out_.culled[at(x, y)] |= s.is_back ? 1 : 2; });
        });
    }

    void note_visible() {
        const std::uint32_t first = drawn_.binned.offsets[tile_];
        for (int y = area_.y - oy_; y < area_.y - oy_ + area_.height; ++y)
            for (int x = area_.x - ox_; x < area_.x - ox_ + area_.width; ++x) {
                const auto p = std::size_t(y * tile_size + x);
                if (s_.visible[p] < 0) continue;
                const ScreenTriangle& t = drawn_.binned.at(drawn_.binned.items[first + std::uint32_t(s_.visible[p])]);
                visible_.push_back({x, y, &t});
                out_.distance[at(x, y)] = of_.distance_of(s_.depth[p]);
                out_.draw[at(x, y)] = t.draw;
                out_.triangle[at(x, y)] = t.triangle;
            }
    }

    /// The shading of each visible surface with the recorder.
    void trace_all() {
        const ScreenTriangle* last = nullptr;
        std::vector<TracedCorner> corners;
        for (const Visible& v : visible_) {
            const bool is_new = v.triangle != last;
            last = v.triangle;
            if (is_new) make_records(job_, last->draw, {&last, 1}, ox_, oy_, s_);
            s_.pixel[0] = v.y * tile_size + v.x;
            s_.triangle[0] = 0;
            const ShadeJob batch = make_job(job_, last->draw, ox_, oy_, 1, s_);
            PixelTrace pixel;
            trace::trace_pixel(&batch, &pixel, lights_.data());
            const std::size_t p = at(v.x, v.y);
            out_.normal[p] = rgb(pixel.normal);
            out_.emission[p] = rgb(pixel.emission);
            if (batch.unlit) continue;
            if (is_new && pixel.is_lit_at_corners) corners = trace_corners(drawn_.front, drawn_.points, *last, batch);
            if (pixel.is_lit_at_corners) interpolate(corners, pixel);
            for (std::size_t i = 0; i < out_.lights.size(); ++i) {
                out_.lights[i].ambient[p] = rgb(lights_[i].ambient);
                out_.lights[i].diffuse[p] = rgb(lights_[i].diffuse);
                out_.lights[i].specular[p] = rgb(lights_[i].specular);
            }
        }
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
    const Inspection& of_;
    const Inspection::Geometry &open_, &drawn_;
    std::size_t tile_;
    TileJob job_;
    Window area_;
    int ox_, oy_;
    TileScratch s_;
    std::vector<Visible> visible_;
    std::vector<TracedLight> lights_;
    PixelStageData& out_;
};

}  // namespace

PixelStageData inspect_pixels(const Inspection& of, const Inspection::Geometry& open, const Inspection::Geometry& drawn,
                              std::size_t max_lights, Context& context) {
    PixelStageData out;
    const std::size_t pixels = std::size_t(of.settings().width) * std::size_t(of.settings().height);
    allocate(out, pixels, std::min(max_lights, of.lights().size()));
    if (std::any_of(of.list().materials.begin(), of.list().materials.end(),
                    [](const DrawMaterial& m) { return m.view.blend != 0; }))
        allocate_layers(out, pixels);
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
