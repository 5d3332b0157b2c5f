// SPDX-License-Identifier: Apache-2.0
// Height functions fitted to the neighbors of several places at a time, in double, per instruction set. The normal equations
// of the terms x, y, c x^2, c x y, c y^2 and the cubic ones: many of their sums are equal, and each is computed once. The
// quadric's equations are the first five of the cubic's, and so is its factor.
#include "geometry/fits/height_kernel_types.h"
#include "geometry/kernels/double_lanes.h"

namespace rakelight::geometry::RL_ISA {

RL_INLINE numbers load(const double* from) {
    numbers v;
    __builtin_memcpy(&v, from, sizeof v);
    return v;
}
RL_INLINE void store(double* to, numbers v) { __builtin_memcpy(to, &v, sizeof v); }
RL_INLINE numbers larger(numbers a, numbers b) { return a > b ? a : b; }
RL_INLINE numbers smaller(numbers a, numbers b) { return a < b ? a : b; }

RL_INLINE Three unit_or(const Three& v, const Three& otherwise) {
    const numbers square = dot(v, v), scale = all(1) / square_root(square);
    const bits good = (square > all(1e-280)) & (square < all(1e280));
    return {good ? v.x * scale : otherwise.x, good ? v.y * scale : otherwise.y, good ? v.z * scale : otherwise.z};
}

struct Axes {
    Three t, b, n;
};
RL_INLINE Axes axes_of(const Three& n) {
    const bits along_x = ~((n.x < all(0.8)) & (n.x > all(-0.8)));
    const numbers zero = all(0), one = all(1);
    const Three other{along_x ? zero : one, along_x ? one : zero, zero};
    const Three t = unit_or(cross(n, other), {zero, zero, one});
    return {t, cross(n, t), n};
}

/// A neighbor in the axes: its place, its weight, and the factor of its quadratic terms.
struct Neighbor {
    numbers x, y, z, w, c;
};
/// The neighbors of several places in their axes.
struct Neighbors {
    const double* first;
    Axes axes;
    numbers counts, scale;

