// SPDX-License-Identifier: Apache-2.0
#include <rakelight/tools/convert_file.h>
#include <rakelight_internal/base/text.h>

#include <nlohmann/json.hpp>

#include <rakelight_internal/base/file_ending.h>

#include "base/format_text.h"
#include "io/files/beside.h"
#include "io/files/file.h"
#include "io/files/held_outputs.h"
#include "io/obj/write/rewrite_normals.h"
#include "tools/report_json.h"
#include "tools/smooth/model_rewrite.h"

namespace rakelight {
namespace {

bool is_plain_copy(const ModelRewrite& model) {
    return model.way == RewriteWay::obj_in_place ||
           (model.way == RewriteWay::new_ply && is_one_file(model.input, model.load) &&
            file_ending(model.input) == "ply");
}

void copy(const ModelRewrite& model, Context& context) {
    if (model.way == RewriteWay::obj_in_place)
        io::copy_obj(model.input, model.output, {.allow_outside = model.load.allow_outside}, context);
    else
        io::write_file(model.output, *io::read_file(model.input, context));
}

void count(const Scene& scene, ConvertedFile& result) {
    for (const Mesh& mesh : scene.meshes) {
        if (mesh.topology != Topology::triangles || mesh.indices.empty()) continue;
        ++result.meshes;
        result.without_normals += mesh.normals.empty();
    }
}

}  // namespace

ConvertedFile convert_file(const std::string& input, const std::string& output, const LoadOptions& options,
                           Context& context) {
    const ModelRewrite model = begin_rewrite(input, output, options, context);
    ConvertedFile result{input, model.output};
    count(model.before, result);
    io::HeldOutputs outputs;
    result.is_copy = is_plain_copy(model);
    if (result.is_copy) {
        context.throw_if_cancelled();
        context.progress("write", 0);
        copy(model, context);
    } else {
        SmoothedFile written;
        finish_rewrite(model, model.before, {.keep_unused = true}, written, context);
        result.is_copy = model.way == RewriteWay::gltf_in_place && file_ending(input) == file_ending(output);
    }
    outputs.commit();
    if (result.without_normals > 0 && !result.is_copy)
        context.report().add(
            Remark::note, input, {},
            format_text("{} of {} meshes have no normals, and none were made: 'rakelight smooth' makes them",
                        result.without_normals, result.meshes));
    return result;
}

std::string summary(const ConvertedFile& result) {
    if (result.is_copy) return result.output + ": the same format, copied";
    return result.output + ": " + counted(result.meshes, "mesh", "meshes") + " written";
}

std::string to_json(std::span<const ConvertedFileRow> rows) {
    Json list = Json::array();
    for (const ConvertedFileRow& row : rows) {
        Json json = {{"file", row.result.file}, {"output", row.result.output}};
        if (row.error)
            json["error"] = error_json(*row.error);
        else
            json.update({{"copied", row.result.is_copy},
                         {"meshes", row.result.meshes},
                         {"meshes_without_normals", row.result.without_normals}});
        json["remarks"] = remarks_json(row.remarks);
        json["remarks_left_out"] = row.remarks_left_out;
        list.push_back(std::move(json));
    }
    return document("rakelight.convert/1", std::move(list));
}

}  // namespace rakelight
