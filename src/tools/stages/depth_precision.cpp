// SPDX-License-Identifier: Apache-2.0
// What a z-buffer keeps of a distance with this camera's near and far: the curve, and the size of a step in each
// format.
#include <algorithm>
#include <cmath>

#include "engines/raster/visibility/depth_formats.h"
#include "math/functions.h"
#include "tools/stages/plot.h"

namespace rakelight::stages {
namespace {

using raster::DepthRange;

struct Format {
    Visibility method;
    const char* name;
    Code color;
};
constexpr Format formats[] = {{Visibility::z16, "z16", {235, 90, 70}},
                              {Visibility::z24, "z24", {240, 170, 60}},
                              {Visibility::z_float, "z-float", {225, 215, 90}},
                              {Visibility::z32, "z32", {90, 200, 110}},
                              {Visibility::z_reversed, "z-reversed", {90, 160, 250}}};
constexpr int width = 640, height = 400, left = 64, right = 560, top = 16, bottom = 370;
constexpr Code grid{48, 54, 68}, words{190, 195, 205}, curve{90, 160, 250};

constexpr double ln_10 = 2.302585092994046;
double log10_of(double v) { return math::log(v) / ln_10; }
double power_of_ten(double e) { return math::exp(e * ln_10); }

/// [m] short enough for an axis: "1.234e+04" would touch its neighbors.
std::string meters(double v) {
    const std::string text = digits(v >= 100 ? std::floor(v + 0.5) : v, 4);
    return text.size() > 8 ? digits(v, 3) : text;
}

double x_of(double part) { return left + part * (right - left); }
double y_of(double part) { return bottom - part * (bottom - top); }

Canvas framed() {
    Canvas canvas(width, height, ground);
    for (const double y : {double(top), double(bottom)}) canvas.line({left, y}, {right, y}, grid);
    for (const double x : {double(left), double(right)}) canvas.line({x, top}, {x, bottom}, grid);
    return canvas;
}

void label_x(Canvas& canvas, double part, const std::string& text) {
    canvas.line({x_of(part), top}, {x_of(part), bottom}, grid);
    canvas.write(int(x_of(part)), bottom + 8, text, words, Align::center);
}
void label_y(Canvas& canvas, double part, const std::string& text) {
    canvas.line({left, y_of(part)}, {right, y_of(part)}, grid);
    canvas.write(left - 6, int(y_of(part)) - letter_height / 2, text, words, Align::right);
}

/// The camera's; a far plane without end is shown to ten thousand times near.
DepthRange plotted_range(const shading::PictureCamera& view) {
    return {view.z_near, std::isinf(view.z_far) ? view.z_near * 1e4 : view.z_far, view.orthographic};
}

/// Where the depth reaches a value: standard_depth() turned round.
double distance_at(double depth, const DepthRange& r) {
    if (r.orthographic) return r.z_near + depth * (r.z_far - r.z_near);
    return r.z_far * r.z_near / (r.z_far - depth * (r.z_far - r.z_near));
}

Picture curve_picture(const DepthRange& r) {
    Canvas canvas = framed();
    for (int i = 0; i <= 10; i += 2) {
        label_x(canvas, i / 10.0, meters(r.z_near + i / 10.0 * (r.z_far - r.z_near)));
        label_y(canvas, i / 10.0, digits(i / 10.0, 1));
    }
    const int steps = 4 * (right - left);  // the curve is steep at its beginning
    dvec2 last;
    for (int i = 0; i <= steps; ++i) {
        const double part = double(i) / steps;
        const dvec2 p = {x_of(part), y_of(raster::standard_depth(r.z_near + part * (r.z_far - r.z_near), r))};
        if (i > 0) canvas.line(last, p, curve);
        last = p;
    }
    const double depth = raster::standard_depth(r.z_near + 0.02 * (r.z_far - r.z_near), r);
    canvas.line({x_of(0.02), bottom}, {x_of(0.02), y_of(depth)}, frame);
    canvas.line({x_of(0), y_of(depth)}, {x_of(0.02), y_of(depth)}, frame);
    canvas.write(int(x_of(0.02)) + 12, int(y_of(depth)) + 12, "2%   " + digits(100 * depth, 3) + "%", frame);
    return {"depth-curve",
            "The depth that is stored, 0 to 1, over the distance [m]. Orange: the first 2 % of the range.",
            std::move(canvas)};
}

/// Both axes by powers of ten.
Picture step_picture(const DepthRange& r) {
    const double low_x = log10_of(r.z_near), high_x = log10_of(r.z_far), low_y = -10, high_y = 3;
    const auto along = [&](double log_x) { return (log_x - low_x) / (high_x - low_x); };
    const auto up = [&](double log_y) { return (log_y - low_y) / (high_y - low_y); };
    Canvas canvas = framed();
    for (double e = std::ceil(low_x); e <= high_x + 1e-9; ++e) label_x(canvas, along(e), meters(power_of_ten(e)));
    for (int e = int(low_y); e <= int(high_y); ++e) label_y(canvas, up(e), "1e" + std::to_string(e));
    for (const Format& f : formats) {
        dvec2 last;
        for (int x = left; x <= right; ++x) {
            const double distance = power_of_ten(low_x + (high_x - low_x) * (x - left) / (right - left));
            const double part = up(log10_of(raster::depth_step(f.method, distance, r)));
            const dvec2 p = {double(x), y_of(std::min(std::max(part, 0.0), 1.0))};
            if (x > left) canvas.line(last, p, f.color);
            if (x > left && f.method == Visibility::z24)
                canvas.line({last.x, last.y + 1}, {p.x, p.y + 1}, f.color);  // z-float lies on it
            last = p;
        }
    }
    int y = top + 8;
    for (const Format& f : formats) {
        canvas.write(left + 12, y, f.name, f.color);
        y += letter_height + 6;
    }
    return {"depth-steps",
            "The size of one step of the stored number [m] over the distance [m], both by powers of ten: z16, z24, "
            "z-float, z32, z-reversed.",
            std::move(canvas)};
}

Stage make_precision_stage(const Sources& of) {
    const DepthRange r = plotted_range(of.engine.view());
    Stage s{
        .id = "depth-precision",
        .title = "Precision of the depth",
        .text =
            "The depth test does not compare distances but a number that is affine on the screen. In perspective the "
            "textbook's number is far (z - near) / (z (far - near)): most of its values lie close to the near plane, "
            "and a step of the stored number grows with the square of the distance. The reversed number near / z as a "
            "float has its finest values where the steps are widest. The setting visibility draws with each."};
    s.numbers = {
        {"near [m]", r.z_near},
        {"far [m]", cell(of.engine.view().z_far)},
        {"share of the depths in the first 2 % of the range",
         raster::standard_depth(r.z_near + 0.02 * (r.z_far - r.z_near), r)},
        {"part of the range that 98 % of the depths reach", (distance_at(0.98, r) - r.z_near) / (r.z_far - r.z_near)}};
    s.pictures.push_back(curve_picture(r));
    if (r.z_near > 0) s.pictures.push_back(step_picture(r));
    s.columns = {"distance [m]", "stored depth"};
    for (const Format& f : formats) s.columns.push_back(std::string("step of ") + f.name + " [m]");
    for (const double part : {0.0, 0.001, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0}) {
        const double distance = r.z_near + part * (r.z_far - r.z_near);
        Cell::List row = {distance, raster::standard_depth(distance, r)};
        for (const Format& f : formats) row.push_back(raster::depth_step(f.method, distance, r));
        s.rows.push_back(std::move(row));
    }
    s.rows_note = "Steps at distances of the range";
    return s;
}

}  // namespace

constinit const StageKind depth_precision_stage{make_precision_stage};

}  // namespace rakelight::stages
