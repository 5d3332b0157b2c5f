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
RL_INLINE Neighbor neighbor_of(const double* row, const Axes& axes, numbers is_one) {
    const Three d{load(row), load(row + height_lanes), load(row + 2 * height_lanes)};
    const numbers x = dot(d, axes.t), y = dot(d, axes.b), z = dot(d, axes.n), rr = x * x + y * y, zz = z * z;
    const numbers c = smaller((rr + zz) / larger(rr, all(1e-12)), all(4));
    return {x, y, z, is_one, c};
}
RL_INLINE numbers counts_of(const HeightJob& job, uint32_t lane) {
    numbers v;
    for (uint32_t i = 0; i < lanes; ++i) v[i] = double(job.count[lane + i]);
    return v;
}
/// 1 for lanes that have the neighbor, else 0.
RL_INLINE numbers ones(numbers counts, uint32_t row) { return all(double(row)) < counts ? all(1) : all(0); }

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
    const numbers counts = counts_of(job, first_lane);
    Neighbor some[most];
    for (uint32_t row = 0; row < job.rows; row += most) {
        const uint32_t end = job.rows - row < most ? job.rows - row : most;
        for (uint32_t i = 0; i < end; ++i) {
            Neighbor& p = some[i];
            p = neighbor_of(job.neighbors + uint64_t(row + i) * 3 * height_lanes + first_lane, axes,
                            ones(counts, row + i));
            const numbers square = p.x * p.x + p.y * p.y + p.z * p.z + all(1e-12);
            p.w = p.w / (square * square);
        }
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

constexpr double little_slope = 1e-7, little = 1e-9;  ///< added to the diagonal, which is scaled to 1

/// Equations with their diagonal scaled to 1, a little added, and factored after Cholesky.
template <uint32_t K>
struct Factored {
    numbers l[K][K];         ///< lower half; on the diagonal the reciprocal
    numbers scale[K], y[K];  ///< y: the factor's solution for the vector
    numbers more[K];         ///< what was added to the diagonal
};
template <uint32_t K>
RL_INLINE void factor(const Equations<K>& e, numbers weight, Factored<K>& f) {
    for (uint32_t i = 0; i < K; ++i) {
        f.scale[i] = all(1) / square_root(e.a[i][i] + all(1e-300));
        f.more[i] = all(i < 2 ? little_slope : little) + smaller(all(1e-12) * weight * f.scale[i] * f.scale[i], all(1));
    }
    for (uint32_t i = 0; i < K; ++i) {
        numbers y = e.r[i] * f.scale[i];
        for (uint32_t j = 0; j <= i; ++j) {
            numbers s = e.a[i][j] * f.scale[i] * f.scale[j];
            if (i == j) s += f.more[i];
            for (uint32_t k = 0; k < j; ++k) s -= f.l[i][k] * f.l[j][k];
            f.l[i][j] = i == j ? all(1) / square_root(larger(s, all(1e-14))) : s * f.l[j][j];
            if (j < i) y -= f.l[i][j] * f.y[j];
        }
        f.y[i] = y * f.l[i][i];
    }
}

/// The first `used` equations' solution, still scaled.
template <uint32_t K>
RL_INLINE void solve(const Factored<K>& f, uint32_t used, numbers (&x)[K]) {
    for (uint32_t i = used; i-- > 0;) {
        numbers s = f.y[i];
        for (uint32_t k = i + 1; k < used; ++k) s -= f.l[k][i] * x[k];
        x[i] = s * f.l[i][i];
    }
}

/// The variance of the slope, as the trace of its block in the inverse of the first five equations' matrix and of all.
template <uint32_t K>
RL_INLINE void variances(const Factored<K>& f, numbers& of_five, numbers& of_all) {
    of_five = of_all = all(0);
    for (uint32_t c = 0; c < 2; ++c) {  // a column of the factor's inverse
        numbers x[K], squares = all(0);
        for (uint32_t i = c; i < K; ++i) {
            numbers s = all(i == c ? 1.0 : 0.0);
            for (uint32_t k = c; k < i; ++k) s -= f.l[i][k] * x[k];
            x[i] = s * f.l[i][i];
            squares += x[i] * x[i];
            if (i == 4) of_five += squares * f.scale[c] * f.scale[c];
        }
        of_all += squares * f.scale[c] * f.scale[c];
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
    numbers x[K], left = s.heights, most = all(0);
    solve(f, used, x);
    for (uint32_t i = 0; i < used; ++i) {
        left -= f.y[i] * f.y[i] + f.more[i] * x[i] * x[i];
        most = larger(most, f.more[i]);
    }
    const numbers a = x[0] * f.scale[0], b = x[1] * f.scale[1];
    const numbers bent =
        s.heights - all(2) * (a * s.xz + b * s.yz) + a * a * s.xx + all(2) * a * b * s.xy + b * b * s.yy;
    store(out.residual + lane, larger(left, all(0)));
    store(out.bent + lane, larger(bent, all(0)));
    store(out.certainty + lane, most > all(0.01) ? all(0) : variance_of_plane(s) / variance);
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
    const numbers counts = counts_of(job, lane);
    numbers x = all(0), y = all(0), z = all(0), cxx = all(0), cxy = all(0), cyy = all(0);
    for (uint32_t row = 0; row < job.rows; ++row) {
        const Neighbor p =
            neighbor_of(job.neighbors + uint64_t(row) * 3 * height_lanes + lane, axes, ones(counts, row));
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
                n = turned(axes, x[0] * f.scale[0], x[1] * f.scale[1]);
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
