// SPDX-License-Identifier: Apache-2.0
// The sphere of directions in bins, fine about an axis: quadrature over it, and histograms held against densities.
#pragma once
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "unit/lighting/furnace.h"
#include "unit/lighting/path_surfaces.h"

namespace rakelight::lighting_test {

struct Vector {
    double x = 0, y = 0, z = 0;
};
inline Vector to_double(vec3 a) { return {double(a.x), double(a.y), double(a.z)}; }
inline Vector sum_of(Vector a, double s, Vector b) { return {a.x + s * b.x, a.y + s * b.y, a.z + s * b.z}; }
inline double dot_of(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector scaled(Vector a, double s) { return {a.x * s, a.y * s, a.z * s}; }
inline Vector unit_of(Vector a) { return scaled(a, 1 / std::sqrt(dot_of(a, a))); }
inline Vector cross_of(Vector a, Vector b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// v turned by half a turn about n.
inline Vector mirrored(Vector n, Vector v) { return sum_of(scaled(n, 2 * dot_of(n, v)), -1, v); }

/// Rings about an axis, even in q of tan(angle / 2) = width q / (1 - q), and sectors.
class SphereBins {
public:
    static constexpr int rings = 20, sectors = 24;

    SphereBins(const Item& seen, Division division, double width) : division_(division), width_(width) {
        v_ = unit_of(to_double(seen.v));
        n_ = unit_of(to_double(seen.n));
        const Vector middle = division == Division::by_halfway ? n_ : mirrored(n_, v_);
        const Vector aside = unit_of(cross_of(middle, {0.1, 0.9, 0.4}));
        axis_ =
            unit_of(sum_of(middle, 0.3 * width, aside));  // so that no edge of a density runs along those of the bins
        t_ = unit_of(cross_of(axis_, {0.9, 0.1, -0.4}));
        b_ = cross_of(axis_, t_);
    }

    std::size_t count() const { return std::size_t(rings) * sectors; }

    std::size_t bin_of(vec3 direction) const {
        Vector d = to_double(direction);
        if (division_ == Division::by_halfway) {
            d = sum_of(d, 1, v_);
            d = scaled(d, dot_of(d, n_) < 0 ? -1 : 1);
        }
        d = unit_of(d);
        const double c = dot_of(d, axis_), x = dot_of(d, t_), y = dot_of(d, b_);
        const double tangent = std::hypot(x, y) / std::max(1 + c, 1e-12), q = tangent / (tangent + width_);
        const double turn = std::atan2(y, x) / (2 * pi_d);
        const int ring = std::clamp(int(q * rings), 0, rings - 1);
        const int sector = std::clamp(int((turn - std::floor(turn)) * sectors), 0, sectors - 1);
        return std::size_t(ring * sectors + sector);
    }

    /// A point in each cell of a grid finer by `finer` both ways, with the solid angle that it stands for, bin after bin. Not
    /// in the middle of the cells: edges of a density that run along theirs would be missed or met by all.
    Outgoing points(int finer) const {
        Outgoing out;
        Random random;
        for (int ring = 0; ring < rings; ++ring)
            for (int sector = 0; sector < sectors; ++sector)
                for (int i = 0; i < finer * finer; ++i)
                    add_point(out, (ring + (i / finer + within_cell(random)) / finer) / rings,
                              (sector + (i % finer + within_cell(random)) / finer) / sectors, 1.0 / (finer * finer));
        return out;
    }

private:
    static double within_cell(Random& random) { return double(random.unit()) + 1e-8; }  // not at the axis

    void add_point(Outgoing& out, double q, double turn, double share) const {
        const double x = width_ * q / (1 - q), angle = 2 * pi_d * turn;
        const double c = (1 - x * x) / (1 + x * x), s = 2 * x / (1 + x * x);
        const double d_angle = 2 / (1 + x * x) * width_ / ((1 - q) * (1 - q)) / rings;
        double solid_angle = s * d_angle * 2 * pi_d / sectors * share;
        Vector d = sum_of(sum_of(scaled(axis_, c), s * std::cos(angle), t_), s * std::sin(angle), b_);
        if (division_ == Division::by_halfway) {
            solid_angle *= dot_of(d, n_) < 0 ? 0 : 4 * std::abs(dot_of(v_, d));
            d = mirrored(d, v_);
        }
        out.v.push_back({d.x, d.y, d.z});
        out.solid_angle.push_back(solid_angle);
    }

    Division division_;
    double width_;
    Vector v_, n_, axis_, t_, b_;
};

/// The kernel of the widest instruction set that is there: all give the same bits.
inline const Kernel& fastest_kernel() {
    static const Kernel fastest = RL_BY_ISA(best_isa(), kernel);
    return fastest;
}

/// Columns of Kernel::paths.
inline constexpr std::size_t sampled_l = 0, sampled_pdf = 3, sampled_share = 4, pdf_of_l = 7, share_of_l = 8,
                             lobe_share = 11;

inline Results paths(const Kernel& kernel, Items& items, const PathSurface& surface) {
    const Inputs in = items.inputs();
    Results results(16, in.count);
    kernel.paths(in, surface, results.out());
    return results;
}

/// @return  items that see the same, with random numbers of their own
inline Items random_draws(const Item& seen, int count) {
    Random random;
    Items items;
    Item item = seen;
    for (int i = 0; i < count; ++i) {
        item.e = random.unit(), item.s = random.unit(), item.t = random.unit();
        items.push(item);
    }
    return items;
}

inline Items items_from(const Item& seen, const Outgoing& out) {
    Items items;
    Item item = seen;
    for (const Direction& l : out.v) {
        item.l = to_float(l);
        items.push(item);
    }
    return items;
}

/// Probability that a sum of squares as great or greater comes by chance: Wilson & Hilferty 1931, "The Distribution of
/// Chi-Square".
inline double chance_of(double chi_square, double freedom) {
    const double spread = 2 / (9 * freedom);
    return 0.5 * std::erfc((std::cbrt(chi_square / freedom) - (1 - spread)) / std::sqrt(2 * spread));
}

/// Pearson's test of counts against probabilities; neighbors are joined until 10 are expected.
inline double chance_of_counts(const std::vector<double>& probabilities, const std::vector<int>& counts, int draws) {
    struct Cell {
        double expected = 0, counted = 0;
    };
    std::vector<Cell> cells(1);
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (cells.back().expected >= 10) cells.emplace_back();
        cells.back().expected += probabilities[i] * draws, cells.back().counted += counts[i];
    }
    if (cells.back().expected < 10 && cells.size() > 1) {
        const Cell rest = cells.back();
        cells.pop_back();
        cells.back().expected += rest.expected, cells.back().counted += rest.counted;
    }
    double chi_square = 0;
    for (const Cell& cell : cells)
        chi_square += (cell.counted - cell.expected) * (cell.counted - cell.expected) / cell.expected;
    return chance_of(chi_square, std::max(double(cells.size()) - 1, 1.0));
}

}  // namespace rakelight::lighting_test
