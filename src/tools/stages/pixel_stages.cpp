// SPDX-License-Identifier: Apache-2.0
// The stages that pixels go through: pictures of the engine's channels, and their totals.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "tools/object_title.h"
#include "tools/stages/paint.h"

namespace rakelight::stages {
namespace {

std::uint64_t count(const std::vector<std::uint16_t>& overdraw) {
    return std::uint64_t(std::count_if(overdraw.begin(), overdraw.end(), [](std::uint16_t n) { return n > 0; }));
}

Stage make_culling_stage(const Sources& of) {
    Stage s{.id = "culled",
            .title = "Culling",
            .text =
                "Invisible parts are dropped before any pixel is tested: objects and triangles entirely outside the "
                "picture, triangles without area on the screen, and back faces (of closed surfaces, as their material "
                "says; the setting cull chooses)."};
    const RenderStats& stats = of.drawn.stats();
    s.numbers = {{"triangles in", stats.triangles_in},
                 {of.engine.settings().samples > 1 ? "outside, or no sample in their box"
                                                   : "outside, or no pixel center in their box",
                  stats.culled_outside},
                 {"without area", stats.culled_degenerate},
                 {"facing the wrong way", stats.culled_back},
                 {"clipped", stats.clipped},
                 {"drawn, pieces counted", stats.drawn}};
    Canvas canvas = paint(of, [&](std::size_t p) {
        const std::uint8_t faces = of.pixels.faces[p];
        const bool is_drawn = (faces & 4) != 0;
        if (faces & 1) return is_drawn ? Code{120, 60, 60} : Code{240, 70, 60};
        if (faces & 2) return is_drawn ? Code{60, 70, 130} : Code{80, 110, 250};
        return is_drawn ? Code{110, 110, 110} : backdrop;
    });
    s.pictures.push_back({"culled",
                          "Red: a face seen from behind was dropped here; blue: one from the front. Bright where "
                          "nothing else covers the pixel, dull where something does; gray: nothing was dropped.",
                          std::move(canvas)});
    return s;
}

constexpr int most_shown = 12;  ///< what is covered more often has the last color

/// Of once, the same color in all pictures, to that of `most`: 0..1 in the colors of heat().
double place_of_count(int count, int most) {
    constexpr double once = 0.15;
    const int last = std::clamp(most, 2, most_shown);
    return once + (1 - once) * double(std::min(count, last) - 1) / double(last - 1);
}

std::string coverage_caption(int most) {
    const std::string what = "Opaque triangles over each pixel: ";
    if (most == 0) return what + "none anywhere.";
    if (most == 1) return what + "blue 1. No pixel is covered twice.";
    if (most == 2) return what + "blue 1, white 2.";
    return what + "blue 1, over green and yellow to white " +
           (most > most_shown ? std::to_string(most_shown) + " and more." : std::to_string(most) + ".");
}

Stage make_coverage_stage(const Sources& of) {
    Stage s{.id = "coverage",
            .title = "Coverage",
            .text =
                "Which pixel centers lie in each triangle: three edge functions in whole numbers, with the rule that a "
                "center exactly on an edge belongs to the triangle whose top or left edge it is. "
                "How often a pixel is covered by something opaque is the overdraw, the same as the data channel of "
                "that name: masked triangles count where their texture is opaque; what is blended over the picture has "
                "a stage of its own."};
    const std::vector<std::uint16_t>& overdraw = of.pixels.overdraw;
    const std::uint16_t most = *std::max_element(overdraw.begin(), overdraw.end());
    std::uint64_t sum = 0;
    std::vector<std::uint64_t> histogram(std::size_t(most) + 1, 0);
    for (const std::uint16_t n : overdraw) sum += n, ++histogram[n];
    const std::uint64_t covered = count(overdraw);
    s.numbers = {{"pixels", overdraw.size()},
                 {"pixels covered", covered},
                 {"times covered, all pixels", sum},
                 {"mean overdraw of covered pixels", covered > 0 ? double(sum) / double(covered) : 0.0},
                 {"largest overdraw", most}};
    s.columns = {"triangles over a pixel", "pixels"};
    for (std::size_t n = 0; n < std::min<std::size_t>(histogram.size(), 48); ++n) s.rows.push_back({n, histogram[n]});
    s.rows_note = "How many pixels are covered how often";
    s.pictures.push_back({"coverage", coverage_caption(most), paint(of, [&](std::size_t p) {
                              return overdraw[p] == 0 ? backdrop : heat(place_of_count(overdraw[p], most));
                          })});
    return s;
}

constexpr std::size_t most_stepped = 48;  ///< triangles that are listed

/// Two pixels of a triangle, the first and the last that show it.
struct SteppedTriangle {
    std::size_t first = 0, last = 0;
};

/// Of each visible triangle, in the order of their first pixels.
std::vector<SteppedTriangle> stepped_triangles(const raster::PixelStageData& pixels) {
    std::vector<SteppedTriangle> all;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> known;
    for (std::size_t p = 0; p < pixels.draw.size(); ++p) {
        if (pixels.draw[p] == no_index) continue;
        const auto [at, is_new] = known.try_emplace({pixels.draw[p], pixels.triangle[p]}, all.size());
        if (is_new) all.push_back({p, p});
        all[at->second].last = p;
    }
    return all;
}

/// The textbook's way to depth: the plane's slopes times the steps, from one pixel to another of the triangle.
void add_steps(Stage& s, const Sources& of) {
    const raster::PixelStageData& d = of.pixels;
    const auto width = std::size_t(of.engine.settings().width);
    const shading::DrawList& list = of.engine.list();
    double largest = 0;
    for (const SteppedTriangle& t : stepped_triangles(d)) {
        const std::size_t a = t.first, b = t.last;
        const int right = int(b % width) - int(a % width), down = int(b / width) - int(a / width);
        const double key = double(d.depth_key[a]), slope_x = double(d.depth_slope[a].x),
                     slope_y = double(d.depth_slope[a].y);
        const double by_steps = key + slope_x * right + slope_y * down, error = by_steps - double(d.depth_key[b]);
        largest = std::max(largest, std::fabs(error));
        if (a == b || s.rows.size() >= most_stepped) continue;
        s.rows.push_back({object_title(list.scene, list.draws[d.draw[a]].node),
                          d.triangle[a],
                          {a % width, a / width},
                          key,
                          slope_x,
                          slope_y,
                          {right, down},
                          by_steps,
                          double(d.depth_key[b]),
                          error});
    }
    s.columns = {"object",
                 "triangle",
                 "pixel",
                 "key there",
                 "d key/dx [1/px]",
                 "d key/dy [1/px]",
                 "steps",
                 "key + slopes x steps",
                 "key that the engine has there",
                 "difference"};
    s.rows_note = "Visible triangles of more than one pixel: from the first to the last one that shows each";
    s.numbers["largest difference, all visible triangles"] = largest;
}

Stage make_depth_stage(const Sources& of) {
    Stage s{.id = "depth",
            .title = "Depth",
            .text =
                "At each covered pixel the depth keys are compared, and the nearest opaque surface stays; of equal "
                "ones the first. Depth is shown as distance along the view axis. The key is a plane over the screen, "
                "of constant slopes in each triangle: one more pixel to the right or down adds one slope."};
    const std::vector<float>& distance = of.pixels.distance;
    double low = std::numeric_limits<double>::infinity(), high = 0;
    for (const float d : distance)
        if (std::isfinite(d)) low = std::min(low, double(d)), high = std::max(high, double(d));
    if (std::isfinite(low)) s.numbers = {{"nearest [m]", low}, {"farthest [m]", high}};
    add_steps(s, of);
    s.pictures.push_back({"depth", "Light is near, dark is far.", paint(of, [&](std::size_t p) {
                              return std::isfinite(distance[p])
                                         ? gray(high > low ? 1 - 0.85 * (double(distance[p]) - low) / (high - low) : 1)
                                         : backdrop;
                          })});
    return s;
}

Stage make_visibility_stage(const Sources& of) {
    Stage s{.id = "visibility",
            .title = "Visibility",
            .text =
                "One triangle per pixel is left: only these are shaded, regardless of the overdraw. Each triangle, and "
                "each object, has a color of its own."};
    const shading::DrawList& list = of.engine.list();
    const std::vector<std::uint32_t>&draw = of.pixels.draw, &triangle = of.pixels.triangle;
    s.pictures.push_back({"triangles", "Visible triangles.", paint(of, [&](std::size_t p) {
                              return draw[p] == no_index ? backdrop : color_of_number(triangle[p] * 7 + draw[p] * 131);
                          })});
    s.pictures.push_back({"objects", "Visible objects.", paint(of, [&](std::size_t p) {
                              return draw[p] == no_index ? backdrop : color_of_number(list.draws[draw[p]].node);
                          })});
    std::vector<std::uint64_t> pixels(list.scene.nodes.size(), 0);
    std::vector<std::uint64_t> seen;
    for (std::size_t p = 0; p < draw.size(); ++p)
        if (draw[p] != no_index)
            ++pixels[list.draws[draw[p]].node], seen.push_back(std::uint64_t(draw[p]) << 32 | triangle[p]);
    std::sort(seen.begin(), seen.end());
    s.numbers["pixels that show a surface"] = seen.size();
    s.numbers["triangles of which a pixel is seen"] = std::unique(seen.begin(), seen.end()) - seen.begin();
    std::vector<std::size_t> order(pixels.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return pixels[a] > pixels[b]; });
    s.columns = {"object", "node", "pixels"};
    for (const std::size_t n : order)
        if (pixels[n] > 0 && s.rows.size() < 48)
            s.rows.push_back({object_title(list.scene, std::uint32_t(n)), n, pixels[n]});
    s.rows_note = "Pixels of each object, the largest first";
    return s;
}

Stage make_normal_stage(const Sources& of) {
    Stage s{.id = "normal",
            .title = "Normals",
            .text =
                "The vertices' normals, interpolated with perspective, bent by the normal map where the material has "
                "one, and turned to the viewer's side. Lighting uses this one."};
    s.pictures.push_back(
        {"normal", "Red, green and blue are x, y and z of the world, from -1 to 1.", paint(of, [&](std::size_t p) {
             return of.pixels.draw[p] == no_index ? backdrop : color_of_normal(of.pixels.normal[p]);
         })});
    const double inf = std::numeric_limits<double>::infinity();
    double sum[3] = {}, low[3] = {inf, inf, inf}, high[3] = {-inf, -inf, -inf};
    std::uint64_t n = 0;
    for (std::size_t p = 0; p < of.pixels.normal.size(); ++p) {
        if (of.pixels.draw[p] == no_index) continue;
        ++n;
        for (std::size_t c = 0; c < 3; ++c) {
            const double v = of.pixels.normal[p][c];
            sum[c] += v;
            low[c] = std::min(low[c], v);
            high[c] = std::max(high[c], v);
        }
    }
    s.numbers["pixels that show a surface"] = n;
    s.columns = {"axis", "mean", "least", "greatest"};
    for (std::size_t c = 0; n > 0 && c < 3; ++c)
        s.rows.push_back({std::string(1, char('x' + c)), sum[c] / double(n), low[c], high[c]});
    s.rows_note = n > 0 ? "Over the visible pixels" : "";
    return s;
}

Stage make_blending_stage(const Sources& of) {
    Stage s{.id = "blended", .title = "Blended surfaces, layer by layer"};
    s.text =
        "Transparent surfaces are laid over the opaque ones, in each pixel the farthest first: color = alpha * own "
        "color + (1 - alpha) * what is behind. Each is lit as the opaque ones are; explain names the triangles and the "
        "terms of one pixel. Shown with the exposure and the tone curve.";
    const raster::PixelStageData& d = of.pixels;
    const auto picture_of = [&](const std::vector<vec4>& color) {
        return paint(of, [&](std::size_t p) { return displayed_code(of, color[p]); });
    };
    const auto blended =
        std::count_if(d.layer_count.begin(), d.layer_count.end(), [](std::uint8_t n) { return n > 0; });
    s.numbers = {{"pixels that something is laid over", blended}, {"layers shown", d.layers.size()}};
    s.pictures.push_back({"blended-0",
                          blended == 0 ? "Nothing is laid over: this is the picture of the opaque surfaces."
                                       : "The opaque surfaces alone.",
                          picture_of(blended == 0 ? d.centers() : d.opaque)});
    s.columns = {"layer, the farthest first", "pixels", "least alpha", "mean alpha", "greatest alpha"};
    for (std::size_t k = 0; k < d.layers.size(); ++k) {
        const std::string number = std::to_string(k + 1);
        double low = 1, high = 0, sum = 0;
        std::uint64_t pixels = 0;
        for (std::size_t p = 0; p < d.layer_count.size(); ++p) {
            if (d.layer_count[p] <= k) continue;
            const double alpha = d.layers[k].alpha[p];
            low = std::min(low, alpha), high = std::max(high, alpha), sum += alpha;
            ++pixels;
        }
        s.rows.push_back({k + 1, pixels, low, sum / double(pixels), high});
        s.pictures.push_back(
            {"blended-" + number, "After layer " + number + " of each pixel.", picture_of(d.layers[k].color)});
        s.pictures.push_back(
            {"blended-" + number + "-alpha", "The alpha of layer " + number + ": black 0, white 1.",
             paint(of, [&](std::size_t p) { return d.layer_count[p] <= k ? backdrop : gray(d.layers[k].alpha[p]); })});
    }
    s.rows_note = d.layers.empty() ? "" : "Alpha over the pixels that have the layer";
    return s;
}

}  // namespace

constinit const StageKind culling_stage{make_culling_stage}, coverage_stage{make_coverage_stage},
    depth_stage{make_depth_stage};
constinit const StageKind visibility_stage{make_visibility_stage}, normal_stage{make_normal_stage},
    blending_stage{make_blending_stage};

}  // namespace rakelight::stages
