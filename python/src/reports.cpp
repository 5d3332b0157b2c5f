// SPDX-License-Identifier: Apache-2.0
// Explanations, inspections, files written: what the program's JSON says, as text that the package reads.
#include <pybind11/stl.h>

#include <rakelight/render/picture.h>
#include <rakelight/scene/motion.h>
#include <rakelight/tools/convert_file.h>
#include <rakelight/tools/explain.h>
#include <rakelight/tools/inspect.h>
#include <rakelight/tools/rows.h>
#include <rakelight/tools/smooth_file.h>
#include <rakelight/world/render_keys.h>
#include <rakelight/world/values.h>

#include "errors.h"
#include "options.h"
#include "run.h"
#include "scene.h"

namespace rakelight::python {
namespace {

/// [(JSON, text)], one a pixel.
py::tuple explained(const SceneHandle& handle, const Settings& settings, const std::vector<std::pair<int, int>>& pixels,
                    int threads, const py::object& progress) {
    Runner runner(threads, 0);
    struct Texts {
        std::string json, text;
    };
    const std::vector<Texts> texts = runner.run(progress, [&] {
        std::vector<Texts> out;
        const PictureRequest request = request_of(handle, settings, runner.context());
        for (const auto& [x, y] : pixels) {
            ExplainRow row;
            row.file = handle.scene.source, row.x = x, row.y = y;
            row.pixel = explain(handle.scene, request, x, y, runner.context());
            out.push_back({to_json(std::span(&row, 1)), to_text(*row.pixel)});
        }
        return out;
    });
    py::list list;
    for (const Texts& t : texts) list.append(py::make_tuple(text_of(t.json), text_of(t.text)));
    return py::make_tuple(list, remarks_of(runner.context().report()));
}

constexpr Word<bool CheckLimits::*> limit_flags[] = {
    {"no-degenerate", &CheckLimits::no_degenerate},     {"no-t-junctions", &CheckLimits::no_t_junctions},
    {"no-non-manifold", &CheckLimits::no_non_manifold}, {"consistent-winding", &CheckLimits::consistent_winding},
    {"no-inside-out", &CheckLimits::no_inside_out},     {"closed", &CheckLimits::closed},
    {"unit-normals", &CheckLimits::unit_normals}};

std::vector<std::string> limit_words() {
    std::vector<std::string> words = {"max-seam"};
    for (const auto& flag : limit_flags) words.emplace_back(flag.name);
    return words;
}

/// Limits by their options' names; "max-seam" has a number, the others are on or off.
CheckLimits limits_of(const py::dict& given) {
    CheckLimits limits;
    for (const auto& [key, value] : given) {
        const std::string name = py::cast<std::string>(key);
        if (name == "max-seam") {
            limits.max_seam_deg.reset();
            if (!value.is_none()) limits.max_seam_deg = py::cast<double>(value);
        } else {
            limits.*values::word("check", name, limit_flags) = py::cast<bool>(value);
        }
    }
    return limits;
}

/// @param check  limits; None: none are checked
py::tuple inspected(const SceneHandle& handle, const Settings& settings, bool borders, bool surfaces,
                    const py::object& check, int threads, const py::object& progress) {
    Runner runner(threads, 0);
    std::optional<CheckLimits> limits;
    if (!check.is_none()) limits = limits_of(py::dict(check));
    const std::string json = runner.run(progress, [&] {
        Context& context = runner.context();
        PictureRequest request;
        read_render_keys(values_of(settings), request);
        InspectOptions options;
        options.borders = borders, options.surfaces = surfaces, options.prepare = request.prepare;
        options.weld_distance = request.prepare.weld_distance;
        options.border_distance = request.prepare.border_distance;
        InspectionRow row;
        row.file = handle.scene.source;
        row.inspection =
            inspect(scene_at(handle.scene, clips_of(handle.scene, request.motion), context.memory()), options, context);
        replace_images(row.inspection->scene, handle.as_named);
        if (limits) row.check = check_limits(*row.inspection, *limits);
        return to_json(std::span(&row, 1));
    });
    return py::make_tuple(text_of(json), remarks_of(runner.context().report()));
}

/// @param normals  "seams", "model", "object", "face"
py::tuple smoothed_file(const std::string& input, const std::string& output, const std::string& normals,
                        const std::string& tangents, double border_distance, bool allow_outside,
                        const py::dict& attributes, int threads, const py::object& progress) {
    constexpr Word<TangentChoice> choices[] = {
        {"auto", TangentChoice::automatic}, {"always", TangentChoice::always}, {"never", TangentChoice::never}};
    SmoothFileOptions options;
    options.attributes = attribute_options(attributes);
    options.authored = normals == "seams" ? AuthoredNormals::seams : AuthoredNormals::replaced;
    options.tangents = values::word("tangents", tangents, choices);
    options.border_distance = border_distance;
    options.load.allow_outside = allow_outside;
    Runner runner(threads, 0);
    const std::string json = runner.run(progress, [&] {
        SmoothedFileRow row;
        row.file = input;
        row.result = smooth_file(input, output, options, runner.context());
        return to_json(std::span(&row, 1));
    });
    return py::make_tuple(text_of(json), remarks_of(runner.context().report()));
}

py::tuple converted_file(const std::string& input, const std::string& output, bool allow_outside, int threads,
                         const py::object& progress) {
    Runner runner(threads, 0);
    const std::string json = runner.run(progress, [&] {
        ConvertedFileRow row;
        row.result = convert_file(input, output, {.allow_outside = allow_outside}, runner.context());
        return to_json(std::span(&row, 1));
    });
    return py::make_tuple(text_of(json), remarks_of(runner.context().report()));
}

py::tuple rendered_file(const SceneHandle& handle, const std::string& output, const Settings& settings, int threads,
                        const py::object& progress) {
    Runner runner(threads, 0);
    const std::string json = runner.run(progress, [&] {
        PictureRequest request = request_of(handle, settings, runner.context());
        request.output = output;
        PictureRow row;
        row.result = render_picture(handle.scene, request, runner.context());
        return to_json(std::span(&row, 1));
    });
    return py::make_tuple(text_of(json), remarks_of(runner.context().report()));
}

}  // namespace

void define_reports(py::module_& module) {
    module.def("explain", &explained);
    module.def("inspect", &inspected);
    module.def("limit_words", &limit_words);
    module.def("render_file", &rendered_file);
    module.def("smooth_file", &smoothed_file);
    module.def("convert_file", &converted_file);
}

}  // namespace rakelight::python
