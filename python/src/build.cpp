// SPDX-License-Identifier: Apache-2.0
// What this build can do, and the keys of its settings.
#include <pybind11/stl.h>

#include <rakelight/io/world.h>
#include <rakelight/render/picture.h>
#include <rakelight/scene/words.h>
#include <rakelight/version.h>
#include <rakelight/world/render_keys.h>
#include <rakelight/world/world_request.h>

#include "scene.h"

namespace rakelight::python {
namespace {

py::dict build_as_dict() {
    const BuildInfo info = build_info();
    py::dict out;
    out["version"] = info.version;
    out["engines"] = info.engines;
    out["model_formats"] = info.model_formats;
    out["image_formats_read"] = info.image_formats_read;
    out["image_formats_written"] = info.image_formats_written;
    out["instruction_set"] = info.isa;
    out["threads"] = info.threads;
    out["left_out"] = info.left_out;
    return out;
}

/// {key: whether it takes a list of any length}
py::dict keys_as_dict() {
    py::dict out;
    for (const RenderKey& key : render_keys()) out[key.name] = key.kind == RenderKey::Kind::list;
    return out;
}

}  // namespace

std::vector<WorldValue> values_of(const Settings& settings) {
    std::vector<WorldValue> values;
    for (const auto& [key, words] : settings) values.push_back({.key = key, .words = words});
    return values;
}

PictureRequest request_of(const SceneHandle& handle, const Settings& settings, Context& context) {
    const std::vector<WorldValue> values = values_of(settings);
    PictureRequest request;
    if (!handle.world.empty()) {
        request = read_world_request(handle.world, handle.load, {values, {}}, context).picture;
    } else {
        request.look = Look::standard;
        read_render_keys(values, request);
        request.settings.material_shading = !sets_shading(values);
    }
    request.input = handle.scene.source;
    return request;
}

void define_build(py::module_& module) {
    module.def("build_info", &build_as_dict);
    module.def("setting_keys", &keys_as_dict);
    module.def("channel_words", &channel_words);
    module.def("nearest_word", [](const std::string& word, const std::vector<std::string>& words) {
        return nearest_word(word, {words.begin(), words.end()});
    });
    module.attr("__version__") = RAKELIGHT_VERSION;
}

}  // namespace rakelight::python
