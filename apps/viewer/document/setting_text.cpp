// SPDX-License-Identifier: Apache-2.0
#include "setting_text.h"

#include "commands.h"
#include "shell_words.h"

#include <algorithm>

#include <rakelight/version.h>
#include <rakelight/world/render_keys.h>

namespace rakelight::viewer {
namespace {

bool is_list(const std::string& key) { return require_render_key(key).kind == RenderKey::Kind::list; }

/// The request with one key set again, checked with all others. @throws Error usage
PictureRequest with_key(const PictureRequest& request, const std::string& key, const std::string& text) {
    PictureRequest plain = request;
    plain.settings.material_shading = PictureRequest().settings.material_shading;  // it has no key; see below
    std::vector<WorldValue> values = written_render_keys(plain);
    std::erase_if(values, [&](const WorldValue& value) {
        // The other method has its own number of samples.
        return value.key == key || (key == "preset" && is_preset_key(value.key)) ||
               (key == "method" && value.key == "samples");
    });
    if (!text.empty())
        values.push_back({.key = key,
                          .words = is_list(key) ? shell_words(text) : std::vector<std::string>{text},
                          .is_array = is_list(key)});
    PictureRequest changed;
    changed.input = request.input, changed.load = request.load;
    read_render_keys(values, changed);
    changed.settings.material_shading = request.settings.material_shading && key != "shading";
    return changed;
}

/// @throws Error usage: this build has no such engine
void require_engine(const std::string& name) {
    const std::vector<std::string> all = build_info().engines;
    if (name != "auto" && std::ranges::find(all, name) == all.end())
        throw Error(ErrorCode::usage, "there is no engine '" + one_line(name, 40) + "'");
}

}  // namespace

std::string setting_text(const PictureRequest& request, const std::string& key) {
    std::string text;
    for (const std::string& word : require_render_key(key).write(request))
        text += (text.empty() ? "" : " ") + (is_list(key) ? quoted(word) : word);
    return text;
}

void set_setting(Look& look, const std::string& key, const std::string& text) {
    PictureRequest changed = with_key(look.request, key, text);
    if (key == "engine") {
        require_engine(changed.engine);
        choose_engine(changed.engine, look);
    } else if (key == "method") {
        choose_method(changed.settings.method, look);
    } else {
        look.request = std::move(changed);
    }
}

}  // namespace rakelight::viewer
