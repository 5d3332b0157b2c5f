// SPDX-License-Identifier: Apache-2.0
#include "output_names.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <string_view>

#include <rakelight/io/movie.h>
#include <rakelight/tools/compare.h>
#include <rakelight/world/values.h>
#include <rakelight_internal/base/file_ending.h>
#include <rakelight_internal/base/text.h>

#include "inputs.h"
#include "run.h"

namespace rakelight::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view known_parts[] = {"model", "ext", "dir", "n", "camera", "frame"};

Error no_name_for_each(std::string_view command) {
    const auto error = [](const char* what, const char* example) {
        return Error(ErrorCode::usage, std::string("several ") + what, {}, std::string("write for example ") + example);
    };
    if (command == "smooth")
        return error("models need a name for each output", "-o 'out/{model}.glb', or a folder: -o out/");
    if (command == "convert")
        return error("models need a name for each output",
                     "-o 'out/{model}.glb', or a folder: -o out/; --as-one puts them into one");
    if (command == "stages") return error("models need a name for each folder", "-o 'out/{model}'");
    if (command == "compare")
        return error("pairs need a name for each picture", "-o 'out/{model}.png', or one page: -o out.html");
    if (command == "inspect") return error("models need a name for each picture", "--heatmap 'out/{model}.png'");
    return error("models need a name for each picture",
                 "-o 'out/{model}.png', or a folder: -o out/; --as-one puts them into one");
}

/// A text that a file chose, as a name in a path: it leads to no other folder.
std::string as_name(std::string text) {
    if (text.find_first_not_of('.') == text.npos) text.assign(std::max<std::size_t>(text.size(), 1), '_');
    for (char& c : text) c = c == '/' ? '-' : c;
    return text;
}

/// Without folder and ending.
std::string name_of(const std::string& input) {
    if (input == "-" || input.starts_with("standard input")) return "stdin";
    std::string stem = input.starts_with("builtin:") ? input.substr(8) : fs::path(input).stem().string();
    if (input.starts_with("builtin:"))  // of "sphere:radius=2" too a name
        for (char& c : stem) c = c == ':' || c == '=' ? '-' : c;
    if (is_world_file(input)) stem = fs::path(stem).stem().string();  // of NAME.scene.toml
    return as_name(std::move(stem));
}

/// A number of at least so many digits: "{n:3}".
std::string padded(std::size_t number, std::string_view part) {
    const std::size_t colon = part.find(':');
    const int width = colon == part.npos ? 1 : std::min(9, std::atoi(std::string(part.substr(colon + 1)).c_str()));
    char text[32];
    std::snprintf(text, sizeof text, "%0*zu", width, number);
    return text;
}

/// "model" of "model"; "n" of "n:3".
std::string_view word_of(std::string_view part) { return part.substr(0, part.find(':')); }

/// Calls text(between) and part(in braces) in their order; doubled braces are braces.
template <class Text, class Part>
void walk(std::string_view pattern, const Text& text, const Part& part) {
    for (std::size_t at = 0; at < pattern.size();) {
        const std::string_view rest = pattern.substr(at);
        const std::size_t end = rest.find('}');
        if (rest.starts_with("{{") || rest.starts_with("}}")) {
            text(rest.substr(0, 1));
            at += 2;
        } else if (rest[0] == '{' && end != rest.npos) {
            part(rest.substr(1, end - 1));
            at += end + 1;
        } else {
            text(rest.substr(0, 1));
            ++at;
        }
    }
}

/// A text with its braces doubled, for a template, in which single braces are placeholders.
std::string doubled_braces(std::string_view text) {
    std::string doubled;
    for (const char c : text) doubled.append(c == '{' || c == '}' ? 2 : 1, c);
    return doubled;
}

bool is_number_part(std::string_view part) {
    const std::size_t colon = part.find(':');
    if (colon == part.npos) return true;
    const std::string_view digits = part.substr(colon + 1);
    return (word_of(part) == "n" || word_of(part) == "frame") && !digits.empty() &&
           std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; });
}

/// How many parts differ between inputs. @throws Error usage: an unknown one
std::size_t check_template(const std::string& output) {
    std::size_t differing = 0;
    walk(
        output, [](std::string_view) {},
        [&](std::string_view part) {
            const auto known = std::ranges::find(known_parts, word_of(part));
            if (known == std::end(known_parts) || !is_number_part(part))
                throw Error(
                    ErrorCode::usage,
                    "'" + one_line(output, 80) + "': {" + one_line(std::string(part), 40) + "} is no placeholder", {},
                    "write {model}, {ext}, {dir}, {n}, {camera} or {frame}; {n:3} has three digits");
            differing += word_of(part) != "camera" && word_of(part) != "frame";
        });
    return differing;
}

