// SPDX-License-Identifier: Apache-2.0
#include "smooth_verb.h"

#include <CLI/CLI.hpp>

#include <algorithm>

#include <rakelight/world.h>

#include "options.h"
#include "run_file.h"
#include "values.h"

namespace rakelight::cli {

void add_smooth_options(CLI::App& app, SmoothWords& w) {
    const auto add = [&](const char* group, const char* name, std::string& value, const char* type, const char* help) {
        return app.add_option(name, value, help)->type_name(type)->group(group);
    };
    add("Output", "-o,--output", w.output, "FILE",
        "File to write, may be the model itself: .glb or .gltf from glTF and .obj from OBJ (everything else of the "
        "file is "
        "kept), .glb or .ply from any format. {model} stands for the model's name")
        ->required();
    add("Normals", "--scope", w.scope, "WHICH",
        "Over what normals are smoothed: model (default: all objects, no seams), object, face (flat)");
    add("Normals", "--crease-angle", w.crease_angle, "DEG",
        "Edges bent more than this stay sharp, 0 to 180 (default 60)");
    add("Normals", "--weight", w.weight, "HOW",
        "How a triangle pulls on a normal: angle (default), uniform, area, angle-area");
    add("Normals", "--weld-distance", w.weld_distance, "M",
        "Positions of different objects at most this far apart [m] count as one (default: equal, but for rounding)");
    add("Normals", "--tangents", w.tangents, "WHICH",
        "auto (default: where there is a normal map or tangents were), always (where there are texture coordinates), "
        "never");
    app.add_flag("--keep-instances", w.keep_instances,
                 "glTF: instances go on sharing a mesh even where they touch different things")
        ->group("Normals");
}

void apply(const SmoothWords& w, SmoothFileOptions& options) {
    AttributeOptions& a = options.attributes;
    if (!w.scope.empty())
        a.scope =
            word<Scope>("scope", w.scope, {{"model", Scope::model}, {"object", Scope::object}, {"face", Scope::face}});
    if (!w.weight.empty())
        a.weight = word<CornerWeight>("weight", w.weight,
                                      {{"angle", CornerWeight::angle},
                                       {"uniform", CornerWeight::uniform},
                                       {"area", CornerWeight::area},
                                       {"angle-area", CornerWeight::angle_area}});
    if (!w.tangents.empty())
        options.tangents = word<TangentChoice>(
            "tangents", w.tangents,
            {{"auto", TangentChoice::automatic}, {"always", TangentChoice::always}, {"never", TangentChoice::never}});
    if (!w.weld_distance.empty()) {
        a.weld_distance = number("weld-distance", w.weld_distance);
        if (!(a.weld_distance >= 0)) throw wrong("weld-distance", "must be 0 or more");
    }
    if (!w.crease_angle.empty()) {
        const double angle = number("crease-angle", w.crease_angle);
        if (!(angle >= 0 && angle <= 180)) throw wrong("crease-angle", "must be 0 to 180 degrees");
        a.crease_angle_rad = angle == 180 ? pi : radians(angle);
    }
    options.keep_instances = w.keep_instances;
}

int run_smooth(const Options& options) {
    std::vector<SmoothedFileRow> rows;
    int worst = 0;
    SmoothFileOptions smooth = options.smooth;
    smooth.load = options.picture.load;
    for (const InputRequest& input : picture_requests(options)) {
        const PictureRequest& request = input.picture;
        if (CancelOnInterrupt::happened()) break;
        SmoothedFileRow& row = rows.emplace_back();
        row.file = request.input;
        const int code = run_file(options, request.input, row, [&](Context& c) {
            if (is_world_file(request.input))
                throw Error(ErrorCode::usage, "world files are not smoothed", {}, "smooth their models");
            row.result = smooth_file(request.input, request.output, smooth, c);
        });
        if (code == 0) print_note(summary(*row.result), options.loudness);
        worst = std::max(worst, code);
    }
    if (options.json) print_data(to_json(rows));
    return worst;
}

}  // namespace rakelight::cli
