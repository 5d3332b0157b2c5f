// SPDX-License-Identifier: Apache-2.0
// Normals of matched borders by fits over both sides: errors against the normals of known surfaces, before and after.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "unit/geometry/borders/border_shapes.h"

namespace rakelight::test {
namespace {

double degrees_between(dvec3 a, dvec3 b) { return degrees(std::atan2(length(cross(a, b)), dot(a, b))); }

/// A torus cut through its tube: the border is a circle around the tube.
Surface cut_tube() {
    Surface s;
    s.point = [](double u, double v) {
        const double a = 2 * pi * u, b = pi * (2 * v - 1), ring = 1 + 0.4 * std::cos(a);
        return dvec3{ring * std::cos(b), ring * std::sin(b), 0.4 * std::sin(a)};
    };
    s.normal = [p = s.point](double u, double v) { return numeric_normal(p, u, v); };
    return s;
}

struct Case {
    const char* name;
    Surface surface;
    std::uint32_t columns, rows;
};
std::vector<Case> cases() {
    return {{"bumpy sphere", bumpy_sphere(), 24, 6},
            {"torus", torus(), 48, 12},
            {"tube", cut_tube(), 16, 11},
            {"cylinder", cylinder(), 24, 6}};
}

/// Mean angles to the surface's own normals along the border [degrees].
struct Errors {
    double leaders = 0, followers = 0;
    double all = 0;  ///< over the vertices of both sides
};
Errors errors_of(const std::vector<Shape>& shapes, const CutSurface& model, const Cut& cut) {
    Errors out;
    const std::size_t leading = cut.columns + 1, following = std::size_t(cut.columns) * cut.times + 1;
    const auto error = [&](std::size_t half, std::size_t v) {
        return degrees_between(cast<double>(shapes[half].normals[v]), model.truth[half][v]);
    };
    for (std::size_t i = 0; i < leading; ++i) out.leaders += error(0, cut.rows * leading + i);
    for (std::size_t i = 0; i < following; ++i) out.followers += error(1, i);
    out.all = (out.leaders + out.followers) / double(leading + following);
    out.leaders /= double(leading), out.followers /= double(following);
    return out;
}

/// What followers would have if leaders were exact: they interpolate along straight edges [degrees].
double followers_of_exact(const CutSurface& model, const Cut& cut) {
    const Shape &low = model.halves[0], &high = model.halves[1];
    const std::size_t following = std::size_t(cut.columns) * cut.times + 1;
    double sum = 0;
    for (std::size_t i = 0; i < following; ++i) {
        const dvec3 p = cast<double>(high.positions[i]);
        double nearest = INFINITY, error = 0;
        for (std::size_t k = std::size_t(cut.rows) * (cut.columns + 1); k + 1 < low.positions.size(); ++k) {
            const dvec3 a = cast<double>(low.positions[k]), b = cast<double>(low.positions[k + 1]);
            const double t = std::clamp(dot(p - a, b - a) / dot(b - a, b - a), 0.0, 1.0),
                         distance = length(a + (b - a) * t - p);
            if (!(distance < nearest)) continue;
            nearest = distance;
            const dvec3 between = model.truth[0][k] * (1 - t) + model.truth[0][k + 1] * t;
            error = degrees_between(normalize_or(between, {}), model.truth[1][i]);
        }
        sum += error;
    }
    return sum / double(following);
}

std::vector<Shape> smoothed(const std::vector<Shape>& shapes, CornerWeight weight) {
    AttributeOptions options;
    options.weight = weight;
    const std::vector<MeshAttributes> made = compute(shapes, options);
    std::vector<Shape> out;
    for (std::size_t m = 0; m < shapes.size(); ++m) out.push_back(with_attributes(shapes[m], made[m]));
    return out;
}

std::vector<Shape> joined(std::vector<Shape> shapes, const MatchOptions& options, int threads = 2) {
    Context context({.threads = threads});
    MatchReport report;
    const BorderMatch match = match_borders(views(shapes), options, context);
    const std::vector<MeshSeams> turned = join_borders(match, views(shapes), {}, report, context);
    for (std::size_t m = 0; m < shapes.size(); ++m)
        for (std::size_t i = 0; i < turned[m].vertices.size(); ++i)
            shapes[m].normals[turned[m].vertices[i]] = turned[m].normals[i];
    return shapes;
}

double reach_of(const Cut& cut, const CutSurface& model) {
    return std::max(0.05 + cut.gap + 2 * cut.noise, 0.15) * model.edge;
}

/// The normals are those of CornerWeight::automatic.
struct BothWays {
    Errors votes, fits;  ///< votes: the sums of CornerWeight::max, as before there were fits
};
BothWays both_ways(const CutSurface& model, const Cut& cut) {
    const std::vector<Shape> made = smoothed(model.halves, CornerWeight::automatic);
    const double reach = reach_of(cut, model);
    return {errors_of(joined(made, {.distance = reach, .weight = CornerWeight::max}), model, cut),
            errors_of(joined(made, {.distance = reach, .weight = CornerWeight::automatic}), model, cut)};
}

TEST(BorderFits, LeadersAreNearlyExactAndFollowersInterpolateThem) {
    for (const Case& c : cases())
        for (Cut cut : {Cut{.phase = 0.37}, Cut{.phase = 0.5}, Cut{.times = 2}, Cut{.times = 2, .phase = 0.5},
                        Cut{.times = 3, .phase = 0.21}, Cut{.times = 5, .phase = 0.3}}) {
            cut.columns = c.columns, cut.rows = c.rows;
            const CutSurface model = cut_surface(c.surface, cut);
            const BothWays e = both_ways(model, cut);
            const double exact = followers_of_exact(model, cut);
            SCOPED_TRACE(testing::Message() << c.name << " 1:" << cut.times << " phase " << cut.phase << " votes "
                                            << e.votes.leaders << " " << e.votes.followers << " fits " << e.fits.leaders
                                            << " " << e.fits.followers << " exact leaders " << exact);
            EXPECT_LT(e.fits.leaders, std::max(e.votes.leaders * 0.6, 0.02));
            EXPECT_LT(e.fits.all, std::max(e.votes.all, 0.06));
            EXPECT_LT(e.fits.followers, exact + 1.5 * e.fits.leaders + 0.02);
        }
}

TEST(BorderFits, LeadersAreFiveTimesNearerThanVotesByAngles) {
    // On the bumpy sphere, whose one-sided errors do not cancel by symmetry.
    for (const Cut cut :
         {Cut{.phase = 0.37}, Cut{.phase = 0.5}, Cut{.times = 2}, Cut{.times = 2, .phase = 0.5}, Cut{.times = 3},
          Cut{.times = 3, .phase = 0.21}, Cut{.times = 5}, Cut{.times = 5, .phase = 0.3}}) {
        const CutSurface model = cut_surface(bumpy_sphere(), cut);
        const double reach = reach_of(cut, model);
        const Errors by_angles = errors_of(joined(smoothed(model.halves, CornerWeight::angle), {.distance = reach}),
                                           model, cut),
                     fits = both_ways(model, cut).fits;
        EXPECT_LT(fits.leaders, by_angles.leaders / 4.8) << cut.times << " " << cut.phase;
        EXPECT_LT(fits.followers, by_angles.followers / 2.3) << cut.times << " " << cut.phase;
    }
}

TEST(BorderFits, GapsAndNoiseAreNoWorseThanVotes) {
    for (const Case& c : cases())
        for (Cut cut : {Cut{.gap = 0.1}, Cut{.times = 2, .gap = 0.3}, Cut{.times = 5, .gap = 0.2},
                        Cut{.times = 3, .phase = 0.4, .gap = 0.1, .noise = 0.03},
                        Cut{.times = 2, .gap = 0.3, .noise = 0.05}, Cut{.times = 2, .noise = 0.05}}) {
            cut.columns = c.columns, cut.rows = c.rows;
            const BothWays e = both_ways(cut_surface(c.surface, cut), cut);
            EXPECT_LT(e.fits.all, std::max(e.votes.all * 1.1, 0.06))
                << c.name << " 1:" << cut.times << " gap " << cut.gap << " noise " << cut.noise;
        }
}

TEST(BorderFits, PartsThatWereMovedApartAreAboutAsGoodAsVotes) {
    // Their points disagree, which looks like noise: votes count by angles then. Those by Max would be a little better.
    for (const Case& c : cases())
        for (const dvec3 shift : {dvec3{0, 0.1, 0}, dvec3{0, 0.3, 0}, dvec3{0.1, 0, 0}})
            for (Cut cut : {Cut{.phase = 0.37}, Cut{.times = 3, .phase = 0.21}}) {
                cut.columns = c.columns, cut.rows = c.rows;
                CutSurface model = cut_surface(c.surface, cut);
                for (vec3& p : model.halves[1].positions) p = cast<float>(cast<double>(p) + shift * model.edge);
                cut.gap = 0.3;  // for the reach
                const BothWays e = both_ways(model, cut);
                EXPECT_LT(e.fits.all, std::max(e.votes.all * 1.3, 0.25))
                    << c.name << " 1:" << cut.times << " moved by " << shift.x << " " << shift.y;
            }
}

TEST(BorderFits, WithOtherWeightsAndWithAuthoredNormalsNothingIsFitted) {
    const Cut cut{.times = 2, .phase = 0.5};
    const CutSurface model = cut_surface(bumpy_sphere(), cut);
    const std::vector<Shape> made = smoothed(model.halves, CornerWeight::automatic);
    const double reach = reach_of(cut, model);
    const std::vector<Shape> votes = joined(made, {.distance = reach, .weight = CornerWeight::max});
    const std::vector<Shape> authored =
        joined(made, {.distance = reach, .weight = CornerWeight::automatic, .keep_flat = true});
    const std::vector<Shape> fits = joined(made, {.distance = reach, .weight = CornerWeight::fit});
    EXPECT_TRUE(votes[0].normals == authored[0].normals && votes[1].normals == authored[1].normals);
    EXPECT_TRUE(votes[0].normals != fits[0].normals);
}

TEST(BorderFits, SeamsStayClosed) {
    for (const Case& c : cases())
        for (Cut cut : {Cut{.times = 3, .phase = 0.21}, Cut{.times = 2, .gap = 0.3}, Cut{.phase = 0.37}}) {
            cut.columns = c.columns, cut.rows = c.rows;
            const CutSurface model = cut_surface(c.surface, cut);
            const std::vector<Shape> made = smoothed(model.halves, CornerWeight::automatic);
            const MatchOptions fits{.distance = reach_of(cut, model), .weight = CornerWeight::automatic};
            Context context;
            const std::vector<Shape> once = joined(made, fits), twice = joined(once, fits);
            MatchOptions by_max = fits;
            by_max.weight = CornerWeight::max;
            const BorderMeasure votes = measure_borders(views(joined(made, by_max)), fits, context),
                                after = measure_borders(views(once), fits, context);
            EXPECT_LT(after.seam.mean_deg, votes.seam.mean_deg * 1.3 + 0.02) << c.name;
            for (std::size_t m = 0; m < 2; ++m)  // what agrees stays
                for (std::size_t v = 0; v < once[m].normals.size(); ++v)
                    EXPECT_LT(length(once[m].normals[v] - twice[m].normals[v]), 2e-4) << c.name;
        }
}

TEST(BorderFits, BitsDoNotDependOnThreads) {
    const Cut cut{.columns = 96, .rows = 12, .times = 3, .phase = 0.21, .gap = 0.1};
    const CutSurface model = cut_surface(torus(), cut);
    const std::vector<Shape> made = smoothed(model.halves, CornerWeight::automatic);
    const MatchOptions fits{.distance = reach_of(cut, model), .weight = CornerWeight::automatic};
    const std::vector<Shape> one = joined(made, fits, 1);
    for (const int threads : {2, 3, 8}) {
        const std::vector<Shape> more = joined(made, fits, threads);
        for (std::size_t m = 0; m < 2; ++m) EXPECT_EQ(one[m].normals, more[m].normals) << threads;
    }
}

/// Vertices and triangles in another order.
Shape renumbered(const Shape& shape, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<std::uint32_t> to(shape.positions.size()), faces(shape.indices.size() / 3);
    std::iota(to.begin(), to.end(), 0u), std::iota(faces.begin(), faces.end(), 0u);
    std::shuffle(to.begin(), to.end(), random), std::shuffle(faces.begin(), faces.end(), random);
    Shape out = shape;
    for (std::size_t v = 0; v < to.size(); ++v)
        out.positions[to[v]] = shape.positions[v], out.normals[to[v]] = shape.normals[v];
    for (std::size_t t = 0; t < faces.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) out.indices[3 * t + k] = to[shape.indices[3 * faces[t] + (k + t) % 3]];
    return out;
}
std::vector<Shape> by_position(std::vector<Shape> shapes) {
    for (Shape& s : shapes) {
        std::vector<std::size_t> order(s.positions.size());
        std::iota(order.begin(), order.end(), std::size_t(0));
        const auto key = [&](std::size_t v) {
            const vec3 p = s.positions[v], n = s.normals[v];
            return std::tuple(p.x, p.y, p.z, n.x, n.y, n.z);
        };
        std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
        const Shape old = s;
        for (std::size_t i = 0; i < order.size(); ++i)
            s.positions[i] = old.positions[order[i]], s.normals[i] = old.normals[order[i]];
    }
    return shapes;
}

TEST(BorderFits, AnotherNumberingChangesRoundingOnly) {
    for (const Case& c : cases()) {
        Cut cut{.columns = c.columns, .rows = c.rows, .times = 2, .phase = 0.21, .gap = 0.1};
        const CutSurface model = cut_surface(c.surface, cut);
        const std::vector<Shape> made = smoothed(model.halves, CornerWeight::automatic);
        const MatchOptions fits{.distance = reach_of(cut, model), .weight = CornerWeight::automatic};
        const std::vector<Shape> one = by_position(joined(made, fits)),
                                 other = by_position(joined({renumbered(made[0], 1), renumbered(made[1], 2)}, fits));
        for (std::size_t m = 0; m < 2; ++m)
            for (std::size_t v = 0; v < one[m].normals.size(); ++v)
                EXPECT_LT(length(one[m].normals[v] - other[m].normals[v]), 2e-6) << c.name;
    }
}

TEST(BorderFits, FlatPartsStayFlatAndBevelsBetweenPlanesStayBetweenThem) {
    const auto sheet = [](std::uint32_t columns, dvec3 corner, dvec3 up, std::uint32_t object) {
        Shape s = make_grid(columns, columns, [&](double u, double v) {
            return cast<float>(corner + dvec3{4 * u, 0, 0} + up * v);
        });
        s.object = object;
        return s;
    };
    for (const double bend : {0.0, 5.0, 30.0}) {
        const dvec3 up{0, 4 * std::cos(radians(bend)), 4 * std::sin(radians(bend))};
        const std::vector<Shape> parts =
            smoothed({sheet(4, {0, 0, 0}, {0, 4, 0}, 0), sheet(7, {0, 4, 0}, up, 1)}, CornerWeight::automatic);
        const std::vector<Shape> votes = joined(parts, {.distance = 0.05}),
                                 fits = joined(parts, {.distance = 0.05, .weight = CornerWeight::automatic});
        const dvec3 planes[] = {{0, 0, 1}, normalize_or(cross(dvec3{1, 0, 0}, up), {})};
        for (std::size_t m = 0; m < 2; ++m)
            for (std::size_t v = 0; v < fits[m].normals.size(); ++v) {
                const dvec3 n = cast<double>(fits[m].normals[v]);
                EXPECT_LT(degrees_between(n, planes[0]) + degrees_between(n, planes[1]), bend + 1e-3) << bend;
                EXPECT_LT(degrees_between(n, cast<double>(votes[m].normals[v])), 0.25 * bend + 1e-3) << bend;
            }
    }
}

TEST(BorderFits, BadInputIsSafe) {
    const CutSurface model = cut_surface(torus(), {.times = 3, .phase = 0.21});
    const MatchOptions fits{.distance = 0.3 * model.edge, .weight = CornerWeight::automatic};
    for (unsigned seed = 0; seed < 20; ++seed) {
        std::mt19937 random(seed);
        std::vector<Shape> shapes = smoothed(model.halves, CornerWeight::automatic);
        for (Shape& s : shapes)
            for (int i = 0; i < 40; ++i) {
                const float wild[] = {NAN, INFINITY, 1e38f, 1e-38f, 0};
                const std::size_t v = random() % s.positions.size();
                if (i % 2) s.positions[v] = {wild[random() % 5], wild[random() % 5], wild[random() % 5]};
                if (i % 3 == 0) s.normals[v] = {wild[random() % 5], 0, wild[random() % 5]};
                s.indices[random() % s.indices.size()] = s.indices[random() % s.indices.size()];
            }
        const std::vector<Shape> before = shapes, after = joined(shapes, fits);
        for (std::size_t m = 0; m < 2; ++m)
            for (std::size_t v = 0; v < after[m].normals.size(); ++v)
                if (after[m].normals[v] != before[m].normals[v] && is_finite(before[m].normals[v])) {
                    EXPECT_NEAR(length(after[m].normals[v]), 1, 1e-5) << seed;
                }
    }
}

TEST(BorderFits, MemoryIsAskedFor) {
    const CutSurface model = cut_surface(torus(), {.columns = 200, .rows = 100, .times = 3, .phase = 0.21});
    const std::vector<Shape> made = smoothed(model.halves, CornerWeight::automatic);
    const MatchOptions fits{.distance = 0.1 * model.edge, .weight = CornerWeight::automatic};
    Context small({.max_memory = 1 << 20});
    EXPECT_THROW(match_borders(views(made), fits, small), Error);
}

}  // namespace
}  // namespace rakelight::test
