// SPDX-License-Identifier: Apache-2.0
#include "view_command.h"

#include "picture_options.h"

namespace rakelight::apps {

Command view_command() {
    const Option stats = {
        "stats", "Output", "",
        "Print on exit how long the first picture, the window's longest pause and pictures in motion took", Form::flag};
    std::vector<Option> options =
        without(joined({{input_options()[0]}, picture_options(), {stats, shader_option()}, common_options()}),
                {"window", "channels", "channel-files", "exr-colors", "config", "json", "grid", "axis", "filename",
                 "metadata", "bar"});
    find(options, "resolution").help = "Size of the window in pixels, also WxH";
    return {"view",
            "Open models in a window",
            "Press H in the window for its keys. See also docs/viewer.md.",
            {{"MODEL", "Model or world files, or builtin:teapot, ...; left and right arrows step through them", false}},
            options};
}

void refuse_options_of_the_run(std::string_view key) {
    for (const std::string_view name :
         {"output", "help", "json", "quiet", "verbose", "stats", "threads", "max-memory", "allow-outside",
          "allow-shaders", "config", "recursive", "format", "as-one", "watch"})
        if (key == name)
            throw Error(ErrorCode::bad_file, "'" + std::string(key) + "' is an option of the command line only");
}

bool takes_setting(const Command& command, std::string_view key) {
    refuse_options_of_the_run(key);
    const Option* option = find_or_null(command.options, key);
    if (!option) option = find_or_null(command.of_worlds, key);
    return option && option->is_setting;
}

}  // namespace rakelight::apps
