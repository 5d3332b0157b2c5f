// SPDX-License-Identifier: Apache-2.0
#include "render/engines.h"

#include <rakelight/render/render.h>

#include <algorithm>

#include "base/format_text.h"
#include "engines/raster/raster_engine.h"
#ifdef RL_HAVE_OPENGL
#include "engines/opengl/opengl_engine.h"
#endif
#ifdef RL_HAVE_TRACE
#include "engines/raytrace/raytrace_engine.h"
#endif
#include "render/auto_engine.h"
#include "world/keys/channel_info.h"

namespace rakelight {

std::vector<std::string> engine_names() {
    std::vector<std::string> names{"soft"};
#ifdef RL_HAVE_OPENGL
    names.push_back("gl");
#endif
#ifdef RL_HAVE_TRACE
    names.push_back("trace");
#endif
    names.push_back("auto");
    return names;
}

std::string engine_isa(const std::string& name) {
    return name == "soft" || name == "trace" ? raster::isa_name() : std::string();
}

void check_engine_name(const std::string& name) {
    const std::vector<std::string> names = engine_names();
    if (std::find(names.begin(), names.end(), name) != names.end()) return;
    std::string list;
    for (const std::string& n : names) list += (list.empty() ? "" : ", ") + n;
    throw Error(ErrorCode::usage, "'" + one_line(name, 40) + "' is not built in", {}, "this build has: " + list)
        .about("engine");
}

namespace {

/// "only 1, 2 or 4" samples.
std::string samples_text(const std::vector<int>& samples) {
    std::string text = "only ";
    for (std::size_t i = 0; i < samples.size(); ++i)
        text += (i == 0 ? "" : i + 1 < samples.size() ? ", " : " or ") + std::to_string(samples[i]);
    return text;
}

/// The first requirement of the settings that an engine cannot meet; empty: it meets all.
std::string beyond(const EngineCapabilities& can, const RenderSettings& s) {
    std::string first;
    const auto require = [&first](bool can_do, const std::string& what) {
        if (!can_do && first.empty()) first = what;
    };
    const bool needs_rays = s.method != RayMethod::automatic && s.method != RayMethod::radiosity;
    require(can.rays || !(needs_rays || s.naive), "follow rays: engine trace does");
    const bool is_path = can.rays && s.method == RayMethod::path;
    for (const ChannelInfo& channel : all_channels())
        require((s.channels & channel.channel & ~(can.channels | (is_path ? can.path_channels : 0))) == 0,
                std::string("give the data channel ") + channel.word +
                    (can.path_channels & channel.channel ? ": method path does" : ""));
    require(is_path || std::ranges::find(can.samples, s.samples) != can.samples.end(),
            format_text("take {} samples per pixel{}", s.samples,
                        can.rays ? ": method path does" : ", " + samples_text(can.samples)));
    require(can.visibility_methods || s.visibility == Visibility::z_reversed,
            "use another method of hidden-surface removal than its own: engine soft does");
    require(can.screen_interpolation || s.interpolation == AttributeInterpolation::perspective,
            "interpolate attributes on the screen");
    require(can.lines_and_points || (s.surfaces && !s.edges && s.points == PointShape::none),
            "draw edges and vertices");
    require(can.shadows || !s.shadows, "draw shadows");
    require(can.ambient_occlusion || !s.ambient_occlusion, "find ambient occlusion: engine soft does");
    require(can.rays || s.colors, "draw without colors");
    require(can.user_lighting || s.lighting_text.empty(),
            "use lighting from a GLSL file, " + one_line(s.lighting_name, 80) + ": engine gl does");
    require(can.user_lighting || s.vertex_text.empty(),
            "use a vertex shader from a GLSL file, " + one_line(s.vertex_name, 80) + ": engine gl does");
    return first;
}

}  // namespace

bool can_draw(const EngineCapabilities& can, const RenderSettings& settings) { return beyond(can, settings).empty(); }

void check_abilities(const std::string& name, const EngineCapabilities& can, const RenderSettings& settings) {
    const std::string what = beyond(can, settings);
    if (!what.empty()) throw Error(ErrorCode::usage, "engine " + one_line(name, 40) + " cannot " + what);
}

std::unique_ptr<Engine> make_engine(const std::string& name) {
    check_engine_name(name);
    if (name == "auto") return make_auto_engine();
#ifdef RL_HAVE_OPENGL
    if (name == "gl") return opengl::make_engine();
#endif
#ifdef RL_HAVE_TRACE
    if (name == "trace") return raytrace::make_engine();
#endif
    return raster::make_engine();
}

}  // namespace rakelight
