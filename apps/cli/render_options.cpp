// SPDX-License-Identifier: Apache-2.0
// What the words of `rakelight render` mean.
#include "render_options.h"

#include <filesystem>

#include <rakelight/version.h>

#include "values.h"

namespace rakelight::cli {
namespace {

void apply_size(const RenderWords& w, RenderSettings& s) {
    if (!w.resolution.empty()) {
        const std::vector<int> size = integers("--resolution", w.resolution, 2);
        s.width = size[0], s.height = size[1];
        constexpr int most = 65536;
        if (s.width < 1 || s.height < 1 || s.width > most || s.height > most)
            throw Error(ErrorCode::usage, "--resolution: must be 1 to 65536 pixels a side");
    }
    if (!w.window.empty()) {
        const std::vector<int> window = integers("--window", w.window, 4);
        s.window = {window[0], window[1], window[2], window[3]};
        if (s.window.width < 1 || s.window.height < 1) throw Error(ErrorCode::usage, "--window: the window is empty");
        if (s.window.x < 0 || s.window.y < 0 || s.window.x > s.width - s.window.width ||
            s.window.y > s.height - s.window.height)
            throw Error(ErrorCode::usage, "--window: does not lie inside the picture of " + std::to_string(s.width) +
                                              " x " + std::to_string(s.height) + " pixels that --resolution asks for");
    }
    if (!w.anisotropy.empty()) s.anisotropy = integer("--anisotropy", w.anisotropy, 1, 16);
    if (!w.samples.empty()) s.samples = word<int>("--samples", w.samples, {{"1", 1}, {"4", 4}, {"8", 8}});
    if (!w.background.empty()) s.background = background("--background", w.background);
}

bool is_exr(const std::string& file) {
    std::string ending = std::filesystem::path(file).extension().string();
    for (char& c : ending) c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
    return ending == ".exr";
}

void apply_channels(const RenderWords& w, PictureRequest& request) {
    for (const std::string_view name : w.channels.empty() ? std::vector<std::string_view>() : split(w.channels, ',')) {
        try {
            request.settings.channels |= channels_by_name(name);
        } catch (const Error& error) {
            throw Error(error.code(), "--channels: " + error.reason(), {}, error.advice());
        }
    }
    if (!w.channel_files.empty()) request.channel_files = 0;
    for (const std::string_view way :
         w.channel_files.empty() ? std::vector<std::string_view>() : split(w.channel_files, ','))
        request.channel_files |= word<std::uint32_t>(
            "--channel-files", way,
            {{"exr", channel_files_exr}, {"layers", channel_files_layers}, {"png", channel_files_png}});
    if (!w.channel_files.empty() && w.channels.empty())
        throw Error(ErrorCode::usage, "--channel-files says how channels are written, but --channels asks for none");
    if (w.exr_colors.empty()) return;
    request.half_colors = word<bool>("--exr-colors", w.exr_colors, {{"float", false}, {"half", true}});
    const bool has_exr_channels =
        !w.channels.empty() && (request.channel_files & ~std::uint32_t(channel_files_png)) != 0;
    if (!has_exr_channels && !is_exr(request.output))
        throw Error(ErrorCode::usage, "--exr-colors is about EXR files, but none is written", {},
                    "let --output end in .exr, or add --channels");
}

Shading shading_word(std::string_view text) { return word("--shading", text, shading_words); }

/// HOW, material:NAME=HOW, object:NAME=HOW. Names may hold any character: the last '=' ends them.
void apply_shading(const RenderWords& w, RenderSettings& s) {
    std::size_t plain = 0;
    for (const std::string_view text : w.shading) {
        const bool is_material = text.starts_with("material:");
        if (!is_material && !text.starts_with("object:")) {
            s.shading = shading_word(text);
            if (++plain > 1) throw Error(ErrorCode::usage, "--shading: how the whole is shaded can be said once");
            continue;
        }
        const std::size_t begin = text.find(':') + 1, equals = text.rfind('=');
        if (equals == text.npos || equals <= begin)
            throw Error(
                ErrorCode::usage,
                "--shading: '" + one_line(std::string(text), 60) + "' needs a name and '=' with how it is shaded", {},
                "write for example --shading material:glass=flat");
        s.shading_rules.push_back({is_material ? ShadingRule::Of::material : ShadingRule::Of::object,
                                   std::string(text.substr(begin, equals - begin)),
                                   shading_word(text.substr(equals + 1))});
    }
}

void apply_visibility(const RenderWords& w, RenderSettings& s) {
    apply_shading(w, s);
    if (!w.front_face.empty())
        s.front_face = word<FrontFace>("--front-face", w.front_face,
                                       {{"ccw", FrontFace::counter_clockwise}, {"cw", FrontFace::clockwise}});
    s.orthogonalize = w.orthogonalize != "off";
    if (!w.interpolation.empty())
        s.interpolation = word<AttributeInterpolation>(
            "--interpolation", w.interpolation,
            {{"perspective", AttributeInterpolation::perspective}, {"screen", AttributeInterpolation::screen}});
    if (!w.visibility.empty())
        s.visibility = word<Visibility>("--visibility", w.visibility,
                                        {{"z-reversed", Visibility::z_reversed},
                                         {"z-float", Visibility::z_float},
                                         {"z16", Visibility::z16},
                                         {"z24", Visibility::z24},
                                         {"z32", Visibility::z32},
                                         {"painter", Visibility::painter},
                                         {"none", Visibility::none},
                                         {"back-face", Visibility::back_face}});
    if (s.samples > 1 && s.visibility != Visibility::z_reversed)
        throw Error(ErrorCode::usage, "--samples " + w.samples + " needs --visibility z-reversed, the default");
    if (!w.cull.empty())
        s.cull =
            word<Cull>("--cull", w.cull,
                       {{"auto", Cull::automatic}, {"none", Cull::none}, {"back", Cull::back}, {"front", Cull::front}});
}

float pixels(const std::string& option, const std::string& text) {
    const double size = number(option, text);
    if (!(size > 0 && size <= 256))
        throw Error(ErrorCode::usage, option + ": must be more than 0 and at most 256 pixels");
    return float(size);
}

void apply_lines(const RenderWords& w, RenderSettings& s) {
    s.edges = w.edges || w.wireframe;
    s.surfaces = !w.wireframe && !w.point_sprites;
    if (w.point_sprites) s.points = PointShape::disc;
    if (!w.points.empty())
        s.points =
            word<PointShape>("--points", w.points,
                             {{"none", PointShape::none}, {"square", PointShape::square}, {"disc", PointShape::disc}});
    if (w.point_sprites && s.points == PointShape::none)
        throw Error(ErrorCode::usage, "--point-sprites and --points none exclude each other");
    if (!w.line_width.empty()) s.line_width = pixels("--line-width", w.line_width);
    if (!w.point_size.empty()) s.point_size = pixels("--point-size", w.point_size);
    if (!w.line_color.empty()) s.line_color = display_color("--line-color", w.line_color);
}

void apply_normals(const RenderWords& w, PrepareOptions& p) {
    if (!w.normals.empty())
        p.normals = word<NormalSource>("--normals", w.normals,
                                       {{"auto", NormalSource::automatic},
                                        {"file", NormalSource::file},
                                        {"flat", NormalSource::flat},
                                        {"object", NormalSource::object},
                                        {"model", NormalSource::model}});
    if (!w.weight.empty())
        p.weight = word<CornerWeight>("--weight", w.weight,
                                      {{"uniform", CornerWeight::uniform},
                                       {"area", CornerWeight::area},
                                       {"angle", CornerWeight::angle},
                                       {"angle-area", CornerWeight::angle_area}});
    if (!w.uv.empty())
        p.uv = word<UvProjection>("--uv", w.uv,
                                  {{"none", UvProjection::none},
                                   {"box", UvProjection::box},
                                   {"sphere", UvProjection::sphere},
                                   {"cylinder", UvProjection::cylinder}});
    if (!w.tangents.empty())
        p.tangents =
            word<std::optional<TangentMode>>("--tangents", w.tangents,
                                             {{"auto", std::nullopt},
                                              {"averaged", TangentMode::averaged},
                                              {"published", TangentMode::published},
                                              {"published-no-handedness", TangentMode::published_no_handedness},
                                              {"mikktspace", TangentMode::mikktspace}});
    if (!w.orthogonalize.empty()) {
        p.orthogonalize = word<Orthogonalize>(
            "--orthogonalize", w.orthogonalize,
            {{"attribute", Orthogonalize::attribute}, {"shader", Orthogonalize::off}, {"off", Orthogonalize::off}});
        p.measure_orthogonality = true;  // who chooses wants to know what it costs
    }
    if (!w.displacement_edge.empty())
        p.displacement.edge = number("--displacement-edge", w.displacement_edge, 1e-6, 1e6);
    if (!w.displacement_triangles.empty())
        p.displacement.most_triangles =
            std::uint64_t(integer("--displacement-triangles", w.displacement_triangles, 1, 100'000'000));
    p.keep_instances = w.keep_instances;
    if (w.crease_angle.empty()) return;
    const double angle = number("--crease-angle", w.crease_angle);
    if (!(angle >= 0 && angle <= 180)) throw Error(ErrorCode::usage, "--crease-angle: must be 0 to 180 degrees");
    p.crease_angle_rad = angle == 180 ? pi : radians(angle);
}

void apply_depths(const RenderWords& w, ViewRequest& v) {
    const auto distance = [](const char* option, const std::string& text) {
        const double meters = number(option, text);
        if (!(meters > 0)) throw Error(ErrorCode::usage, std::string(option) + ": must be more than 0 meters");
        return meters;
    };
    if (!w.near.empty()) v.near = distance("--near", w.near);
    if (!w.far.empty()) v.far = distance("--far", w.far);
    if (v.near && v.far && !(*v.near < *v.far)) throw Error(ErrorCode::usage, "--near: must be less than --far");
}

void apply_view(const RenderWords& w, ViewRequest& v) {
    v.side = w.view;
    v.camera = w.camera;
    v.orthographic = w.orthographic;
    if (!w.view.empty())
        word<bool>("--view", w.view,
                   {{"front", true},
                    {"back", true},
                    {"left", true},
                    {"right", true},
                    {"top", true},
                    {"bottom", true},
                    {"isometric", true},
                    {"default", true}});
    if (!w.view.empty() && !w.camera.empty())
        throw Error(ErrorCode::usage, "--view and --camera-index exclude each other");
    if (!w.position.empty() && (!w.view.empty() || !w.camera.empty()))
        throw Error(
            ErrorCode::usage,
            std::string(w.view.empty() ? "--camera-index" : "--view") + " and --camera-position exclude each other", {},
            "--camera-focal-point, -view-up and -view-angle may be added to either");
    if (!w.position.empty()) v.position = vector3("--camera-position", w.position);
    if (!w.focal_point.empty()) v.focal_point = vector3("--camera-focal-point", w.focal_point);
    if (!w.up.empty()) v.up = vector3("--camera-view-up", w.up);
    const auto angle = [](const char* option, const std::string& text) {
        const double degrees = number(option, text);
        if (!(degrees > 0 && degrees < 180))
            throw Error(ErrorCode::usage, std::string(option) + ": must be more than 0 and less than 180 degrees");
        return radians(degrees);
    };
    if (!w.view_angle.empty()) v.vertical_fov_rad = angle("--camera-view-angle", w.view_angle);
    if (!w.horizontal_angle.empty()) v.horizontal_fov_rad = angle("--camera-horizontal-angle", w.horizontal_angle);
    apply_depths(w, v);
}

}  // namespace

static void check_engine(const std::string& name) {
    std::string all;
    for (const std::string& known : build_info().engines) {
        if (name == known) return;
        all += (all.empty() ? "" : ", ") + known;
    }
    throw Error(ErrorCode::usage, "--engine: '" + one_line(name, 40) + "' is not built in", {},
                "this build has: " + all);
}

void apply(const RenderWords& words, PictureRequest& request) {
    request.output = words.output;
    request.engine = words.engine;
    check_engine(request.engine);
    apply_size(words, request.settings);
    apply_channels(words, request);
    apply(words.surface, request.settings);
    apply_visibility(words, request.settings);
    apply_lines(words, request.settings);
    apply_normals(words, request.prepare);
    apply(words.subdivision, request.prepare.subdivision);
    apply(words.scene, request);
    apply_view(words, request.view);
}

}  // namespace rakelight::cli
