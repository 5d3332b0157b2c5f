// SPDX-License-Identifier: Apache-2.0
#include "io/content_kind.h"

namespace rakelight::io {
namespace {

using namespace std::string_view_literals;

struct Signature {
    std::string_view bytes;
    ContentKind kind;
};

constexpr Signature signatures[] = {
    {"glTF"sv, {"GLB", "glb", true}},
    {"Kaydara FBX Binary"sv, {"FBX", "fbx", true}},
    {"BLENDER"sv, {"Blend", "blend", true}},
    {"xof 0"sv, {"DirectX X", "x", true}},
    {"*3DSMAX_ASCIIEXPORT"sv, {"ASE", "ase", true}},
    {"\xFF\xFE*\0003\0D\0S\0"sv, {"ASE", "ase", true}},
    {"\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1"sv, {"3ds Max (or another compound file)", "max", true}},
    {"\x89PNG\r\n\x1A\n"sv, {"PNG picture", "", true}},
    {"\xFF\xD8\xFF"sv, {"JPEG picture", "", true}},
    {"GIF8"sv, {"GIF picture", "", true}},
    {"II*\0"sv, {"TIFF picture", "", true}},
    {"MM\0*"sv, {"TIFF picture", "", true}},
    {"\x76\x2F\x31\x01"sv, {"OpenEXR picture", "", true}},
    {"#?RADIANCE"sv, {"Radiance picture", "", true}},
    {"DDS "sv, {"DDS picture", "", true}},
    {"\xABKTX "sv, {"KTX picture", "", true}},
    {"%PDF-"sv, {"PDF document", "", true}},
    {"PK\3\4"sv, {"ZIP archive", "", true}},
    {"7z\xBC\xAF\x27\x1C"sv, {"7z archive", "", true}},
    {"Rar!\x1A"sv, {"RAR archive", "", true}},
    {"\x7F"
     "ELF"sv,
     {"ELF program", "", true}},
    {"ply\n"sv, {"PLY", "ply", false}},
    {"ply\r"sv, {"PLY", "ply", false}},
    {"solid "sv, {"STL", "stl", false}},
    {"; FBX "sv, {"FBX", "fbx", false}},
    {"OFF"sv, {"OFF", "off", false}},
    {"{"sv, {"glTF", "gltf", false}},
    {"# Blender"sv, {"OBJ", "obj", false}},
};

}  // namespace

ContentKind content_kind(std::span<const std::byte> head) {
    std::string_view text{reinterpret_cast<const char*>(head.data()), head.size()};
    for (const Signature& s : signatures)
        if (text.substr(0, s.bytes.size()) == s.bytes) return s.kind;
    if (text.size() >= 12 && text.substr(0, 4) == "RIFF" && text.substr(8, 4) == "WEBP")
        return {"WebP picture", "", true};
    if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
    const std::size_t start = text.find_first_not_of(" \t\r\n");
    if (start == std::string_view::npos) return {};
    text.remove_prefix(start);
    if (text[0] == '{') return {"glTF", "gltf", false};
    if (text.substr(0, 8) == "<COLLADA" || text.substr(0, 5) == "<?xml") return {"DAE", "dae", false};
    return {};
}

}  // namespace rakelight::io
