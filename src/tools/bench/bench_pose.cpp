// SPDX-License-Identifier: Apache-2.0
// Poses against a plain copy of the vertices. What one repetition measures is interleaved over all rows.
#include <rakelight_internal/tools/bench_pose.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <functional>

#include <nlohmann/json.hpp>

#include <rakelight/render/session.h>

#include "geometry/pose/skin.h"
#include "math/linear.h"
#include "prepare/moving_placements.h"
#include "prepare/pose_scene.h"
#include "render/camera/camera_chooser.h"
#include "render/output/picture_sink.h"
#include "render/prepared_scene.h"
#include "scene/placement.h"
#include "tools/bench/bench_rig.h"
#include "tools/report_json.h"

namespace rakelight {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::uint32_t moments = 7;  ///< of the clip, one after another: no pose is the one before

struct Measured {
    PoseBenchRow row;
    std::function<void(std::uint32_t)> run;
    std::vector<double> ms, cpu_ms;
};

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

void check(const PoseBenchOptions& o) {
    const auto refuse = [](const char* text) { throw Error(ErrorCode::usage, text); };
    if (o.triangles < 100 || o.triangles > 100'000'000) refuse("triangles must be 100 to 100000000");
    if (o.objects < 1 || o.objects > 100'000 || o.objects > o.triangles / 32)
        refuse("objects must be 1 to 100000, with 32 triangles or more each");
    if (o.joints < 2 || o.joints > 1000) refuse("joints must be 2 to 1000");
    if (o.repetitions < 1 || o.repetitions > 1000) refuse("repetitions must be 1 to 1000");
}

/// The skinned meshes of a scene by their joints, into buffers that exist.
class SkinAlone {
public:
    SkinAlone(const Scene& scene, Context& context) : scene_(scene), context_(context) {
        for (const Instance& i : moving_placements(scene)) {
            const Mesh& mesh = scene.meshes[i.mesh];
            if (!follows_skin(scene, scene.nodes[i.node], mesh)) continue;
            Part& part = parts_.emplace_back();
            part.mesh = i.mesh, part.skin = scene.nodes[i.node].skin;
            part.positions.resize(mesh.positions.size());
            part.normals.resize(mesh.normals.size());
            part.tangents.resize(mesh.tangents.size());
        }
    }
    bool is_needed() const { return !parts_.empty(); }
    void run(const Scene& at) {
        const std::vector<dmat4> world = world_matrices(with_posed_nodes(at));
        for (Part& part : parts_) {
            const Mesh& mesh = scene_.meshes[part.mesh];
            const std::vector<geometry::JointColumns> joints = joints_of(scene_.skins[part.skin], world);
            geometry::skin_vertices(
                {mesh.positions, mesh.normals, mesh.tangents, mesh.influences, mesh.more_influences, joints},
                {part.positions, part.normals, part.tangents}, context_);
        }
    }

private:
    struct Part {
        std::uint32_t mesh = 0, skin = 0;
        std::vector<vec3> positions, normals;
        std::vector<vec4> tangents;
    };
    static std::vector<geometry::JointColumns> joints_of(const Skin& skin, const std::vector<dmat4>& world) {
        std::vector<geometry::JointColumns> joints;
        for (std::size_t j = 0; j < skin.joints.size(); ++j)
            joints.push_back(geometry::columns_of(world[skin.joints[j]] * skin.inverse_bind[j]));
        return joints;
    }
    const Scene& scene_;
    Context& context_;
    std::vector<Part> parts_;
};

/// What is copied for the meshes that move, in chunks over all threads.
class PlainCopy {
public:
    PlainCopy(const Scene& scene, Context& context) : context_(context) {
        for (const Instance& i : moving_placements(scene)) {
            const Mesh& mesh = scene.meshes[i.mesh];
            add(mesh.positions.data(), mesh.positions.size() * sizeof(vec3));
            add(mesh.normals.data(), mesh.normals.size() * sizeof(vec3));
            add(mesh.tangents.data(), mesh.tangents.size() * sizeof(vec4));
        }
    }
    void run() {
        context_.parallel_for(parts_.size(),
                              [&](std::size_t p) { std::memcpy(parts_[p].to, parts_[p].from, parts_[p].bytes); });
    }

private:
    struct Part {
        std::byte* to;
        const void* from;
        std::size_t bytes;
    };
    void add(const void* from, std::size_t bytes) {
        constexpr std::size_t chunk = 1 << 18;
        if (bytes == 0) return;
        copies_.emplace_back(bytes);
        for (std::size_t at = 0; at < bytes; at += chunk)
            parts_.push_back(
                {copies_.back().data() + at, static_cast<const std::byte*>(from) + at, std::min(chunk, bytes - at)});
    }
    Context& context_;
    std::vector<std::vector<std::byte>> copies_;
    std::vector<Part> parts_;
};

class PoseBench {
public:
    PoseBench(const PoseBenchOptions& options, Context& context) : options_(options), context_(context) {
        scene_ = options.scene.empty() ? make_bench_rig(options.triangles, options.objects, options.joints)
                                       : load(options.scene, options.load, context);
        if (scene_.animations.empty() || moving_placements(scene_).empty())
            throw Error(ErrorCode::usage, "no clip moves anything in the scene").with_file(options.scene);
        session_.set(scene_, options.picture.prepare);
        bound_ = session_.prepared(options.picture.settings, context);
        const double aspect = double(options.picture.settings.width) / options.picture.settings.height;
        camera_ =
            valid::choose_camera(scene_, options.picture.view, aspect, options.picture.settings.visibility, context);
    }

    PoseBenchReport run() {
        PlainCopy copy(bound_->bound ? bound_->bound->scene : scene_of(*bound_), context_);
        add("plain copy", [&](std::uint32_t) { copy.run(); });
        SkinAlone skin(bound_->bound ? bound_->bound->scene : scene_, context_);
        if (bound_->bound && skin.is_needed())
            add("skin alone, into buffers", [&](std::uint32_t k) { skin.run(at(k)); });
        if (bound_->bound) add_poses();
        add("picture of a moment", [&](std::uint32_t k) { draw(k); });
        repeat();
        PoseBenchReport report = about_the_scene();
        for (Measured& m : measured_) report.rows.push_back(finished(m, report.vertices));
        for (PoseBenchRow& row : report.rows) row.ratio_to_copy = row.median_ms / report.rows[0].median_ms;
        return report;
    }

private:
    Scene at(std::uint32_t k) const {
        const ClipSpan span = clip_span(scene_.animations[0]);
        const ClipTime clip{0, span.begin_s + span.length() * (k % moments) / moments};
        return scene_at(scene_, std::span(&clip, 1));
    }

    void add_poses() {
        add("pose, normals and tangents rotated", [&](std::uint32_t k) {
            BoundScene given{bound_->bound->scene, {}};
            finish_scene(std::move(given), at(k).pose, bound_->options, context_);
        });
        if (bound_->bound->made.empty()) return;
        add("pose, normals and tangents recomputed",
            [&](std::uint32_t k) { finish_scene(*bound_->bound, at(k).pose, bound_->options, context_); });
    }

    void draw(std::uint32_t k) {
        session_.set(at(k), options_.picture.prepare);
        PictureSink sink(PixelFormat{}, ToneCurve(options_.picture.tone));
        session_.render(camera_, options_.picture.settings, sink, context_);
    }

    void add(std::string what, std::function<void(std::uint32_t)> run) {
        Measured& m = measured_.emplace_back();
        m.row.what = std::move(what);
        m.run = std::move(run);
        m.run(0);
        context_.throw_if_cancelled();
    }

    void repeat() {
        for (std::uint32_t r = 0; r < options_.repetitions; ++r) {
            for (Measured& m : measured_) {
                context_.throw_if_cancelled();
                const std::clock_t cpu = std::clock();
                const auto start = Clock::now();
                m.run(r + 1);
                m.ms.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
                m.cpu_ms.push_back(1e3 * double(std::clock() - cpu) / CLOCKS_PER_SEC);
            }
            context_.progress("bench", double(r + 1) / options_.repetitions);
        }
    }

    static PoseBenchRow finished(const Measured& m, std::uint64_t vertices) {
        PoseBenchRow row = m.row;
        row.median_ms = median(m.ms), row.cpu_ms = median(m.cpu_ms);
        row.fastest_ms = *std::ranges::min_element(m.ms), row.slowest_ms = *std::ranges::max_element(m.ms);
        row.ns_per_vertex = row.median_ms * 1e6 / double(std::max<std::uint64_t>(vertices, 1));
        return row;
    }

    PoseBenchReport about_the_scene() const {
        PoseBenchReport report{.scene = scene_.source, .threads = context_.threads()};
        for (const Instance& i : moving_placements(scene_)) {
            ++report.objects;
            report.triangles += scene_.meshes[i.mesh].triangle_count();
            report.vertices += scene_.meshes[i.mesh].positions.size();
        }
        for (const Skin& skin : scene_.skins) report.joints += std::uint32_t(skin.joints.size());
        return report;
    }

    const PoseBenchOptions& options_;
    Context& context_;
    Scene scene_;
    std::shared_ptr<const PreparedScene> bound_;
    Session session_;
    Camera camera_;
    std::vector<Measured> measured_;
};

}  // namespace

PoseBenchReport bench_pose(const PoseBenchOptions& options, Context& context) {
    check(options);
    context.memory().check(options.scene.empty() ? options.triangles * 200 : 0, "the character to measure");
    return PoseBench(options, context).run();
}

std::string to_json(const PoseBenchReport& report) {
    Json rows = Json::array();
    for (const PoseBenchRow& r : report.rows)
        rows.push_back({{"what", r.what},
                        {"median_ms", r.median_ms},
                        {"fastest_ms", r.fastest_ms},
                        {"slowest_ms", r.slowest_ms},
                        {"cpu_ms", r.cpu_ms},
                        {"ns_per_vertex", r.ns_per_vertex},
                        {"ratio_to_copy", r.ratio_to_copy}});
    return json_text({{"schema", "rakelight.bench/1"},
                      {"rows", rows},
                      {"scene", report.scene},
                      {"triangles", report.triangles},
                      {"vertices", report.vertices},
                      {"objects", report.objects},
                      {"joints", report.joints},
                      {"threads", report.threads}});
}

std::string to_text(const PoseBenchReport& report) {
    char line[256];
    const auto format = [&](auto... values) {
        std::snprintf(line, sizeof line, values...);
        return std::string(line);
    };
    std::string text =
        format("%s: what moves has %llu triangles, %llu vertices, %u objects, %u joints; %d threads\n",
               report.scene.c_str(), static_cast<unsigned long long>(report.triangles),
               static_cast<unsigned long long>(report.vertices), report.objects, report.joints, report.threads);
    text += "ms                                         median    (fastest  slowest)      CPU  ns/vertex  to copy\n";
    for (const PoseBenchRow& r : report.rows)
        text += format("%-40s %8.2f    %9.2f %9.2f %8.2f %10.2f %8.2f\n", r.what.c_str(), r.median_ms, r.fastest_ms,
                       r.slowest_ms, r.cpu_ms, r.ns_per_vertex, r.ratio_to_copy);
    return text;
}

}  // namespace rakelight
