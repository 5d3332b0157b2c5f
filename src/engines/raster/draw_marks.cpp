// SPDX-License-Identifier: Apache-2.0
// Marks -> pixels: coverage by distance, the depth test against the surfaces, blending.
#include <algorithm>
#include <cmath>

#include "engines/raster/coverage.h"
#include "engines/raster/marks.h"
#include "engines/raster/tile.h"

namespace rakelight::raster {
namespace {

/// How much of a pixel lies on the inner side of a straight border that passes `inside` px from its center; n is the
/// border's unit normal. The area as a function of `inside` is the integral of two boxes of |n.x| and |n.y| folded.
double half_plane(double inside, dvec2 n) {
    const double a = std::fabs(n.x), b = std::fabs(n.y), longer = std::max(a, b), shorter = std::min(a, b);
    const double end = 0.5 * (longer + shorter), flat = 0.5 * (longer - shorter), x = std::fabs(inside);
    const double outer = x >= end ? 0.0 : x <= flat ? 0.5 - x / longer : (end - x) * (end - x) / (2 * longer * shorter);
    return inside < 0 ? outer : 1 - outer;
}

/// How much of a pixel a strip covers whose middle is `d` px from its center, half as wide as `half`.
double strip(dvec2 d, double distance, dvec2 across, double half) {
    const dvec2 n = distance > 1e-9 ? dvec2{d.x / distance, d.y / distance} : across;
    return std::max(0.0, half_plane(half - distance, n) - half_plane(-half - distance, n));
}

/// The marks of one tile.
class MarkTile {
public:
    MarkTile(const TileJob& job, std::size_t tile, TileScratch& scratch)
        : job_(job),
          marks_(*job.marks),
          s_(scratch),
          area_(job.grid.pixels(tile)),
          ox_(job.grid.origin_x(tile)),
          oy_(job.grid.origin_y(tile)),
          first_(job.binned.offsets[tile]),
          half_line_(0.5 * double(job.front.settings.line_width)),
          half_point_(0.5 * double(job.front.settings.point_size)),
          items_(marks_.items.begin() + marks_.offsets[tile], marks_.items.begin() + marks_.offsets[tile + 1]) {
        s_.pending.resize(tile_pixels);
    }

    void run() {
        if (!marks_.is_of_one_color)
            std::stable_sort(items_.begin(), items_.end(),
                             [this](std::uint64_t a, std::uint64_t b) { return depth(a) < depth(b); });
        for (const std::uint64_t item : items_) add(marks_.at(item));
        for (const std::uint32_t p : touched_) lay(p);
    }

private:
    float depth(std::uint64_t item) const { return marks_.at(item).key[0] + marks_.at(item).key[1]; }

    void add(const Mark& m) {
        const bool is_line = m.shape == Mark::Shape::line;
        const double half = is_line ? half_line_ : half_point_;
        const double reach = mark_reach(is_line ? job_.front.settings.line_width : job_.front.settings.point_size);
        const int left = std::max(int(std::floor(double(std::min(m.x[0], m.x[1])) - reach)), area_.x);
        const int right = std::min(int(std::ceil(double(std::max(m.x[0], m.x[1])) + reach)), area_.x + area_.width - 1);
        const int top = std::max(int(std::floor(double(std::min(m.y[0], m.y[1])) - reach)), area_.y);
        const int bottom =
            std::min(int(std::ceil(double(std::max(m.y[0], m.y[1])) + reach)), area_.y + area_.height - 1);
        const double dx = double(m.x[1]) - double(m.x[0]), dy = double(m.y[1]) - double(m.y[0]),
                     square = dx * dx + dy * dy;
        const double scale = square > 0 ? 1 / square : 0, size = std::sqrt(square);
        const dvec2 across = square > 0 ? dvec2{-dy / size, dx / size} : dvec2{1, 0};
        for (int y = top; y <= bottom; ++y)
            for (int x = left; x <= right; ++x) {
                const double px = x + 0.5 - double(m.x[0]), py = y + 0.5 - double(m.y[0]);
                const double t = std::min(std::max((px * dx + py * dy) * scale, 0.0), 1.0);
                const dvec2 d = {px - t * dx, py - t * dy};
                const double covered = m.shape == Mark::Shape::square
                                           ? square_coverage(d, half)
                                           : strip(d, std::sqrt(d.x * d.x + d.y * d.y), across, half);
                if (covered > 1e-6) touch(std::size_t((y - oy_) * tile_size + x - ox_), m, t, float(covered), reach);
            }
    }

