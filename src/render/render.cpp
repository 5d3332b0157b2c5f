// SPDX-License-Identifier: Apache-2.0
// Facade: smooth, render, save.
#include <algorithm>

#include <rakelight/render/picture.h>
#include <rakelight/render/session.h>
#include <rakelight/scene/validate.h>
#include <rakelight_internal/base/file_ending.h>

#include "base/format_text.h"
#include "engines/check_settings.h"
#include "io/gltf/write/glb_writer.h"
#include "io/obj/write/write_obj.h"
#include "io/ply/ply_writer.h"
#include "prepare/normals/smooth_scene.h"
#include "prepare/prepare_scene.h"
#include "render/output/picture_files.h"
#include "render/rows.h"
#include "world/placed_in_world.h"
#include "world/z_up.h"

namespace rakelight {
Scene smooth(const Scene& scene, const AttributeOptions& options, Context& context) {
    validate(scene);
    return smooth_scene(scene, {.attributes = options, .only_missing = false}, context);
}

Frame render(const Scene& scene, const Camera& camera, const RenderSettings& settings, Context& context) {
    check_settings(settings);
    Session session;
    session.set(scene);
    Frame frame;
    session.render(camera, settings, frame, context);
    return frame;
}

Frame render(const Scene& scene, const RenderSettings& settings, Context& context) {
    check_settings(settings);
    const double aspect = double(settings.width) / double(settings.height);
    return render(scene, choose_camera(scene, {}, aspect, settings.visibility, context), settings, context);
}

namespace {

void check_colors(const Frame& frame, const std::string& path) {
    const Window& w = frame.window;
    if (w.width > 0 && w.height > 0 && frame.color.size() != std::size_t(w.width) * std::size_t(w.height))
        throw Error(ErrorCode::usage,
                    format_text("the frame has {} colors for {} x {} pixels", frame.color.size(), w.width, w.height))
            .with_file(path);
}

void write(const Frame& frame, const io::OutputTarget& target, const ToneSettings& tone, vec4 behind) {
    check_colors(frame, target.path);
    const ToneCurve curve(tone, behind);
    const bool transparent = !curve.is_opaque_behind() &&
                             std::any_of(frame.color.begin(), frame.color.end(), [](const vec4& c) { return c.w < 1; });
    const PixelFormat format = format_for(target.path, transparent);
    check_alpha(target.path, format);
    const auto writer = make_color_writer(target, frame.window.width, frame.window.height, format);
    const std::size_t width = std::size_t(frame.window.width);
    std::vector<std::byte> row(width * format.bytes());
    for (std::size_t y = 0; y < std::size_t(frame.window.height); ++y) {
        convert_row(frame.color.data() + y * width, width, format, curve, row.data());
        writer->write_row(row.data());
    }
    writer->finish();
}

}  // namespace

void save(const Frame& frame, const std::string& path, const ToneSettings& tone, vec4 behind) {
    write(frame, path, tone, behind);
}

void save(const Scene& scene, const std::string& path, Context& context) {
    try {
        validate(scene);
        const std::string ending = file_ending(path);
        const auto upright = [&] { return is_z_up(scene.source) ? with_y_up(scene, path, context.report()) : scene; };
        if (ending == "glb" || ending == "gltf") return io::write_glb(upright(), path, context);
        if (ending == "obj") return io::write_obj(placed_in_world(upright(), true, context), path, context);
        if (ending == "ply") {
            if (is_z_up(scene.source)) warn_of_z_up(path, context.report());
            return io::write_ply(scene, path, context);
        }
        throw Error(ErrorCode::usage, "a scene cannot be written with the ending '" + one_line(ending, 40) + "'", {},
                    "use .glb, .gltf, .obj or .ply");
    } catch (const Error& error) {
        throw error.with_file(path);
    }
}

std::vector<std::byte> encode(const Frame& frame, const std::string& ending, const ToneSettings& tone, vec4 behind) {
    std::vector<std::byte> bytes;
    try {
        if (!ending.starts_with('.')) throw Error(ErrorCode::usage, "endings begin with a dot: \".png\"");
        write(frame, {"frame" + ending, bytes}, tone, behind);
    } catch (const Error& error) {  // there is no file that it could be of
        throw Error(error.code(), error.reason(), error.place(), error.advice())
            .about(error.setting(), error.related());
    }
    return bytes;
}

std::vector<std::uint32_t> to_srgb8(const Frame& frame, const ToneSettings& tone, vec4 behind) {
    check_colors(frame, {});
    std::vector<std::uint32_t> codes(frame.color.size());
    convert_row(frame.color.data(), frame.color.size(), {Component::u8, 4}, ToneCurve(tone, behind),
                reinterpret_cast<std::byte*>(codes.data()));
    return codes;
}

}  // namespace rakelight
