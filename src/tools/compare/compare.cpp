// SPDX-License-Identifier: Apache-2.0
#include "tools/compare/compare.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>

#include <nlohmann/json.hpp>

#include <rakelight/io/image_sources.h>
#include <rakelight/io/world.h>
#include <rakelight_internal/base/file_ending.h>

#include "base/format_text.h"
#include "image/compare/compare.h"
#include "image/compare/flip.h"
#include "image/compare/ssim.h"
#include "image/decode.h"
#include "image/false_color.h"
#include "io/pictures/image_io.h"
#include "io/reader.h"
#include "tools/compare/compare_components.h"
#include "tools/compare/compare_numbers.h"
#include "tools/report_json.h"
#include "tools/text_table.h"

namespace rakelight {
namespace {

void check(const CompareOptions& options) {
    if (!(options.tolerance >= 0)) throw Error(ErrorCode::usage, "must be 0 or more").about("tolerance");
    if (!(options.pixels_per_degree >= flip_least_ppd && options.pixels_per_degree <= flip_most_ppd))
        throw Error(ErrorCode::usage, "must be 1 to 1000").about("pixels-per-degree");
}

void check_sizes(const Pixels& a, const Pixels& b) {
    const auto text = [](const Pixels& p) { return format_text("{} x {}", p.width, p.height); };
    if (a.width != b.width || a.height != b.height)
        throw Error(ErrorCode::check_failed, "the pictures differ in size: " + text(a) + " and " + text(b) + " pixels");
}

PictureComparison compare(const ComparedPictures::State& s, std::vector<float>& flip_map, Context& context) {
    const PictureDifference d = compare_pictures(s.a, s.b, s.options.tolerance);
    const double pixels = double(s.a.width) * double(s.a.height);
    return {.width = s.a.width,
            .height = s.a.height,
            .max_error = d.max_absolute,
            .rmse = d.rmse,
            .psnr_db = d.psnr_db,
            .ssim = mean_ssim(s.display_a, s.display_b, context),
            .flip = mean_flip(s.display_a, s.display_b, s.options.pixels_per_degree, context, &flip_map),
            .differing_pixels = d.differing_pixels,
            .differing_share = pixels > 0 ? double(d.differing_pixels) / pixels : 0};
}

Pixels rgb_picture(int width, int height, Component component) {
    Pixels out{width, height, 3, component, component == Component::f32, {}};
    out.bytes.resize(out.row_bytes() * std::size_t(height));
    return out;
}

/// Red, green or blue; of gray pictures gray.
double color_at(const Pixels& p, std::size_t pixel, int c) {
    return component_at(p, pixel * std::size_t(p.channels) + std::size_t(p.channels < 3 ? 0 : c));
}

/// As numbers, for EXR and HDR.
Pixels difference_numbers(const ComparedPictures::State& s, DifferenceKind kind, double gain) {
    Pixels out = rgb_picture(s.a.width, s.a.height, Component::f32);
    for (std::size_t i = 0; i < s.flip_map.size(); ++i) {
        float rgb[3] = {s.flip_map[i], s.flip_map[i], s.flip_map[i]};
        for (int c = 0; c < 3 && kind == DifferenceKind::absolute; ++c)
            rgb[c] = float(gain * std::fabs(color_at(s.a, i, c) - color_at(s.b, i, c)));
        std::memcpy(out.bytes.data() + i * sizeof rgb, rgb, sizeof rgb);
    }
    return out;
}

/// |a - b| of displayed colors.
Code absolute_code(std::uint32_t a, std::uint32_t b, double gain) {
    const auto part = [&](int shift) {
        const int d = int(a >> shift & 255) - int(b >> shift & 255);
        return code_of(gain * std::abs(d) / 255.0);
    };
    return {part(0), part(8), part(16)};
}

struct Limit {
    const char* name;
    std::optional<double> CompareLimits::*limit;
    bool is_least;
    const char* unit;
    double (*value)(const PictureComparison&);
};

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr Limit all_limits[] = {
    {"max-error", &CompareLimits::max_error, false, "", [](const PictureComparison& c) { return c.max_error; }},
    {"max-rmse", &CompareLimits::max_rmse, false, "", [](const PictureComparison& c) { return c.rmse; }},
    {"min-psnr", &CompareLimits::min_psnr_db, true, " dB", [](const PictureComparison& c) { return c.psnr_db; }},
    {"min-ssim", &CompareLimits::min_ssim, true, "", [](const PictureComparison& c) { return c.ssim.value_or(none); }},
    {"max-flip", &CompareLimits::max_flip, false, "", [](const PictureComparison& c) { return c.flip; }},
    {"max-differing", &CompareLimits::max_differing_share, false, " of the pixels",
     [](const PictureComparison& c) { return c.differing_share; }},
};

Json finite_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(); }

void add(Json& row, const PictureComparison& c, const ComparisonRow& r) {
    row["width"] = c.width;
    row["height"] = c.height;
    row["equal"] = c.is_equal();  // tells a PSNR without end, null, from a RMSE without end, which is null too
    row["max_error"] = finite_or_null(c.max_error);
    row["rmse"] = finite_or_null(c.rmse);
    row["psnr_db"] = finite_or_null(c.psnr_db);
    row["ssim"] = c.ssim ? Json(*c.ssim) : Json();
    row["flip"] = c.flip;
    row["pixels_per_degree"] = r.options.pixels_per_degree;
    row["tolerance"] = r.options.tolerance;
    row["differing_pixels"] = c.differing_pixels;
    row["differing_share"] = c.differing_share;
    Json failures = Json::array();
    for (const CheckFailure& f : r.failures) failures.push_back({{"limit", f.limit}, {"message", f.message}});
    row["check"] = {{"passed", r.failures.empty()}, {"failures", failures}};
    if (!r.output.empty()) row["output"] = r.output;
}

}  // namespace