    static double square_coverage(dvec2 d, double half) {
        return strip({d.x, 0}, std::fabs(d.x), {1, 0}, half) * strip({0, d.y}, std::fabs(d.y), {0, 1}, half);
    }

    /// Marks of one color that follow each other on a pixel are united: the greater coverage counts, so that corners
    /// are not darker.
    void touch(std::size_t p, const Mark& m, double t, float covered, double reach) {
        const double key = double(m.key[0]) + (double(m.key[1]) - double(m.key[0])) * t;
        if (s_.visible[p] >= 0 && key + bias(s_.visible[p], key, reach) < double(s_.depth[p])) return;
        PendingMark& pending = s_.pending[p];
        const bool is_same = m.color[0] == m.color[1] && m.color[0] == pending.color_number;
        if (pending.coverage == 0)
            touched_.push_back(std::uint32_t(p));
        else if (!is_same)
            lay(std::uint32_t(p));
        if (pending.coverage == 0)
            pending = {color_at(m, key, t), covered, m.color[0] == m.color[1] ? m.color[0] : none};
        else
            pending.coverage = std::max(pending.coverage, covered);
    }

    /// How much farther than the visible surface a mark on it may seem: its plane's change over `reach`, at most its
    /// whole depth, and what rounding makes.
    double bias(std::int32_t visible, double key, double reach) {
        if (visible != surface_) {
            const ScreenTriangle& s = job_.binned.at(job_.binned.items[first_ + std::uint32_t(visible)]);
            surface_ = visible;
            Coverage c;
            set_depth(s, 0, 0, c);
            slope_ = std::fabs(double(c.depth_x)) + std::fabs(double(c.depth_y));
            range_ = double(c.depth_high) - double(c.depth_low);
        }
        return std::min(range_, slope_ * reach) + 4e-6 * std::fabs(key);
    }

    vec4 color_at(const Mark& m, double key, double t) const {
        const vec4 a = marks_.colors[m.color[0]], b = marks_.colors[m.color[1]];
        if (m.color[0] == m.color[1]) return a;
        const bool is_flat = job_.front.view.orthographic || !(key > 0);
        const double ka = is_flat ? 1 : double(m.key[0]), kb = is_flat ? 1 : double(m.key[1]);
        const double part = (double(m.part[0]) * ka * (1 - t) + double(m.part[1]) * kb * t) / (ka * (1 - t) + kb * t);
        return a + (b - a) * float(part);
    }

    /// Porter & Duff 1984, straight alpha.
    void lay(std::uint32_t p) {
        PendingMark& pending = s_.pending[p];
        vec4& to = s_.color[p];
        const vec4 c = pending.color;
        const float opacity = pending.coverage * std::min(std::max(c.w, 0.0f), 1.0f);
        const float under = to.w * (1 - opacity), alpha = opacity + under;
        if (alpha > 0)
            to = {(c.x * opacity + to.x * under) / alpha, (c.y * opacity + to.y * under) / alpha,
                  (c.z * opacity + to.z * under) / alpha, alpha};
        pending = {};
        ++s_.marked;
    }

    const TileJob& job_;
    const Marks& marks_;
    TileScratch& s_;
    Window area_;
    int ox_, oy_;
    std::uint32_t first_;
    double half_line_, half_point_;
    std::vector<std::uint64_t> items_;
    std::vector<std::uint32_t> touched_;  ///< pixels where something waits
    std::int32_t surface_ = -1;
    double slope_ = 0, range_ = 0;
};

}  // namespace

bool has_marks(const TileJob& job, std::size_t tile) {
    return job.marks && !job.marks->is_empty() && job.marks->offsets[tile] < job.marks->offsets[tile + 1];
}

void draw_marks(const TileJob& job, std::size_t tile, TileScratch& scratch) { MarkTile(job, tile, scratch).run(); }

}  // namespace rakelight::raster