    Neighbors(const HeightJob& job, uint32_t lane, const Axes& of)
        : first(job.neighbors + lane), axes(of), scale(load(job.scale + lane)) {
        for (uint32_t i = 0; i < lanes; ++i) counts[i] = double(job.count[lane + i]);
    }
};
/// Lanes that have no such neighbor, or a very far one, have weight 0.
/// @param is_near  others weigh by the inverse fourth power of their distance
RL_INLINE Neighbor neighbor_of(const Neighbors& n, uint32_t row, bool is_near) {
    const double* const from = n.first + uint64_t(row) * 3 * height_lanes;
    Three d{load(from) * n.scale, load(from + height_lanes) * n.scale, load(from + 2 * height_lanes) * n.scale};
    const bits is_here = (all(double(row)) < n.counts) & (dot(d, d) < all(1e20));
    const numbers zero = all(0), weight = is_here ? all(1) : zero;
    d = {is_here ? d.x : zero, is_here ? d.y : zero, is_here ? d.z : zero};
    const numbers x = dot(d, n.axes.t), y = dot(d, n.axes.b), z = dot(d, n.axes.n);
    const numbers rr = x * x + y * y, square = rr + z * z, across = larger(rr, all(1e-12));
    if (!is_near) return {x, y, z, weight, smaller(square / across, all(4))};
    const numbers more = square + all(1e-12), fourth = more * more, both = all(1) / (across * fourth);
    return {x, y, z, weight * (across * both), smaller(square * (fourth * both), all(4))};
}

/// What a quadric through the place needs: sums over neighbors of weight times the product.
struct QuadricSums {
    numbers weight, heights, xx, xy, yy, xz, yz;
    numbers cz[3];  ///< c z x^2, c z x y, c z y^2
    numbers c3[4];  ///< c x^3 ... c y^3
    numbers c4[5];  ///< c^2 x^4 ... c^2 y^4
};
/// What a cubic needs besides.
struct CubicSums {
    numbers p4[5], c5[6], p6[7], z3[4];  ///< x^4 ..., c x^5 ..., x^6 ..., z x^3 ...
};

RL_INLINE void add(QuadricSums& s, const Neighbor& p) {
    const numbers wx = p.w * p.x, wy = p.w * p.y, wz = p.w * p.z, xx = p.x * p.x, xy = p.x * p.y, yy = p.y * p.y;
    s.weight += p.w, s.heights += wz * p.z;
    s.xx += wx * p.x, s.xy += wx * p.y, s.yy += wy * p.y, s.xz += wz * p.x, s.yz += wz * p.y;
    const numbers cxx = p.c * xx, cxy = p.c * xy, cyy = p.c * yy;
    s.cz[0] += wz * cxx, s.cz[1] += wz * cxy, s.cz[2] += wz * cyy;
    s.c3[0] += wx * cxx, s.c3[1] += wx * cxy, s.c3[2] += wx * cyy, s.c3[3] += wy * cyy;
    const numbers wxx = p.w * cxx, wxy = p.w * cxy, wyy = p.w * cyy;
    s.c4[0] += wxx * cxx, s.c4[1] += wxx * cxy, s.c4[2] += wxx * cyy, s.c4[3] += wxy * cyy, s.c4[4] += wyy * cyy;
}
RL_INLINE void add(CubicSums& s, const Neighbor& p) {
    const numbers xx = p.x * p.x, yy = p.y * p.y, xxx = xx * p.x, xxy = xx * p.y, xyy = p.x * yy, yyy = yy * p.y;
    const numbers a = p.w * xxx, b = p.w * xxy, c = p.w * xyy, d = p.w * yyy;
    s.z3[0] += a * p.z, s.z3[1] += b * p.z, s.z3[2] += c * p.z, s.z3[3] += d * p.z;
    s.p4[0] += a * p.x, s.p4[1] += a * p.y, s.p4[2] += b * p.y, s.p4[3] += c * p.y, s.p4[4] += d * p.y;
    s.p6[0] += a * xxx, s.p6[1] += a * xxy, s.p6[2] += a * xyy, s.p6[3] += a * yyy, s.p6[4] += b * yyy;
    s.p6[5] += c * yyy, s.p6[6] += d * yyy;
    const numbers cxx = p.c * xx, cyy = p.c * yy;
    s.c5[0] += a * cxx, s.c5[1] += b * cxx, s.c5[2] += c * cxx, s.c5[3] += d * cxx, s.c5[4] += c * cyy;
    s.c5[5] += d * cyy;
}

/// Adds the sums over all neighbors, in rounds of which each keeps its sums in registers.
static void add_up(const HeightJob& job, uint32_t first_lane, const Axes& axes, QuadricSums& quadric,
                   CubicSums& cubic) {
    constexpr uint32_t most = 32;
    const Neighbors neighbors(job, first_lane, axes);
    Neighbor some[most];
    for (uint32_t row = 0; row < job.rows; row += most) {
        const uint32_t end = job.rows - row < most ? job.rows - row : most;
        for (uint32_t i = 0; i < end; ++i) some[i] = neighbor_of(neighbors, row + i, true);
        QuadricSums q = quadric;
        for (uint32_t i = 0; i < end; ++i) add(q, some[i]);
        quadric = q;
        CubicSums c = cubic;
        for (uint32_t i = 0; i < end; ++i) add(c, some[i]);
        cubic = c;
    }
}

/// A symmetric matrix, of which the lower half is used, and a vector.
template <uint32_t K>
struct Equations {
    numbers a[K][K], r[K];
};

RL_INLINE void fill(Equations<9>& e, const QuadricSums& s, const CubicSums& c) {
    e.a[0][0] = s.xx, e.a[1][0] = s.xy, e.a[1][1] = s.yy;
    for (uint32_t i = 0; i < 3; ++i) {
        for (uint32_t j = 0; j < 2; ++j) e.a[2 + i][j] = s.c3[i + j];
        for (uint32_t j = 0; j <= i; ++j) e.a[2 + i][2 + j] = s.c4[i + j];
        e.r[2 + i] = s.cz[i];
    }
    e.r[0] = s.xz, e.r[1] = s.yz;
    for (uint32_t i = 0; i < 4; ++i) {
        for (uint32_t j = 0; j < 2; ++j) e.a[5 + i][j] = c.p4[i + j];
        for (uint32_t j = 0; j < 3; ++j) e.a[5 + i][2 + j] = c.c5[i + j];
        for (uint32_t j = 0; j <= i; ++j) e.a[5 + i][5 + j] = c.p6[i + j];
        e.r[5 + i] = c.z3[i];
    }
}

constexpr double little_slope = 1e-7, little = 1e-9;  ///< ridges, in parts of the diagonal

/// Equations whose diagonal has a ridge added, factored into L D L^T without square roots.
template <uint32_t K>
struct Factored {
    numbers l[K][K];   ///< below the diagonal; on it the reciprocal of D
    numbers y[K];      ///< L's solution for the vector
    numbers ridge[K];  ///< what was added to the diagonal
    bits is_weak[K];   ///< whether it was added to this or an earlier row by more than a little
};
template <uint32_t K>
RL_INLINE void factor(const Equations<K>& e, numbers weight, Factored<K>& f) {
    const numbers least = all(1e-12) * weight + all(1e-280);
#pragma GCC unroll 9
    for (uint32_t i = 0; i < K; ++i) {
        f.ridge[i] = all(i < 2 ? little_slope : little) * e.a[i][i] + least;
        f.is_weak[i] = f.ridge[i] > all(0.01) * e.a[i][i];
        if (i > 0) f.is_weak[i] |= f.is_weak[i - 1];
        numbers m[K], y = e.r[i], d = e.a[i][i] + f.ridge[i];
#pragma GCC unroll 9
        for (uint32_t j = 0; j < i; ++j) {
            m[j] = e.a[i][j];
#pragma GCC unroll 9
            for (uint32_t k = 0; k < j; ++k) m[j] -= m[k] * f.l[j][k];
            f.l[i][j] = m[j] * f.l[j][j];
            y -= f.l[i][j] * f.y[j];
            d -= m[j] * f.l[i][j];
        }
        f.l[i][i] = all(1) / larger(d, all(1e-14) * e.a[i][i] + least);
        f.y[i] = y;
    }
}

/// The first `used` equations' solution.
template <uint32_t K>
RL_INLINE void solve(const Factored<K>& f, uint32_t used, numbers (&x)[K]) {
#pragma GCC unroll 9
    for (uint32_t n = 0; n < used; ++n) {
        const uint32_t i = used - 1 - n;
        x[i] = f.y[i] * f.l[i][i];
#pragma GCC unroll 9
        for (uint32_t k = i + 1; k < used; ++k) x[i] -= f.l[k][i] * x[k];
    }
}

/// The variance of the slope, as the trace of its block in the inverse of the first five equations' matrix and of all.
template <uint32_t K>
RL_INLINE void variances(const Factored<K>& f, numbers& of_five, numbers& of_all) {
    of_five = of_all = all(0);
#pragma GCC unroll 9
    for (uint32_t c = 0; c < 2; ++c) {  // a column of L's inverse
        numbers x[K];
#pragma GCC unroll 9
        for (uint32_t i = c; i < K; ++i) {
            x[i] = all(i == c ? 1.0 : 0.0);
#pragma GCC unroll 9
            for (uint32_t k = c; k < i; ++k) x[i] -= f.l[i][k] * x[k];
            const numbers part = x[i] * x[i] * f.l[i][i];
            if (i < 5) of_five += part;
            of_all += part;
        }
    }
}
/// The same if a plane were fitted.
RL_INLINE numbers variance_of_plane(const QuadricSums& s) {
    return (s.xx + s.yy) / larger(s.xx * s.yy - s.xy * s.xy, all(1e-12) * (s.xx * s.yy + all(1e-280)));
}

RL_INLINE Three turned(const Axes& axes, numbers along_t, numbers along_b) {
    const Three& n = axes.n;
    return unit_or({n.x - axes.t.x * along_t - axes.b.x * along_b, n.y - axes.t.y * along_t - axes.b.y * along_b,
                    n.z - axes.t.z * along_t - axes.b.z * along_b},
                   n);
}
RL_INLINE void store(double (&to)[3][height_lanes], uint32_t lane, const Three& v) {
    store(to[0] + lane, v.x), store(to[1] + lane, v.y), store(to[2] + lane, v.z);
}

/// @param used      5: the quadric, K: all
/// @param variance  of the slope, by them
template <uint32_t K>
RL_INLINE void conclude(const Factored<K>& f, uint32_t used, numbers variance, const Axes& axes, const QuadricSums& s,
                        uint32_t lane, HeightNumbers& out) {
    numbers x[K], left = s.heights;
    solve(f, used, x);
#pragma GCC unroll 9
    for (uint32_t i = 0; i < used; ++i) left -= f.y[i] * f.y[i] * f.l[i][i] + f.ridge[i] * x[i] * x[i];
    const numbers a = x[0], b = x[1];
    const numbers bent =
        s.heights - all(2) * (a * s.xz + b * s.yz) + a * a * s.xx + all(2) * a * b * s.xy + b * b * s.yy;
    store(out.residual + lane, larger(left, all(0)));
    store(out.bent + lane, larger(bent, all(0)));
    store(out.certainty + lane, f.is_weak[used - 1] ? all(0) : variance_of_plane(s) / variance);
    store(out.normal, lane, turned(axes, a, b));
}

RL_INLINE Three normal_of(const HeightJob& job, uint32_t lane) {
    return {load(job.normal[0] + lane), load(job.normal[1] + lane), load(job.normal[2] + lane)};
}

static void fit(const HeightJob& job, HeightResult& out) {
    for (uint32_t lane = 0; lane < height_lanes; lane += lanes) {
        const Axes axes = axes_of(normal_of(job, lane));
        QuadricSums quadric{};
        CubicSums cubic{};
        add_up(job, lane, axes, quadric, cubic);
        Equations<9> e;
        fill(e, quadric, cubic);
        Factored<9> f;
        factor(e, quadric.weight, f);
        numbers five, nine;
        variances(f, five, nine);
        store(out.weight + lane, quadric.weight);
        conclude(f, 5, five, axes, quadric, lane, out.quadric);
        conclude(f, 9, nine, axes, quadric, lane, out.cubic);
    }
}

/// The sums of a quadric that need not meet the place; the place itself is one more neighbor.
RL_INLINE Equations<6> wide_equations(const HeightJob& job, uint32_t lane, const Axes& axes, QuadricSums& s) {
    const Neighbors neighbors(job, lane, axes);
    numbers x = all(0), y = all(0), z = all(0), cxx = all(0), cxy = all(0), cyy = all(0);
    for (uint32_t row = 0; row < job.rows; ++row) {
        const Neighbor p = neighbor_of(neighbors, row, false);
        add(s, p);
        x += p.w * p.x, y += p.w * p.y, z += p.w * p.z;
        const numbers wc = p.w * p.c;
        cxx += wc * p.x * p.x, cxy += wc * p.x * p.y, cyy += wc * p.y * p.y;
    }
    Equations<6> e;
    e.a[0][0] = s.xx, e.a[1][0] = s.xy, e.a[1][1] = s.yy, e.r[0] = s.xz, e.r[1] = s.yz;
    for (uint32_t i = 0; i < 3; ++i) {
        for (uint32_t j = 0; j < 2; ++j) e.a[2 + i][j] = s.c3[i + j];
        for (uint32_t j = 0; j <= i; ++j) e.a[2 + i][2 + j] = s.c4[i + j];
        e.r[2 + i] = s.cz[i];
    }
    e.a[5][0] = x, e.a[5][1] = y, e.a[5][2] = cxx, e.a[5][3] = cxy, e.a[5][4] = cyy, e.r[5] = z;
    e.a[5][5] = s.weight + all(1);
    return e;
}

static void wide(const HeightJob& job, HeightNumbers& out, double (&weight)[height_lanes]) {
    constexpr int rounds = 3;  // more gain nothing
    for (uint32_t lane = 0; lane < height_lanes; lane += lanes) {
        Three n = normal_of(job, lane);
        for (int round = 0; round < rounds; ++round) {
            const Axes axes = axes_of(n);
            QuadricSums s{};
            const Equations<6> e = wide_equations(job, lane, axes, s);
            Factored<6> f;
            factor(e, s.weight, f);
            if (round + 1 < rounds) {
                numbers x[6];
                solve(f, 6, x);
                n = turned(axes, x[0], x[1]);
                continue;
            }
            numbers five, six;
            variances(f, five, six);
            conclude(f, 6, six, axes, s, lane, out);
            store(weight + lane, s.weight);
        }
    }
}

const HeightKernels* height_kernels() {
    static constexpr HeightKernels table = {fit, wide};
    return &table;
}

}  // namespace rakelight::geometry::RL_ISA
