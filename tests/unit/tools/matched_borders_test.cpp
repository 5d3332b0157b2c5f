// SPDX-License-Identifier: Apache-2.0
// Borders that run along each other, as inspections say them: two halves of a cylinder of which one is finer.
#include <rakelight/tools/inspect.h>
#include <rakelight/tools/rows.h>
#include <rakelight_internal/tools/inspection_report.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "support/temporary_folder.h"
#include "tools/inspect/largest_seam.h"
#include "unit/geometry/borders/border_shapes.h"
#include "unit/render/test_scene.h"

namespace rakelight {
namespace {

/// The halves of a cut surface as objects "lower" and "upper"; without normals.
Scene scene_of(const test::CutSurface& cut) {
    Scene scene;
    scene.source = "halves.obj";
    for (std::uint32_t half = 0; half < 2; ++half) {
        Mesh& mesh = scene.meshes.emplace_back();
        mesh.positions = cut.halves[half].positions;
        mesh.indices = cut.halves[half].indices;
        Node& node = scene.nodes.emplace_back();
        node.name = half == 0 ? "lower" : "upper";
        node.meshes = {half};
    }
    return scene;
}

/// With the normals that the surface has by its formula, the same on both sides.
Scene with_true_normals(Scene scene, const test::CutSurface& cut) {
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        std::vector<vec3> normals;
        for (const dvec3 n : cut.truth[m]) normals.push_back(cast<float>(n));
        scene.meshes[m].normals = std::move(normals);
    }
    return scene;
}

test::CutSurface finer(const test::Surface& surface) {
    return cut_surface(surface, {.times = 3, .phase = 0.4, .gap = 0.1});
}

/// A cylinder whose border vertices are off at random: its halves' normals differ there.
test::CutSurface torn_cylinder() {
    return cut_surface(test::cylinder(), {.times = 3, .phase = 0.4, .gap = 0.1, .noise = 0.03});
}

InspectOptions within(double distance) { return {.border_distance = distance, .prepare = {.crease_angle_rad = pi}}; }

Inspection inspected(const Scene& scene, const InspectOptions& options, int threads = 2) {
    Context context({.threads = threads});
    return inspect(scene, options, context);
}

nlohmann::json json_of(const Inspection& inspection) {
    const InspectionRow row{.file = "a", .inspection = inspection};
    return nlohmann::json::parse(to_json({&row, 1}))["rows"][0];
}

TEST(MatchedBorders, AFinerHalfHasASeamThatNoSharedPositionShowsAndJoiningTakesAway) {
    const test::CutSurface cut = finer(test::bumpy_sphere());
    const Inspection i = inspected(scene_of(cut), within(0.2 * cut.edge));
    EXPECT_EQ(i.shared_positions, 0u);
    const MatchedSeams& m = i.matched;
    ASSERT_EQ(m.pairs.size(), 1u);
    const MatchedPair& pair = m.pairs[0];
    EXPECT_EQ(std::pair(pair.object_a, pair.object_b), std::pair(0u, 1u));
    // both sides of the cut, all around; the outer borders of the halves match nothing
    const double cut_length = 2 * 24 * cut.edge;
    EXPECT_NEAR(m.matched_length, cut_length, 0.02 * cut_length);
    EXPECT_DOUBLE_EQ(pair.length, m.matched_length);
    EXPECT_GT(m.open_length, m.matched_length * 1.05);
    EXPECT_NEAR(m.gap_mean, 0.1 * cut.edge, 0.05 * cut.edge);
    EXPECT_LE(m.gap_mean, m.gap_max);
    EXPECT_LE(m.gap_max, 0.2 * cut.edge);
    EXPECT_GT(m.before.max_deg, 2);
    EXPECT_LT(m.after.max_deg, 0.2 * m.before.max_deg);
    EXPECT_LT(m.after.mean_deg, 0.1 * m.before.mean_deg + 0.02);
    EXPECT_LE(m.before.p95_deg, m.before.max_deg);
    EXPECT_EQ(pair.before.max_deg, m.before.max_deg);
    EXPECT_EQ(pair.after.max_deg, m.after.max_deg);
}

TEST(MatchedBorders, ThePlaceOfTheLargestIsOnTheBorder) {
    const test::CutSurface cut = torn_cylinder();
    const Inspection i = inspected(scene_of(cut), within(0.2 * cut.edge));
    ASSERT_EQ(i.matched.pairs.size(), 1u);
    const dvec3 p = i.matched.pairs[0].seam_position;
    EXPECT_NEAR(p.y, 1, 0.14 * cut.edge);
    EXPECT_NEAR(std::sqrt(p.x * p.x + p.z * p.z), 1, 0.02);
    const std::optional<LargestSeam> largest = largest_seam(i);
    ASSERT_TRUE(largest);
    EXPECT_TRUE(largest->is_along_borders);
    EXPECT_EQ(largest->deg, i.matched.before.max_deg);
    EXPECT_EQ(largest->position, p);
}

TEST(MatchedBorders, PairsComeWithTheLargestSeamFirstAndEachWithItsOwn) {
    // A row of three strips with small gaps; the normals of the middle one lean by 10 degrees, those of the right one by 40.
    Scene scene;
    for (int k = 0; k < 3; ++k) {
        Mesh& mesh = scene.meshes.emplace_back(test::square(float(k * 1.01)));
        const double lean = radians(k == 0 ? 0.0 : k == 1 ? 10 : 40);
        mesh.normals = std::vector<vec3>(4, vec3{float(std::sin(lean)), 0, float(std::cos(lean))});
        scene.nodes.emplace_back().meshes = {std::uint32_t(k)};
    }
    const Inspection i = inspected(scene, within(0.02));
    ASSERT_EQ(i.matched.pairs.size(), 2u);
    EXPECT_EQ(i.matched.pairs[0].object_a, 1u);
    EXPECT_EQ(i.matched.pairs[0].object_b, 2u);
    EXPECT_NEAR(i.matched.pairs[0].before.max_deg, 30, 1e-3);
    EXPECT_NEAR(i.matched.pairs[1].before.mean_deg, 10, 1e-3);
    EXPECT_NEAR(i.matched.pairs[1].length, 2, 1e-6);
    EXPECT_NEAR(i.matched.matched_length, 4, 1e-6);
    EXPECT_NEAR(i.matched.open_length, 12, 1e-6);
    EXPECT_NEAR(i.matched.gap_max, 0.01, 1e-6);
    EXPECT_EQ(inspected(scene, within(0.005)).matched.matched_length, 0);
}

TEST(MatchedBorders, TwoMeshesOfOneObjectAreAPairOfIt) {
    const test::CutSurface cut = torn_cylinder();
    Scene scene = scene_of(cut);
    scene.nodes.resize(1);
    scene.nodes[0].meshes = {0, 1};
    const Inspection i = inspected(scene, within(0.2 * cut.edge));
    ASSERT_EQ(i.matched.pairs.size(), 1u);
    EXPECT_EQ(i.matched.pairs[0].object_a, i.matched.pairs[0].object_b);
    EXPECT_NE(to_text(i).find("between two meshes of 'lower'"), std::string::npos) << to_text(i);
}

TEST(MatchedBorders, PlacedPartsAreMeasuredInTheWorld) {
    const test::CutSurface cut = torn_cylinder();
    Scene scene = scene_of(cut);
    const Inspection plain = inspected(scene, within(0.2 * cut.edge));
    for (Node& node : scene.nodes) node.local.scale = {2, 2, 2};
    const Inspection larger = inspected(scene, within(0.4 * cut.edge));
    EXPECT_NEAR(larger.matched.matched_length, 2 * plain.matched.matched_length, 1e-4);
    EXPECT_NEAR(larger.matched.gap_max, 2 * plain.matched.gap_max, 1e-5);
    EXPECT_NEAR(larger.matched.before.max_deg, plain.matched.before.max_deg, 1e-3);
}

TEST(MatchedBorders, WithoutTheOptionTheReportProposesADistanceThatFindsThem) {
    const test::CutSurface cut = finer(test::bumpy_sphere());
    const Inspection i = inspected(scene_of(cut), {.prepare = {.crease_angle_rad = pi}});
    EXPECT_EQ(i.matched.distance, 0);
    EXPECT_GT(i.proposal.distance, 0.1 * cut.edge);
    EXPECT_LT(i.proposal.distance, 0.2 * cut.edge);
    const Inspection asked = inspected(scene_of(cut), within(i.proposal.distance));
    EXPECT_EQ(asked.proposal.distance, 0);
    EXPECT_NEAR(asked.matched.matched_length, i.proposal.matched_length, 0.02 * i.proposal.matched_length);
    EXPECT_DOUBLE_EQ(asked.matched.open_length, i.proposal.open_length);
    EXPECT_NEAR(asked.matched.gap_max, i.proposal.gap_max, 0.05 * i.proposal.gap_max);
    EXPECT_NEAR(asked.matched.before.max_deg, i.proposal.seam_deg, 0.05 * i.proposal.seam_deg);
    EXPECT_NE(to_text(i).find("open borders of different meshes run along each other ("), std::string::npos);
    EXPECT_NE(to_text(i).find("): 'border-distance' "), std::string::npos) << to_text(i);
    EXPECT_EQ(json_of(i)["border_proposal"]["distance"], i.proposal.distance);
    EXPECT_FALSE(json_of(i).contains("matched_borders"));
}

TEST(MatchedBorders, NothingIsProposedWhereNoneRunAlongEachOther) {
    for (const Scene& scene : {test::two_squares(), Scene{}}) {
        const Inspection i = inspected(scene, {});
        EXPECT_EQ(i.proposal.distance, 0);
        EXPECT_EQ(to_text(i).find("border-distance"), std::string::npos);
        EXPECT_FALSE(json_of(i).contains("border_proposal"));
    }
    const test::CutSurface cut = torn_cylinder();
    EXPECT_EQ(inspected(with_true_normals(scene_of(cut), cut), {}).proposal.distance, 0) << "no seam to see";
    const test::CutSurface sphere = finer(test::bumpy_sphere());
    EXPECT_GT(inspected(scene_of(sphere), {}).proposal.distance, 0);
    for (const InspectOptions& options : {InspectOptions{.borders = false}, InspectOptions{.surfaces = false}})
        EXPECT_EQ(inspected(scene_of(sphere), options).proposal.distance, 0);
    EXPECT_EQ(inspected(test::two_squares(), within(0.1)).matched.matched_length, 0);
    EXPECT_NE(to_text(inspected(test::two_squares(), within(0.1))).find("open borders 6 units: 0 run along another"),
              std::string::npos);
}

TEST(MatchedBorders, AProposalThatNeedsTooMuchMemoryIsLeftOutWithANote) {
    Scene scene = test::two_squares();
    scene.nodes.resize(1);
    for (std::uint32_t i = 1; i < 2000; ++i) {  // apart from each other: only the proposal looks at all their borders
        Node node = scene.nodes[0];
        node.local.translation = {3.0 * i, 0, 0};
        scene.nodes.push_back(node);
    }
    scene.source = "many.obj";
    Context large, small({.max_memory = 6 << 20});
    const Inspection whole = inspect(scene, {}, large), left_out = inspect(scene, {}, small);
    EXPECT_TRUE(large.report().entries().empty());
    ASSERT_EQ(small.report().entries().size(), 1u);
    const ReportEntry note = small.report().entries()[0];
    EXPECT_EQ(note.remark, Remark::note);
    EXPECT_EQ(note.message.rfind("no distance is proposed for open borders: matching open borders: ", 0), 0u)
        << note.message;
    ASSERT_EQ(left_out.surfaces.size(), 2000u);
    EXPECT_EQ(left_out.surfaces[1999].open_edges, 4u);
    EXPECT_EQ(to_text(left_out), to_text(whole));
    const InspectOptions asked{.border_distance = 0.1};
    EXPECT_THROW(inspect(scene, asked, small), Error);  // a distance that is given is no option of the report's
}

TEST(MatchedBorders, TheSeamLimitCountsThemAndNamesPairAndPlace) {
    const test::CutSurface cut = torn_cylinder();
    Scene scene = with_true_normals(scene_of(cut), cut);
    const InspectOptions options = within(0.2 * cut.edge);
    EXPECT_TRUE(check_limits(inspected(scene, options), {}).empty());  // both sides agree
    std::vector<vec3> turned;
    for (const vec3 n : scene.meshes[1].normals) turned.push_back(normalize_or(n + vec3{0, 0.3f, 0}, vec3{}));
    scene.meshes[1].normals = turned;
    EXPECT_TRUE(check_limits(inspected(scene, {}), {}).empty());  // nobody asked
    const Inspection bent = inspected(scene, options);
    const auto failures = check_limits(bent, {});
    ASSERT_EQ(failures.size(), 1u);
    EXPECT_EQ(failures[0].limit, "max-seam");
    const std::string& text = failures[0].message;
    EXPECT_EQ(text.rfind("seam of 16.", 0), 0u) << text;
    EXPECT_NE(text.find("degrees between 'lower' and 'upper' at "), std::string::npos) << text;
    EXPECT_NE(text.find("along borders that share no vertex there, more than 1"), std::string::npos) << text;
    EXPECT_EQ(text.find("more pair"), std::string::npos) << text;
    EXPECT_TRUE(check_limits(bent, {.max_seam_deg = 20}).empty());
    EXPECT_EQ(check_limits(bent, {.max_seam_deg = 0}).size(), 1u);
    const InspectionRow row{.file = "a", .inspection = bent, .check = failures};
    EXPECT_NE(to_junit({&row, 1}, {}).find("along borders that share no vertex there"), std::string::npos);
}

TEST(MatchedBorders, JsonHasWhatIsMeasured) {
    const test::CutSurface cut = torn_cylinder();
    const Inspection i = inspected(scene_of(cut), within(0.2 * cut.edge));
    const nlohmann::json json = json_of(i)["matched_borders"];
    EXPECT_EQ(json["distance"], 0.2 * cut.edge);
    EXPECT_EQ(json["open_length"].get<double>(),
              json["matched_length"].get<double>() + json["unmatched_length"].get<double>());
    EXPECT_EQ(json["pairs"].size(), 1u);
    for (const char* key : {"max_deg", "mean_deg", "p95_deg"}) {
        EXPECT_TRUE(json["before"].contains(key) && json["after"].contains(key));
        EXPECT_EQ(json["pairs"][0]["before"][key], json["before"][key]);
    }
    EXPECT_EQ(json["pairs"][0]["seam_position"].size(), 3u);
    EXPECT_EQ(json["edges_not_searched"], 0);
    EXPECT_FALSE(json_of(i).contains("border_proposal"));
}

TEST(MatchedBorders, ThePageHasTheirTableAndTheLargest) {
    const test::CutSurface cut = torn_cylinder();
    const InspectionRow row{.file = "a.obj", .inspection = inspected(scene_of(cut), within(0.2 * cut.edge))};
    InspectionPage page;
    page.add(row, {});
    const test::TemporaryFolder folder;
    const std::string file = (folder.path() / "page.html").string();
    page.save(file);
    std::ifstream in(file);
    const std::string text(std::istreambuf_iterator<char>(in), {});
    EXPECT_NE(text.find("<h3>borders that run along each other (degrees)</h3>"), std::string::npos);
    EXPECT_NE(text.find("The largest seam, "), std::string::npos);
    EXPECT_NE(text.find("between 'lower' and 'upper', at "), std::string::npos);
}

TEST(MatchedBorders, TheHeatMapDrawsThemAndRingsTheLargest) {
    const test::CutSurface cut = torn_cylinder();
    const Scene scene = scene_of(cut);
    InspectOptions options = within(0.2 * cut.edge);
    options.seam_lines = true;
    const ViewRequest view{.position = dvec3{0, 1, 6},
                           .focal_point = dvec3{0, 1, 0},
                           .vertical_fov_rad = radians(30),
                           .orthographic = true};
    const RenderSettings settings{.width = 320, .height = 240};
    Context context;
    const auto drawn = [&](const InspectOptions& o, SeamMarks marks) {
        return draw_seams(scene, inspect(scene, o, context), o, view, settings, context, marks);
    };
    const auto colored = [](const Frame& f, int from_row, int to_row) {
        int count = 0;
        for (int p = from_row * f.width; p < to_row * f.width; ++p) {
            const vec3 c = f.color[std::size_t(p)].xyz();
            count += std::fabs(c.x - c.y) > 0.02f || std::fabs(c.y - c.z) > 0.02f;
        }
        return count;
    };
    InspectOptions off = options;
    off.border_distance = 0;
    const Frame gray = drawn(off, SeamMarks::none), lines = drawn(options, SeamMarks::none);
    EXPECT_EQ(colored(gray, 0, 240), 0);
    EXPECT_GT(colored(lines, 110, 130), 100);  // the cut is at half of the height
    EXPECT_EQ(colored(lines, 0, 110) + colored(lines, 130, 240), 0);
    const Frame marked = drawn(options, SeamMarks::legend);
    int ring = 0;
    for (std::size_t p = 0; p < 150 * 320; ++p) ring += !(marked.color[p] == lines.color[p]);
    EXPECT_GT(ring, 50);
}

TEST(MatchedBorders, TheSameForAnyNumberOfThreads) {
    const test::CutSurface cut = finer(test::bumpy_sphere());
    InspectOptions options = within(0.2 * cut.edge);
    options.seam_lines = true;
    const Inspection one = inspected(scene_of(cut), options, 1), four = inspected(scene_of(cut), options, 4);
    EXPECT_EQ(json_of(one), json_of(four));
    ASSERT_EQ(one.seam_lines.size(), four.seam_lines.size());
    for (std::size_t k = 0; k < one.seam_lines.size(); ++k) EXPECT_EQ(one.seam_lines[k].a, four.seam_lines[k].a);
}

TEST(MatchedBorders, NormalsThatAreSplitAtCreasesAreMeasuredToo) {
    // Without normals, with texture coordinates and a crease that splits vertices, by every choice of normals.
    const test::CutSurface cut = torn_cylinder();
    Scene scene = scene_of(cut);
    for (Mesh& mesh : scene.meshes) mesh.texcoords = {std::vector<vec2>(mesh.positions.size(), vec2{0.5f, 0.5f})};
    for (const NormalSource source : {NormalSource::automatic, NormalSource::file, NormalSource::flat,
                                      NormalSource::object, NormalSource::model, NormalSource::seams}) {
        InspectOptions options = within(0.2 * cut.edge);
        options.prepare.normals = source;
        options.prepare.crease_angle_rad = radians(10);
        const MatchedSeams m = inspected(scene, options).matched;
        EXPECT_GT(m.matched_length, 0);
        if (source == NormalSource::flat) {
            EXPECT_NEAR(m.before.max_deg, 10, 2.6) << "facets of 15 and 5 degrees";
        }
    }
}

TEST(MatchedBorders, ADistanceThatIsNoneIsWrongUsage) {
    for (const double wrong : {-1.0, double(INFINITY), double(NAN)})
        EXPECT_THROW(inspected(test::two_squares(), {.border_distance = wrong}), Error);
}

TEST(MatchedBorders, ImmenseScenesAreLookedAtWithoutEnd) {
    const test::CutSurface cut = torn_cylinder();
    for (const double scale : {1e120, 1e200, 1e-200}) {
        Scene scene = scene_of(cut);
        for (Node& node : scene.nodes) node.local.scale = {scale, scale, scale};
        const Inspection i = inspected(scene, {});
        EXPECT_TRUE(std::isfinite(i.proposal.distance)) << scale;
        EXPECT_FALSE(to_text(i).empty());
    }
}

}  // namespace
}  // namespace rakelight
