// SPDX-License-Identifier: Apache-2.0
// Which reader a file goes to: the ending says the format, the first bytes are held against it.
#include "io/reader.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <new>
#include <span>
#include <string_view>
#include <utility>

#include <rakelight/base/report.h>
#include <rakelight/scene/validate.h>
#include <rakelight_internal/base/file_ending.h>

#include "base/left_out.h"
#include "io/content_kind.h"
#include "io/files/file.h"
#include "io/model_readers.h"

namespace rakelight::io {
namespace {

struct Format {
    std::string_view ending, name;
    const ModelReader* reader;
    bool has_meters;  ///< or says what its unit is; the others are numbers alone
};

constexpr Format formats[] = {
    {"gltf", "glTF 2.0", &gltf_reader, true}, {"glb", "GLB", &gltf_reader, true},
    {"obj", "OBJ", &obj_reader, false},       {"ply", "PLY", &ply_reader, false},
    {"off", "OFF", &off_reader, false},       {"stl", "STL", &stl_reader, false},
    {"xyz", "XYZ", &xyz_reader, false},       {"pts", "PTS", &xyz_reader, false},
#if RL_IMPORT
    {"fbx", "FBX", &import_reader, true},     {"dae", "DAE", &import_reader, true},
    {"3ds", "3DS", &import_reader, false},    {"ase", "ASE", &import_reader, false},
    {"blend", "Blend", &import_reader, true}, {"x", "X", &import_reader, false},
#endif
};

const Format* format_of(std::string_view ending) {
    for (const Format& f : formats)
        if (f.ending == ending) return &f;
    return nullptr;
}

constexpr std::size_t head_bytes = 64;  ///< that content_kind() looks at

/// The first bytes. What is no regular, readable file is refused in read_file()'s words.
std::vector<std::byte> head_of(const std::string& path, Context& context) {
    std::array<std::byte, head_bytes> head{};
    std::size_t got = 0;
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(
        is_regular_file(path) ? std::fopen(path.c_str(), "rb") : nullptr,
        [](std::FILE* f) { return f ? std::fclose(f) : 0; });
    if (file)
        got = std::fread(head.data(), 1, head.size(), file.get());
    else
        read_file(path, context);
    return {head.begin(), head.begin() + std::ptrdiff_t(got)};
}

[[noreturn]] void refuse_max() {
    throw Error(ErrorCode::bad_file, "3ds Max scene files (.max) can only be read by 3ds Max itself", {},
                "export FBX or glTF from 3ds Max instead");
}

/// Endings whose files another signature may begin: glTF may be binary or not; .blend may be compressed (no signature
/// here).
bool may_hold(const Format& format, const ContentKind& kind) {
    return kind.ending == format.ending ||
           (format.reader == &gltf_reader && (kind.ending == "glb" || kind.ending == "gltf"));
}

/// Endings of formats that the import helper would read.
bool is_left_out(const std::string& ending) {
    constexpr std::array<std::string_view, 6> endings{"fbx", "dae", "3ds", "ase", "blend", "x"};
    return !RL_IMPORT && std::ranges::find(endings, ending) != endings.end();
}

/// @param head  the first bytes of the file
const Format& choose_format(const std::string& path, std::span<const std::byte> head, Context& context) {
    const std::string ending = file_ending(path);
    const ContentKind kind = content_kind(head);
    if (ending == "max") refuse_max();
    if (head.empty()) throw Error(ErrorCode::bad_file, "the file is empty");
    const Format* format = format_of(ending);
    if (format) {
        if (!kind.is_certain || may_hold(*format, kind)) return *format;
        throw Error(ErrorCode::bad_file,
                    "the content is a " + std::string(kind.name) + ", not " + std::string(format->name), {},
                    format_of(kind.ending) ? "give it the ending ." + std::string(kind.ending) : std::string());
    }
    if (kind.ending == "max") refuse_max();
    format = format_of(kind.ending);
    if (!format && is_left_out(ending))
        throw left_out("files with the ending ." + ending, "Assimp", "RAKELIGHT_IMPORT");
    if (!format && ending == "toml")
        throw Error(ErrorCode::bad_file, "files with the ending .toml are not supported", {},
                    "world files end in .scene.toml");
    if (!format)
        throw Error(ErrorCode::bad_file,
                    ending.empty() ? "the file name has no ending that gives its format"
                                   : "files with the ending ." + ending + " are not supported",
                    {}, (ending.empty() ? "'format' names one; supported: " : "supported: ") + supported_formats())
            .naming({"format"});
    context.report().add(Remark::guessed, path, {}, "read as " + std::string(format->name) + " by its content");
    return *format;
}

/// Runs a reader, with the file's name in what goes wrong.
template <class Read>
Scene read_valid(const std::string& path, Context& context, const Read& read) {
    try {
        // What is read raises the allowance while anything is charged: from here until the scene's charges do it.
        const MemoryCharge reading(context.memory(), 1, "a model");
        Scene scene = read();
        validate(scene);
        return scene;
    } catch (const Error& e) {
        throw e.with_file(path);
    } catch (const std::bad_alloc&) {
        throw Error(ErrorCode::failed, "not enough memory to load it").with_file(path);
    }
}

}  // namespace

bool has_model_ending(const std::string& path) { return format_of(file_ending(path)) != nullptr; }

const char* length_unit(const std::string& path) {
    const Format* const format = format_of(file_ending(path));
    return format && !format->has_meters ? "units" : "m";
}

Scene read_scene(const std::string& path, const ReadOptions& options, Context& context) {
    return read_valid(path, context, [&] {
        return choose_format(path, head_of(path, context), context).reader->read(path, options, context);
    });
}

Scene read_scene(const std::string& path, Bytes bytes, const ReadOptions& options, Context& context) {
    return read_valid(path, context, [&] {
        const Format& format =
            choose_format(path, std::span(*bytes).first(std::min(head_bytes, bytes->size())), context);
        return format.reader->read_bytes(path, std::move(bytes), options, context);
    });
}

std::string supported_formats() {
    std::string names;
    for (const Format& f : formats) names += (names.empty() ? "" : ", ") + std::string(f.name);
    return names;
}

}  // namespace rakelight::io
