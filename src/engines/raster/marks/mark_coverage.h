// SPDX-License-Identifier: Apache-2.0
// How much of a pixel a line or point covers, by the distance of the pixel's center.
#pragma once
#include <algorithm>
#include <cmath>

#include "engines/raster/marks/marks.h"

namespace rakelight::raster {

/// How much of a pixel lies on the inner side of a straight border that passes `inside` px from its center; n is the
/// border's unit normal. The area as a function of `inside` is the integral of two boxes of |n.x| and |n.y| folded.
inline double half_plane(double inside, dvec2 n) {
    const double a = std::fabs(n.x), b = std::fabs(n.y), longer = std::max(a, b), shorter = std::min(a, b);
    const double end = 0.5 * (longer + shorter), flat = 0.5 * (longer - shorter), x = std::fabs(inside);
    const double outer = x >= end ? 0.0 : x <= flat ? 0.5 - x / longer : (end - x) * (end - x) / (2 * longer * shorter);
    return inside < 0 ? outer : 1 - outer;
}

/// How much of a pixel a strip covers whose middle is `d` px from its center, half as wide as `half`.
/// @param across  the strip's unit normal where d is 0
inline double strip_coverage(dvec2 d, double distance, dvec2 across, double half) {
    if (distance + half_diagonal <= half) return 1;
    const dvec2 n = distance > 1e-9 ? dvec2{d.x / distance, d.y / distance} : across;
    const double near_border = half_plane(half - distance, n);
    if (distance + half >= half_diagonal) return near_border;
    return std::max(0.0, near_border - half_plane(-half - distance, n));
}

inline double square_coverage(dvec2 d, double half) {
    return strip_coverage({d.x, 0}, std::fabs(d.x), {1, 0}, half) *
           strip_coverage({0, d.y}, std::fabs(d.y), {0, 1}, half);
}

/// A mark prepared for coverage tests of pixels.
class MarkShape {
public:
    /// @param size  [px] the line's width, the point's diameter or side
    MarkShape(const Mark& m, float size)
        : shape_(m.shape),
          x_(double(m.x[0])),
          y_(double(m.y[0])),
          dx_(double(m.x[1]) - x_),
          dy_(double(m.y[1]) - y_),
          half_(0.5 * double(size)),
          reach_(mark_reach(size)) {
        const double square = dx_ * dx_ + dy_ * dy_, length = std::sqrt(square);
        if (square > 0) scale_ = 1 / square, across_ = {-dy_ / length, dx_ / length};
        left_ = std::floor(std::min(x_, x_ + dx_) - reach_), right_ = std::ceil(std::max(x_, x_ + dx_) + reach_);
        top_ = std::floor(std::min(y_, y_ + dy_) - reach_), bottom_ = std::ceil(std::max(y_, y_ + dy_) + reach_);
    }

    /// Rows and columns of the picture, of an area, where pixels may be covered; inclusive.
    struct Span {
        int first, last;
    };
    Span rows(const Window& area) const { return clip(top_, bottom_, area.y, area.height); }
    /// Of a line those as near to its carrier as it reaches, of a disc those as near to its center.
    Span columns(int row, const Window& area) const {
        double left = left_, right = right_;
        if (std::fabs(across_.x) > 1e-6 && scale_ > 0) {
            const double middle = x_ - 0.5 - across_.y / across_.x * (row + 0.5 - y_);
            const double side = reach_ / std::fabs(across_.x) + 1e-6;
            left = std::max(left, std::ceil(middle - side)), right = std::min(right, std::floor(middle + side));
        }
        if (shape_ == Mark::Shape::disc) {
            const double down = row + 0.5 - y_, square = reach_ * reach_ - down * down;
            const double side = square > 0 ? std::sqrt(square) + 1e-6 : 1e-6;
            left = std::max(left, std::ceil(x_ - 0.5 - side)), right = std::min(right, std::floor(x_ - 0.5 + side));
        }
        return clip(left, right, area.x, area.width);
    }

    /// Where the mark is nearest to a pixel's center.
    struct Near {
        double t;  ///< 0..1 along the line
        dvec2 d;   ///< [px] from there to the center
    };
    Near nearest(int x, int y) const {
        const double px = x + 0.5 - x_, py = y + 0.5 - y_;
        const double t = std::min(std::max((px * dx_ + py * dy_) * scale_, 0.0), 1.0);
        return {t, {px - t * dx_, py - t * dy_}};
    }
    /// A quick test: true if nothing is covered. Squares are always tested fully.
    bool is_out_of_reach(const Near& n) const {
        return shape_ != Mark::Shape::square && n.d.x * n.d.x + n.d.y * n.d.y > reach_ * reach_;
    }
    double coverage(const Near& n) const {
        return shape_ == Mark::Shape::square
                   ? square_coverage(n.d, half_)
                   : strip_coverage(n.d, std::sqrt(n.d.x * n.d.x + n.d.y * n.d.y), across_, half_);
    }
    /// Whether a pixel's center lies in the mark; in one thinner than a pixel, as if it were one pixel wide.
    bool has_center(const Near& n) const {
        const double half = std::max(half_, 0.5), x = std::fabs(n.d.x), y = std::fabs(n.d.y);
        return shape_ == Mark::Shape::square ? std::max(x, y) <= half : x * x + y * y <= half * half;
    }
    /// Whether a point covers the whole pixel, up to rounding.
    bool fills(const Near& n) const {
        const double x = std::fabs(n.d.x), y = std::fabs(n.d.y);
        return shape_ == Mark::Shape::square ? std::max(x, y) + 0.5 <= half_
                                             : std::sqrt(x * x + y * y) + half_diagonal <= half_;
    }
    /// How far a point's paraboloid has sunk there, in radii: 1 at the border.
    double sunk(const Near& n) const { return (n.d.x * n.d.x + n.d.y * n.d.y) / (half_ * half_); }
    double reach() const { return reach_; }

private:
    static Span clip(double first, double last, int begin, int count) {
        const double low = begin, high = begin + count;
        return {int(std::min(std::max(first, low), high)), int(std::max(std::min(last, high - 1), low - 1))};
    }

    Mark::Shape shape_;
    double x_, y_, dx_, dy_, half_, reach_;
    double scale_ = 0;  ///< 1 / length²; 0 for points
    dvec2 across_{1, 0};
    double left_, right_, top_, bottom_;
};

}  // namespace rakelight::raster
