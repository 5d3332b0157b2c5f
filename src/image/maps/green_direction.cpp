// SPDX-License-Identifier: Apache-2.0
#include "image/maps/green_direction.h"

#include <algorithm>
#include <vector>

namespace rakelight {
namespace {

constexpr int parts_a_side = 8, min_side = 32, max_window = 36;
constexpr double min_relief = 4e-4;  ///< per texel; smaller differences are rounding
constexpr double min_agreement = 0.25;

/// Slopes of the height along u and upwards, [height][width].
struct Slopes {
    int width = 0, height = 0;
    std::vector<double> p, q;

    std::size_t at(int x, int y) const { return std::size_t(y) * std::size_t(width) + std::size_t(x); }
};

void add_slope(std::uint32_t texel, Slopes& to) {
    const auto decoded = [texel](int shift) { return 2.0 * double(texel >> shift & 255u) / 255 - 1; };
    const double z = std::max(decoded(16), 0.1);
    to.p.push_back(-decoded(0) / z);
    to.q.push_back(-decoded(8) / z);
}

/// Means of 2 x 2.
Slopes halved(const Slopes& s) {
    Slopes out{s.width / 2, s.height / 2, {}, {}};
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            const std::size_t i = s.at(2 * x, 2 * y), below = s.at(2 * x, 2 * y + 1);
            out.p.push_back((s.p[i] + s.p[i + 1] + s.p[below] + s.p[below + 1]) / 4);
            out.q.push_back((s.q[i] + s.q[i + 1] + s.q[below] + s.q[below + 1]) / 4);
        }
    return out;
}

struct Sums {
    double products = 0, squares = 0;
    std::size_t texels = 0;

    void operator+=(const Sums& s) {
        products += s.products;
        squares += s.squares;
        texels += s.texels;
    }
    bool has_relief() const { return squares > min_relief * double(texels); }
    double agreement() const { return has_relief() ? 2 * products / squares : 0; }
};

Sums sums_of(const Slopes& s) {
    Sums sums;
    for (int y = 1; y + 1 < s.height; ++y)
        for (int x = 1; x + 1 < s.width; ++x) {
            const double p_up = s.p[s.at(x, y - 1)] - s.p[s.at(x, y + 1)];
            const double q_right = s.q[s.at(x + 1, y)] - s.q[s.at(x - 1, y)];
            sums.products += p_up * q_right;
            sums.squares += p_up * p_up + q_right * q_right;
            ++sums.texels;
        }
    return sums;
}

/// The middle of a part, up to `max_window` texels wide.
struct Range {
    int first, count;
};
Range middle_of(int part, int size) {
    const int begin = part * size / parts_a_side, end = (part + 1) * size / parts_a_side;
    // A texel of the neighbors on each side, so that parts of few texels have some to compare.
    const int from = std::max(begin - 1, 0), to = std::min(end + 1, size), count = std::min(to - from, max_window);
    return {from + (to - from - count) / 2, count};
}

}  // namespace

GreenDirection find_green_direction(std::span<const std::uint32_t> texels, int width, int height, int stride) {
    GreenDirection out;
    if (width < min_side || height < min_side) return out;
    Sums fine, coarse;
    for (int i = 0; i < parts_a_side * parts_a_side; ++i) {
        const Range columns = middle_of(i % parts_a_side, width), rows = middle_of(i / parts_a_side, height);
        Slopes slopes{columns.count, rows.count, {}, {}};
        for (int y = rows.first; y < rows.first + rows.count; ++y)
            for (int x = columns.first; x < columns.first + columns.count; ++x)
                add_slope(texels[std::size_t(y) * std::size_t(stride) + std::size_t(x)], slopes);
        const Sums part = sums_of(slopes);
        fine += part;
        coarse += sums_of(halved(slopes));
        if (!part.has_relief()) continue;
        ++out.parts;
        out.up += part.agreement() > min_agreement;
        out.down += part.agreement() < -min_agreement;
    }
    out.fine = fine.agreement();
    out.coarse = coarse.agreement();
    return out;
}

}  // namespace rakelight