ComparedPictures::ComparedPictures(Pixels a, Pixels b, const CompareOptions& options, Context& context) {
    check(options);
    check_sizes(a, b);
    auto s = std::make_unique<State>();
    s->options = options;
    s->display_a = to_display(a, context);
    s->display_b = to_display(b, context);
    make_comparable(a, b, context);
    s->a = std::move(a), s->b = std::move(b);
    s->map_charge = MemoryCharge(context.memory(), s->display_a.codes.size() * sizeof(float), "the map of differences");
    s->comparison = compare(*s, s->flip_map, context);
    state_ = std::move(s);
}

ComparedPictures::~ComparedPictures() = default;
ComparedPictures::ComparedPictures(ComparedPictures&&) noexcept = default;
ComparedPictures& ComparedPictures::operator=(ComparedPictures&&) noexcept = default;

const PictureComparison& ComparedPictures::comparison() const { return state_->comparison; }

Pixels ComparedPictures::difference(DifferenceKind kind, double gain, Component component) const {
    const State& s = *state_;
    if (!(gain > 0 && std::isfinite(gain))) throw Error(ErrorCode::usage, "must be a number > 0").about("gain");
    if (component == Component::f32) return difference_numbers(s, kind, gain);
    Pixels out = rgb_picture(s.a.width, s.a.height, Component::u8);
    for (std::size_t i = 0; i < s.flip_map.size(); ++i) {
        const Code code = kind == DifferenceKind::flip
                              ? heat(double(s.flip_map[i]))
                              : absolute_code(s.display_a.codes[i], s.display_b.codes[i], gain);
        std::byte* const to = out.bytes.data() + 3 * i;
        to[0] = std::byte(code.r), to[1] = std::byte(code.g), to[2] = std::byte(code.b);
    }
    return out;
}

Pixels read_picture(const std::string& path, Context& context) { return decode(*image_from_file(path), context); }

bool has_picture_ending(const std::string& path) {
    constexpr const char* endings[] = {"png", "jpg", "jpeg", "webp", "exr", "hdr", "tga", "bmp"};
    return std::ranges::find(endings, file_ending(path)) != std::end(endings);
}

bool is_scene(const std::string& name) {
    return is_world_file(name) || name.starts_with("builtin:") || io::has_model_ending(name);
}

void save_difference(const ComparedPictures& pictures, DifferenceKind kind, double gain, const std::string& path) {
    const Component component = io::component_for(path) == Component::f32 ? Component::f32 : Component::u8;
    io::write_image(path, pictures.difference(kind, gain, component));
}

std::vector<CheckFailure> check_limits(const PictureComparison& comparison, const CompareLimits& limits) {
    std::vector<CheckFailure> failures;
    for (const Limit& l : all_limits) {
        if (!(limits.*l.limit)) continue;
        const double limit = *(limits.*l.limit), value = l.value(comparison);
        if (value != value)
            failures.push_back({l.name, "pictures with a side under 11 pixels have none"});
        else if (l.is_least ? value < limit : value > limit)
            failures.push_back({l.name, short_digits(value) + l.unit + (l.is_least ? ", less than " : ", more than ") +
                                            short_digits(limit)});
    }
    return failures;
}

std::string title_of(const std::string& name, const std::string& engine) {
    return one_line(name) + (engine.empty() ? "" : " (" + one_line(engine, 40) + ")");
}

std::string to_text(std::span<const ComparisonRow> rows) {
    std::vector<std::string> head = {"A", "B"};
    for (const auto& [name, value] : numbers_of({})) head.push_back(">" + name);
    TextTable table(head);
    for (const ComparisonRow& r : rows) {
        if (!r.comparison) continue;
        std::vector<std::string> cells = {title_of(r.a, r.engine_a), title_of(r.b, r.engine_b)};
        for (auto& [name, value] : numbers_of(*r.comparison)) cells.push_back(value);
        table.add(std::move(cells));
    }
    return table.empty() ? std::string() : table.text("");
}

std::string to_json(std::span<const ComparisonRow> rows) {
    Json list = Json::array();
    for (const ComparisonRow& r : rows) {
        Json row = {{"a", r.a}, {"b", r.b}};
        if (!r.engine_a.empty()) row["engine_a"] = r.engine_a;
        if (!r.engine_b.empty()) row["engine_b"] = r.engine_b;
        if (r.error) row["error"] = error_json(*r.error);
        if (r.comparison) add(row, *r.comparison, r);
        row["remarks"] = remarks_json(r.remarks);
        row["remarks_left_out"] = r.remarks_left_out;
        list.push_back(std::move(row));
    }
    return document("rakelight.compare/1", std::move(list));
}

}  // namespace rakelight
