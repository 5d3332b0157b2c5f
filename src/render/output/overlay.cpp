// SPDX-License-Identifier: Apache-2.0
#include "render/output/overlay.h"

#include <rakelight/scene/scene_queries.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "image/draw_line.h"
#include "image/draw_text.h"
#include "image/srgb_encoder.h"
#include "math/color.h"
#include "math/linear.h"
#include "render/output/scalar_bar.h"
#include "scene/drawn_vertices.h"

namespace rakelight {
namespace {

constexpr Code axis_codes[3] = {{235, 64, 52}, {96, 200, 64}, {64, 128, 250}};
constexpr int margin_dots = 4;            ///< of the picture's border, in dots of the font
constexpr int widest_axes_px = 400;       ///< of the tripod
constexpr double light_background = 0.4;  ///< display value of luminance from which on the grid is dark

/// Lays a linear color over a pixel.
void lay(std::byte* pixel, const PixelFormat& format, vec3 color, float alpha) {
    const std::size_t channels = std::size_t(format.channels);
    if (format.component == Component::f32) {  // premultiplied where there is alpha
        float value[4];
        std::memcpy(value, pixel, channels * sizeof(float));
        for (std::size_t c = 0; c < 3; ++c) value[c] = value[c] * (1 - alpha) + color[c] * alpha;
        if (channels == 4) value[3] = value[3] * (1 - alpha) + alpha;
        std::memcpy(pixel, value, channels * sizeof(float));
        return;
    }
    auto* const codes = reinterpret_cast<std::uint8_t*>(pixel);
    const float under = (channels == 4 ? float(codes[3]) / 255 : 1.0f) * (1 - alpha), all = alpha + under;
    const SrgbEncoder& encode = SrgbEncoder::instance();
    for (std::size_t c = 0; c < 3; ++c)
        codes[c] = std::uint8_t(encode((color[c] * alpha + linear_from_srgb8(codes[c]) * under) / all));
    if (channels == 4) codes[3] = std::uint8_t(std::min(all, 1.0f) * 255 + 0.5f);
}

void lay_codes(std::byte* pixel, const PixelFormat& format, const std::byte* rgba) {
    const auto code = [&](std::size_t c) { return std::to_integer<std::uint8_t>(rgba[c]); };
    if (code(3) == 0) return;
    lay(pixel, format, {linear_from_srgb8(code(0)), linear_from_srgb8(code(1)), linear_from_srgb8(code(2))},
        float(code(3)) / 255);
}

Pixels clear_picture(int width, int height) {
    Pixels out{.width = width, .height = height, .channels = 4, .component = Component::u8};
    out.bytes.resize(out.row_bytes() * std::size_t(height));
    return out;
}

bool is_light(vec4 background) {
    const float y = 0.2126f * background.x + 0.7152f * background.y + 0.0722f * background.z;
    return background.w > 0.5f && double(srgb_from_linear(std::clamp(y, 0.0f, 1.0f))) > light_background;
}

std::string name_of_file(const std::string& input) { return std::filesystem::path(input).filename().string(); }

}  // namespace

Overlay::Overlay(const PictureRequest& request, const Scene& scene, const Camera& camera, const Bounds& shown)
    : width_(request.settings.width), height_(request.settings.height) {
    const Overlays& wanted = request.overlays;
    const Bounds bounds = wanted.grid && shown.empty() ? world_bounds(scene) : shown;
    if (wanted.grid && !bounds.empty()) {
        const dvec3 up = normalize_or(request.view.world_up.value_or(dvec3{0, 1, 0}), dvec3{0, 1, 0});
        const bool has_sky = scene.environment && scene.environment->is_background;
        grid_.emplace(shading::make_picture_camera(camera, camera.to_world, request.settings), up, bounds,
                      has_sky || is_light(request.settings.background));
    }
    if (request.coloring.is_on && request.coloring.has_bar)
        if (ScalarBar bar(request.coloring, width_, height_); !bar.pixels.bytes.empty())
            sprites_.push_back({bar.x, bar.y, std::move(bar.pixels)});
    if (wanted.axis) add_axes(camera);
    if (wanted.filename) add_words(name_of_file(request.input), Corner::top);
    if (wanted.metadata) add_words(metadata_text(name_of_file(request.input), scene), Corner::bottom_right);
}

void Overlay::add_axes(const Camera& camera) {
    const int scale = text_scale_for(height_);
    const int side = std::clamp(std::min(width_, height_) / 5, 12 * scale, widest_axes_px);
    Sprite sprite{0, height_ - side, clear_picture(side, side)};
    const double arm = 0.5 * side - 6.0 * scale;
    struct Arm {
        dvec2 tip;
        double nearness;
        std::size_t axis;
    };
    std::vector<Arm> arms;
    const dvec3 right = normalize_or(camera.to_world[0].xyz(), dvec3{1, 0, 0}),
                up = normalize_or(camera.to_world[1].xyz(), dvec3{0, 1, 0}),
                back = normalize_or(camera.to_world[2].xyz(), dvec3{0, 0, 1});
    for (std::size_t axis = 0; axis < 3; ++axis)
        arms.push_back({{right[axis] * arm, -up[axis] * arm}, back[axis], axis});
    std::ranges::stable_sort(arms, {}, &Arm::nearness);
    const dvec2 middle{0.5 * side, 0.5 * side};
    const auto at = [&](dvec2 v, double share) { return dvec2{middle.x + v.x * share, middle.y + v.y * share}; };
    for (const Arm& a : arms) {
        draw_line(sprite.pixels, middle, at(a.tip, 0.8), 1.5 * scale + 1.5, halo_color);
        draw_line(sprite.pixels, middle, at(a.tip, 0.8), 1.5 * scale, axis_codes[a.axis]);
    }
    for (const Arm& a : arms) {
        const dvec2 tip = at(a.tip, 1);
        draw_text(sprite.pixels, int(std::floor(tip.x - 2.5 * scale)), int(std::floor(tip.y - 3.5 * scale)),
                  std::string(1, char('X' + int(a.axis))),
                  {.color = axis_codes[a.axis], .scale = scale, .halo = halo_color});
    }
    sprites_.push_back(std::move(sprite));
}

void Overlay::add_words(const std::string& text, Corner corner) {
    const int scale = text_scale_for(height_), margin = margin_dots * scale;
    const int width = text_width(text, scale) + 2 * scale,
              height = text_height(text, scale) + 2 * scale;  // with the halo
    const int most = width_ - 2 * margin;
    if (most < 8 * scale || height > height_) return;  // no room for words
    Sprite sprite{.x = 0, .y = 0, .pixels = clear_picture(std::min(width, most), height)};
    draw_text(sprite.pixels, scale, scale, text, {.color = words_color, .scale = scale, .halo = halo_color});
    sprite.x = corner == Corner::top ? (width_ - sprite.pixels.width) / 2 : width_ - margin - sprite.pixels.width;
    sprite.y = corner == Corner::top ? margin : height_ - margin - height;
    sprites_.push_back(std::move(sprite));
}

void Overlay::draw(const PictureRows& rows, Context& context) const {
    const std::size_t pixel = rows.format.bytes(), row_bytes = pixel * std::size_t(rows.width);
    if (grid_ && rows.depth)
        context.parallel_for(std::size_t(rows.height), [&](std::size_t row) {
            std::byte* const to = rows.bytes + row * row_bytes;
            const float* const depth = rows.depth + row * std::size_t(rows.width);
            for (int i = 0; i < rows.width; ++i) {
                const vec4 line = grid_->at(rows.x + i, rows.y + int(row), double(depth[i]));
                if (line.w > 0) lay(to + std::size_t(i) * pixel, rows.format, line.xyz(), line.w);
            }
        });
    for (const Sprite& s : sprites_) {
        const int left = std::max(s.x, rows.x), right = std::min(s.x + s.pixels.width, rows.x + rows.width);
        const int top = std::max(s.y, rows.y), bottom = std::min(s.y + s.pixels.height, rows.y + rows.height);
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x)
                lay_codes(rows.bytes + std::size_t(y - rows.y) * row_bytes + std::size_t(x - rows.x) * pixel,
                          rows.format, s.pixels.row(y - s.y) + 4 * std::size_t(x - s.x));
    }
}

}  // namespace rakelight
