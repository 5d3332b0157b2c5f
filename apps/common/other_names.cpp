// SPDX-License-Identifier: Apache-2.0
#include "other_names.h"

#include <rakelight/scene/words.h>

namespace rakelight::apps {
namespace {

struct OtherName {
    std::string_view theirs, ours;
};

constexpr OtherName options[] = {
    {"aa", "samples"},
    {"all-layers", "channels"},
    {"ambient", "light"},
    {"anti-aliasing", "samples"},
    {"anti-aliasing-mode", "samples"},
    {"antialias", "samples"},
    {"antialiasing", "samples"},
    {"ao", "ambient-occlusion"},
    {"azimuth", "camera-azimuth-angle"},
    {"bg", "background"},
    {"bg-color", "background"},
    {"bgcolor", "background"},
    {"border-tolerance", "border-distance"},
    {"borders", "border-distance"},
    {"camera", "camera-index"},
    {"camera-fov", "camera-view-angle"},
    {"camera-target", "camera-focal-point"},
    {"colour", "color"},
    {"crop", "window"},
    {"denoising", "denoise"},
    {"dir", "output"},
    {"elevation", "camera-elevation-angle"},
    {"env", "hdri-file"},
    {"environment", "hdri-file"},
    {"envmap", "hdri-file"},
    {"eye", "camera-position"},
    {"field-of-view", "camera-view-angle"},
    {"fov", "camera-view-angle"},
    {"fxaa", "samples"},
    {"gap", "border-distance"},
    {"gap-distance", "border-distance"},
    {"geometry-only", "shading"},
    {"hdr", "hdri-file"},
    {"hdri", "hdri-file"},
    {"hdri-background", "hdri-skybox"},
    {"height", "resolution"},
    {"jobs", "threads"},
    {"join-borders", "border-distance"},
    {"look-at", "camera-focal-point"},
    {"lookat", "camera-focal-point"},
    {"match-borders", "border-distance"},
    {"max-gap", "border-distance"},
    {"measure", "max-flip"},
    {"measure", "max-rmse"},
    {"measure", "min-psnr"},
    {"measure", "min-ssim"},
    {"measure", "ref-measure"},
    {"metric", "max-flip"},
    {"metric", "max-rmse"},
    {"metric", "min-psnr"},
    {"metric", "min-ssim"},
    {"metric", "ref-measure"},
    {"msaa", "samples"},
    {"no-background", "background"},
    {"normal-map", "texture-normal"},
    {"nthreads", "threads"},
    {"ortho", "camera-orthographic"},
    {"orthographic", "camera-orthographic"},
    {"out", "output"},
    {"outfile", "output"},
    {"position", "camera-position"},
    {"raytracing", "engine"},
    {"raytracing-denoise", "denoise"},
    {"raytracing-samples", "samples"},
    {"reference", "ref"},
    {"reference-threshold", "ref-threshold"},
    {"renderer", "engine"},
    {"rendering-backend", "engine"},
    {"res", "resolution"},
    {"scope", "normals"},
    {"sdf", "point-size"},
    {"seam-distance", "border-distance"},
    {"silent", "quiet"},
    {"size", "resolution"},
    {"skybox", "hdri-skybox"},
    {"smooth", "normals"},
    {"spp", "samples"},
    {"ssaa", "samples"},
    {"ssao", "ambient-occlusion"},
    {"stitch", "border-distance"},
    {"stitch-distance", "border-distance"},
    {"t-junctions", "border-distance"},
    {"target", "camera-focal-point"},
    {"texture-matcap", "lighting"},
    {"threshold", "max-flip"},
    {"threshold", "max-rmse"},
    {"threshold", "min-psnr"},
    {"threshold", "min-ssim"},
    {"threshold", "ref-threshold"},
    {"tolerance", "weld-distance"},
    {"tonemap", "tone-mapping"},
    {"tonemapping", "tone-mapping"},
    {"transparent", "background"},
    {"up-axis", "up"},
    {"upaxis", "up"},
    {"verbosity", "verbose"},
    {"width", "resolution"},
    {"wire", "wireframe"},
    {"zoom", "camera-zoom-factor"},
};

constexpr OtherName commands[] = {
    {"benchmark", "bench"}, {"convert", "render"},    {"diff", "compare"},     {"draw", "render"},
    {"idiff", "compare"},   {"image", "render"},      {"info", "inspect"},     {"lint", "check"},
    {"merge", "render"},    {"normals", "smooth"},    {"open", "view"},        {"picture", "render"},
    {"repair", "smooth"},   {"screenshot", "render"}, {"show", "view"},        {"snapshot", "render"},
    {"stats", "inspect"},   {"tangents", "smooth"},   {"thumbnail", "render"}, {"validate", "check"},
    {"verify", "check"},    {"viewer", "view"},       {"weld", "smooth"},      {"why", "explain"},
};

}  // namespace

std::vector<std::string_view> our_options_for(std::string_view theirs) {
    std::vector<std::string_view> ours;
    for (const OtherName& name : options)
        if (same_word(name.theirs, theirs)) ours.push_back(name.ours);
    return ours;
}

std::string_view our_command_for(std::string_view theirs) {
    for (const OtherName& name : commands)
        if (same_word(name.theirs, theirs)) return name.ours;
    return {};
}

}  // namespace rakelight::apps
