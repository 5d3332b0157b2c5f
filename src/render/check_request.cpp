// SPDX-License-Identifier: Apache-2.0
// What can be wrong with a picture before anything is loaded.
#include "render/check_request.h"

#include <cmath>

#include "engines/check_settings.h"
#include "io/files/made_folders.h"
#include "prepare/normals/normal_rule.h"
#include "prepare/refine/displace.h"
#include "prepare/variants.h"
#include "render/engines.h"
#include "render/look.h"
#include "render/output/picture_files.h"

#include <rakelight/render/picture.h>

namespace rakelight {
namespace {

void check_output(const PictureRequest& request) {
    const PixelFormat format = format_for(request.output, request.settings.background.w < 1);
    check_alpha(request.output, format);
    const bool has_exr_channels =
        request.settings.channels != 0 && (request.channel_files & ~std::uint32_t(channel_files_png)) != 0;
    if (request.half_colors && !has_exr_channels && !is_exr(request.output))
        throw Error(ErrorCode::usage, "applies to EXR files, but none is written", {},
                    "let the output end in .exr, or ask for data channels")
            .about("exr-colors", {"channels"});
    check_output_place(request.output);
}

}  // namespace

void check_output_place(const std::string& output) { io::check_output_place(output); }

void check_drawing(const PictureRequest& request) {
    check_engine_name(request.engine);
    check_settings(request.settings);
    if (!(request.light_cutoff >= 0 && request.light_cutoff <= 1))
        throw Error(ErrorCode::usage, "must be 0 to 1").about("light-cutoff");
    if (!(request.light_intensity >= 0 && std::isfinite(request.light_intensity)))
        throw Error(ErrorCode::usage, "must be a number >= 0").about("light-intensity");
    (void)ToneCurve(request.tone);  // an exposure that cannot be
}

void check_request(const PictureRequest& request) {
    check_drawing(request);
    try {
        check_output(request);
    } catch (const Error& error) {
        throw error.with_file(request.output);
    }
}

void warn_of_unused(const PictureRequest& request, Report& report) {
    const RenderSettings& s = request.settings;
    if (s.method != RayMethod::path && s.paths != PathSettings{})
        report.add(Remark::warning, request.input, "",
                   "seed, max-seconds, noise, clamp, denoise and light-sampling have no effect without the method path",
                   {"method"});
    if (s.method != RayMethod::radiosity && s.radiosity != RadiositySettings{})
        report.add(Remark::warning, request.input, "",
                   "radiosity-elements and radiosity-unshot have no effect without the method radiosity", {"method"});
    const bool has_occlusion_settings = names(request, {"ambient-occlusion-radius", "ambient-occlusion-samples"}) ||
                                        s.ambient_occlusion_radius != 0 ||
                                        s.ambient_occlusion_samples != default_occlusion_samples;
    if (has_occlusion_settings && !s.ambient_occlusion && !names(request, "ambient-occlusion"))
        report.add(Remark::warning, request.input, "",
                   "the radius and samples of ambient occlusion have no effect without 'ambient-occlusion'",
                   {"ambient-occlusion"});
}

namespace {

/// Computed normals take the weight; where authored ones are joined, only the creases count.
enum class Needs { nothing, creases, all };

Needs needs_of(const Scene& scene, const PictureRequest& request) {
    Needs most = Needs::nothing;
    for (const Instance& instance : drawn_instances(scene)) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        const NormalRule rule = normal_rule(scene, mesh, request.prepare.normals);
        const bool keeps = rule.keeps_given && !mesh.normals.empty();
        if (!keeps && rule.scope != Scope::face) return Needs::all;
        if (keeps && rule.joins_seams) most = Needs::creases;
    }
    return most;
}

}  // namespace

void warn_of_unused_normals(const Scene& scene, const PictureRequest& request, Report& report) {
    std::vector<std::string> unused;
    for (const char* key : {"weight", "crease", "crease-angle", "weld-distance"})
        if (names(request, key)) unused.emplace_back(key);
    if (unused.empty() || wants_displacement(scene, request.prepare.displacement)) return;
    const Needs needs = needs_of(scene, request);
    if (needs == Needs::all) return;
    if (needs == Needs::creases) unused.resize(unused.front() == "weight" ? 1 : 0);
    if (unused.empty()) return;
    std::string text;
    for (const std::string& key : unused) text += (text.empty() ? "'" : ", '") + key + "'";
    unused.emplace_back("normals");
    report.add(Remark::warning, scene.source, {},
               text + ": no effect, because no normals are computed here; 'normals' model computes all", unused);
}

}  // namespace rakelight
