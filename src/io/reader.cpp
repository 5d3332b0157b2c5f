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

#include <programs/base/file_ending.h>
#include <rakelight/base/report.h>
#include <rakelight/scene/validate.h>

#include "base/left_out.h"
#include "io/content_kind.h"
#include "io/files/file.h"
#include "io/files/plain_text.h"
#include "io/gltf/read_gltf.h"
#include "io/obj/read_obj.h"
#include "io/ply/read_off.h"
#include "io/ply/read_ply.h"
#include "io/read_xyz.h"

namespace rakelight::io {
namespace {

enum class Reader : std::uint8_t { gltf, obj, ply, off, xyz, import_helper };

struct Format {
    std::string_view ending, name;
    Reader reader;
    bool has_meters;  ///< or says what its unit is; the others are numbers alone
};

constexpr Format formats[] = {
    {"gltf", "glTF 2.0", Reader::gltf, true},
    {"glb", "GLB", Reader::gltf, true},
    {"obj", "OBJ", Reader::obj, false},
    {"ply", "PLY", Reader::ply, false},
    {"off", "OFF", Reader::off, false},
    {"xyz", "XYZ", Reader::xyz, false},
    {"pts", "PTS", Reader::xyz, false},
#if RL_IMPORT
    {"fbx", "FBX", Reader::import_helper, true},
    {"dae", "DAE", Reader::import_helper, true},
    {"3ds", "3DS", Reader::import_helper, false},
    {"ase", "ASE", Reader::import_helper, false},
    {"blend", "Blend", Reader::import_helper, true},
    {"stl", "STL", Reader::import_helper, false},
    {"x", "X", Reader::import_helper, false},
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
           (format.reader == Reader::gltf && (kind.ending == "glb" || kind.ending == "gltf"));
}

/// Endings of formats that the import helper would read.
bool is_left_out(const std::string& ending) {
    constexpr std::array<std::string_view, 7> endings{"fbx", "dae", "3ds", "ase", "blend", "stl", "x"};
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

Scene read_as(const Format& format, const std::string& path, const ReadOptions& options, Context& context) {
    switch (format.reader) {
        case Reader::gltf:
            return read_gltf(path, options, context);
        case Reader::obj:
            return read_obj(path, options, context);
        case Reader::ply:
            return read_ply(path, options, context);
        case Reader::off:
            return read_off(path, options, context);
        case Reader::xyz:
            return read_xyz(path, options, context);
        case Reader::import_helper:
            return read_with_import_helper(path, options, context);
    }
    return {};
}

std::string_view text_of(const Bytes& bytes) { return {reinterpret_cast<const char*>(bytes->data()), bytes->size()}; }

Scene read_as(const Format& format, const std::string& path, Bytes bytes, const ReadOptions& options,
              Context& context) {
    switch (format.reader) {
        case Reader::gltf:
            return gltf::read_gltf_bytes(path, std::move(bytes), options, context);
        case Reader::obj:
            return obj::read_obj_text(PlainText(text_of(bytes), path, context).view(), path, options, context);
        case Reader::ply:
            return ply::read_ply_bytes(text_of(bytes), path, options, context);
        case Reader::off:
            return ply::read_off_text(text_of(bytes), path, context);
        case Reader::xyz:
            return read_xyz_text(text_of(bytes), path, context);
        case Reader::import_helper:
            return read_with_import_helper(path, bytes, options, context);
    }
    return {};
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
        return read_as(choose_format(path, head_of(path, context), context), path, options, context);
    });
}

Scene read_scene(const std::string& path, Bytes bytes, const ReadOptions& options, Context& context) {
    return read_valid(path, context, [&] {
        const Format& format =
            choose_format(path, std::span(*bytes).first(std::min(head_bytes, bytes->size())), context);
        return read_as(format, path, std::move(bytes), options, context);
    });
}

std::string supported_formats() {
    std::string names;
    for (const Format& f : formats) names += (names.empty() ? "" : ", ") + std::string(f.name);
    return names;
}

}  // namespace rakelight::io
