// SPDX-License-Identifier: Apache-2.0
#include "smooth_verb.h"

#include <algorithm>

#include <rakelight/tools/rows.h>
#include <rakelight/tools/values.h>

#include "../common/picture_options.h"
#include "help_texts.h"
#include "interrupt.h"
#include "run_file.h"

namespace rakelight::cli {

Command smooth_command() {
    using enum apps::Form;
    std::vector<Option> shared = apps::picture_options();
    Option keep = apps::find(shared, "keep-instances");
    keep.help = "glTF: instances go on sharing a mesh even where they touch different things";
    return {"smooth",
            "Write models back with seam-free normals and tangents",
            smooth_footer,
            {{"MODEL", "Model files, or builtin:teapot, builtin:sphere:tolerance=0.01, ..."}},
            apps::joined({{{.name = "output",
                            .group = "Output",
                            .type = "FILE",
                            .help = "File to write, may be the model itself: .glb or .gltf from glTF and .obj from OBJ "
                                    "(everything else of the file is kept), .glb or .ply from any format. {model} "
                                    "stands for the model's name",
                            .is_required = true,
                            .letter = 'o'},
                           {"scope", "Normals", "WHICH",
                            "Over what normals are smoothed: model (default: all objects, no seams), object, face "
                            "(flat)"},
                           apps::find(shared, "crease-angle"),
                           apps::find(shared, "weight"),
                           {"weld-distance", "Normals", "M",
                            "Positions of different objects at most this far apart [m] count as one (default: equal, "
                            "but for rounding)"},
                           {"tangents", "Normals", "WHICH",
                            "auto (default: where there is a normal map or tangents were), always (where there are "
                            "texture coordinates), never"},
                           keep},
                          apps::common_options()})};
}

namespace {

SmoothFileOptions smooth_options(const Run& run) {
    constexpr Word<Scope> scopes[] = {{"model", Scope::model}, {"object", Scope::object}, {"face", Scope::face}};
    constexpr Word<TangentChoice> choices[] = {
        {"auto", TangentChoice::automatic}, {"always", TangentChoice::always}, {"never", TangentChoice::never}};
    SmoothFileOptions options;
    AttributeOptions& a = options.attributes;
    a.crease_angle_rad = run.picture.prepare.crease_angle_rad;
    a.weight = run.picture.prepare.weight;
    if (run.given.has("scope")) a.scope = values::word("scope", run.given.word("scope"), scopes);
    if (run.given.has("tangents")) options.tangents = values::word("tangents", run.given.word("tangents"), choices);
    if (run.given.has("weld-distance")) {
        a.weld_distance = values::number("weld-distance", run.given.word("weld-distance"));
        if (!(a.weld_distance >= 0)) throw values::wrong("weld-distance", "must be 0 or more");
    }
    options.keep_instances = run.picture.prepare.keep_instances;
    options.load = run.picture.load;
    return options;
}

}  // namespace

int run_smooth(const Run& run) {
    const SmoothFileOptions options = smooth_options(run);
    std::vector<SmoothedFileRow> rows;
    int worst = 0;
    for (const InputRequest& input : picture_requests(run)) {
        const PictureRequest& request = input.picture;
        if (CancelOnInterrupt::happened()) break;
        SmoothedFileRow& row = rows.emplace_back();
        row.file = request.input;
        const int code = run_file(run, request.input, row, [&](Context& c) {
            if (is_world_file(request.input))
                throw Error(ErrorCode::usage, "world files are not smoothed", {}, "smooth their models");
            row.result = smooth_file(request.input, request.output, options, c);
        });
        if (code == 0) print_note(summary(*row.result), run.loudness);
        worst = std::max(worst, code);
    }
    if (run.is_json) print_data(to_json(rows));
    return worst;
}

}  // namespace rakelight::cli
