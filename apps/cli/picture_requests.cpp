// SPDX-License-Identifier: Apache-2.0
// One request for each model on the command line, each with an output of its own.
#include <filesystem>
#include <string_view>

#include <rakelight/world.h>

#include "run.h"

namespace rakelight::cli {
namespace {

/// No "{...}" but "{model}".
void check_template(const std::string& output) {
    for (std::size_t at = 0; (at = output.find('{', at)) != std::string::npos; ++at)
        if (const std::size_t end = output.find('}', at);
            end != std::string::npos && std::string_view(output).substr(at, end + 1 - at) != "{model}")
            throw Error(ErrorCode::usage, "'" + one_line(output, 80) + "': only {model} is filled in");
}

Error no_name_for_each(std::string_view command) {
    if (command == "smooth")
        return Error(ErrorCode::usage, "several models need a name for each output", {},
                     "write for example -o 'out/{model}.glb'");
    if (command == "stages")
        return Error(ErrorCode::usage, "several models need a name for each folder", {},
                     "write for example -o 'out/{model}'");
    if (command == "compare")
        return Error(ErrorCode::usage, "several pairs need a name for each picture", {},
                     "write for example -o 'out/{model}.png', or one page: -o out.html");
    return Error(ErrorCode::usage, "several models need a name for each picture", {},
                 command == "inspect" ? "write for example --heatmap 'out/{model}.png'"
                                      : "write for example -o 'out/{model}.png'");
}

constexpr std::string_view mark = "{model}";

/// Without folder and ending.
std::string name_of(const std::string& input) {
    std::string stem = input.starts_with("builtin:") ? input.substr(8) : std::filesystem::path(input).stem().string();
    if (input.starts_with("builtin:"))  // of "sphere:radius=2" too a name
        for (char& c : stem) c = c == ':' || c == '=' || c == '/' ? '-' : c;
    if (is_world_file(input)) stem = std::filesystem::path(stem).stem().string();  // of NAME.scene.toml
    return stem;
}

}  // namespace

OutputNames::OutputNames(const Run& run, std::size_t inputs) : template_(run.picture.output) {
    check_template(template_);
    if (inputs > 1 && template_.find(mark) == std::string::npos) throw no_name_for_each(run.command.name);
}

std::string OutputNames::of(const std::string& input) {
    std::string output = template_;
    const std::string name = name_of(input);
    for (std::size_t at = 0; (at = output.find(mark, at)) != std::string::npos; at += name.size())
        output.replace(at, mark.size(), name);
    const auto [entry, is_new] = inputs_of_.emplace(std::filesystem::path(output).lexically_normal().string(), input);
    if (!is_new)
        throw Error(ErrorCode::usage, "'" + one_line(entry->second, 80) + "' and '" + one_line(input, 80) +
                                          "' would both be written to '" + one_line(output, 80) + "'");
    return output;
}

std::vector<InputRequest> picture_requests(const Run& run) {
    std::vector<InputRequest> requests;
    OutputNames names(run, run.inputs.size());
    for (const std::string& input : run.inputs) {
        InputRequest whole = request_for(run, input);
        whole.picture.output = names.of(input);
        requests.push_back(std::move(whole));
    }
    return requests;
}

}  // namespace rakelight::cli
