// SPDX-License-Identifier: Apache-2.0
// How often lighting is evaluated: the picture in its own color, lit once per face, once per vertex and once per pixel.
#include <cmath>

#include "base/format_text.h"
#include "engines/raster/inspect/inspect_shading.h"
#include "math/color.h"
#include "tools/stages/paint.h"

namespace rakelight::stages {
namespace {

struct Frequency {
    Shading shading;
    const char *name, *caption, *evaluated;
};
constexpr Frequency frequencies[] = {
    {Shading::unlit, "unlit", "Own color: no light at all.", "never"},
    {Shading::flat, "flat", "Flat: once per face, at its centroid.", "once a face"},
    {Shading::gouraud, "gouraud", "Gouraud: once per vertex, and the colors between are interpolated.",
     "once a vertex"},
    {Shading::phong, "phong", "Phong: once per pixel, with the normal interpolated and bumped.", "once a pixel"},
};

/// Root of the mean square over all channels, [1/255] as displayed.
double difference(const Sources& of, const std::vector<vec4>& a, const std::vector<vec4>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Code p = displayed_code(of, a[i]), q = displayed_code(of, b[i]);
        for (const int d : {p.r - q.r, p.g - q.g, p.b - q.b}) sum += double(d) * d;
    }
    return a.empty() ? 0 : std::sqrt(sum / (3 * double(a.size())));
}

Stage make_frequency_stage(const Sources& of) {
    Stage s{.id = "shading-frequency", .title = "How often lighting is evaluated"};
    s.text =
        "The sum over the lights can be evaluated per face (flat), per vertex (Gouraud), per pixel (Phong), or not at "
        "all (own color). The less often, the more the shape of the triangles shows: highlights and spot-light cones "
        "between the vertices are lost. Normal maps, height bumps and shadows act only in Phong shading.";
    s.columns = {"shading", "lighting is evaluated", "evaluations", "difference to phong [1/255]"};
    s.rows_note = "Evaluations, and the root of the mean square difference of the pictures as displayed";
    const raster::ShadedPicture phong = draw_shaded(of.engine, Shading::phong, of.context);
    for (const Frequency& f : frequencies) {
        const raster::ShadedPicture drawn =
            f.shading == Shading::phong ? phong : draw_shaded(of.engine, f.shading, of.context);
        Canvas canvas = paint(of, [&](std::size_t p) { return displayed_code(of, drawn.color[p]); });
        s.rows.push_back(
            {f.name, f.evaluated, drawn.stats.lighting_evaluations, difference(of, drawn.color, phong.color)});
        s.pictures.push_back({std::string("shading-") + f.name,
                              format_text("{} {} evaluations.", f.caption, drawn.stats.lighting_evaluations),
                              std::move(canvas)});
    }
    return s;
}

}  // namespace

constinit const StageKind frequency_stage{make_frequency_stage};

}  // namespace rakelight::stages