/// The ending of files that a command writes into a folder.
std::string ending_in_folder(const Run& run, const std::string& input) {
    if (std::string_view(run.command.name) == "convert") return "glb";
    if (std::string_view(run.command.name) != "smooth") {
        const std::string format = picture_format(run);
        return format.empty() ? "png" : format;
    }
    const std::string ending = file_ending(input);
    return ending == "gltf" || ending == "obj" || ending == "ply" ? ending : "glb";
}

std::string format_of(const Run& run, bool of_pictures) {
    if (!run.given.has("format")) return {};
    const std::string list = run.given.word("format");
    std::string found;
    for (const std::string_view word : values::split(list, ',')) {
        const std::string name = lower_case(word.starts_with('.') ? word.substr(1) : word);
        const bool is_picture = has_picture_ending("x." + name) || name == "ppm";
        if (!is_picture && !is_scene("x." + name))
            throw values::wrong("format", "'" + one_line(name, 40) + "' is neither a model format nor a picture format",
                                "write for example glb, obj, png or ppm");
        if (is_picture != of_pictures) continue;
        if (!found.empty()) throw values::wrong("format", "names two formats of the same kind");
        found = name;
    }
    return found;
}

}  // namespace

void check_picture_name(const Run& run) {
    const std::string& output = run.picture.output;
    if (output.empty() || means_folder(output) || is_standard_output(output)) return;
    if (is_scene(output) && !is_world_file(output))
        throw Error(ErrorCode::usage, "'" + one_line(output, 80) + "' names a model, not a picture", {},
                    "rakelight convert MODEL -o " + one_line(output, 80) + " writes models");
    if (!file_ending(output).empty()) return;
    const std::string name = one_line(output, 80);
    throw Error(ErrorCode::usage, "'" + name + "' has no ending that names a picture format", {},
                "write -o " + name + ".png, or for a folder -o " + name + "/");
}

std::string picture_format(const Run& run) { return format_of(run, true); }
std::string model_format(const Run& run) { return format_of(run, false); }

bool is_standard_output(const std::string& output) {
    if (output == "-") return true;
    const std::size_t colon = output.find(':');
    return output.ends_with(":-") && colon == output.size() - 2 && colon > 0;
}

OutputNames::OutputNames(const Run& run, std::size_t inputs) : OutputNames(run, inputs, run.picture.output) {}

OutputNames::OutputNames(const Run& run, std::size_t inputs, std::string output)
    : run_(run), template_(std::move(output)) {
    const std::size_t differing = check_template(template_);
    const bool writes_folders = std::string_view(run.command.name) == "stages";
    is_folder_ = !writes_folders && means_folder(template_);
    if (!is_folder_ && differing == 0 && inputs > 1) throw no_name_for_each(run.command.name);
}

std::string OutputNames::example_of_parts(const std::string& input) const {
    const std::string folder = is_folder_ ? one_line(template_, 80) : "out";
    return (fs::path(folder) / ("{model}-{ext}." + ending_in_folder(run_, input))).string();
}

std::string OutputNames::of(const std::string& input, const OutputParts& parts) {
    ++count_;
    const auto folder = run_.folders.find(input);
    const InputFolder lies = folder == run_.folders.end() ? InputFolder{".", "."} : folder->second;
    std::string output;
    const auto add = [&](std::string_view text) { output += parts.frame ? std::string(text) : doubled_braces(text); };
    walk(template_, add, [&](std::string_view part) {
        const std::string_view word = word_of(part);
        if (word == "model") add(name_of(input));
        if (word == "ext") add(as_name(file_ending(input)));
        if (word == "dir") add(lies.as_written);
        if (word == "n") add(padded(count_, part));
        if (word == "camera") add(as_name(parts.camera));
        if (word == "frame")
            output += parts.frame ? padded(std::size_t(*parts.frame), part) : "{" + std::string(part) + "}";
    });
    if (is_folder_) {
        if (!output.ends_with('/')) output += '/';
        add(lies.below + "/" + name_of(input) + "." + ending_in_folder(run_, input));
    }
    if (output != template_) output = fs::path(output).lexically_normal().string();
    const auto [entry, is_new] = inputs_of_.emplace(fs::path(output).lexically_normal().string(), input);
    if (!is_new)
        throw Error(ErrorCode::usage,
                    "'" + one_line(entry->second, 80) + "' and '" + one_line(input, 80) +
                        "' would both be written to '" + one_line(output, 80) + "'",
                    {}, "tell them apart by {ext}, {dir} or {n}, as in -o '" + example_of_parts(input) + "'");
    return output;
}

}  // namespace rakelight::cli
