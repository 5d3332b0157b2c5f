// SPDX-License-Identifier: Apache-2.0
// FBX, 3DS, Blend: files of nested blocks with their sizes in front, so a truncation or shift is detected at once.
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

#include "base/format_text.h"
#include "io/import/precheck.h"

namespace rakelight::io {
namespace {

std::string_view text_of(const Suspect& s) { return {reinterpret_cast<const char*>(s.bytes.data()), s.bytes.size()}; }

template <class T>
T little(std::span<const std::byte> bytes, std::uint64_t at) {  // the caller has checked that it is there
    T v;
    std::memcpy(&v, bytes.data() + at, sizeof v);
    return v;
}

[[noreturn]] void cut_short(const char* what, std::uint64_t at) {
    throw Error(ErrorCode::bad_file, std::string(what) + "; the file is cut short or damaged",
                "byte " + std::to_string(at));
}

// --- FBX -------------------------------------------------------------------------------------------------------------------

struct FbxNode {
    std::uint64_t end = 0, properties = 0, property_bytes = 0, name_bytes = 0, header = 0;
};

FbxNode read_fbx_node(std::span<const std::byte> bytes, std::uint64_t at, bool wide) {
    const std::uint64_t header = wide ? 25 : 13;
    if (bytes.size() < header || at > bytes.size() - header) cut_short("a node's header runs past the end", at);
    FbxNode n;
    n.header = header;
    if (wide)
        n = {little<std::uint64_t>(bytes, at), little<std::uint64_t>(bytes, at + 8),
             little<std::uint64_t>(bytes, at + 16), 0, header};
    else
        n = {little<std::uint32_t>(bytes, at), little<std::uint32_t>(bytes, at + 4),
             little<std::uint32_t>(bytes, at + 8), 0, header};
    n.name_bytes = std::to_integer<std::uint64_t>(bytes[at + header - 1]);
    return n;
}

/// Nested nodes, without recursion: a stack holds the ends of the open ones.
void walk_fbx(std::span<const std::byte> bytes, bool wide) {
    std::uint64_t at = 27;
    std::vector<std::uint64_t> ends;
    for (;;) {
        if (!ends.empty() && at == ends.back()) {
            ends.pop_back();
            continue;
        }
        const FbxNode n = read_fbx_node(bytes, at, wide);
        if (n.end == 0) {  // a record of zeros ends a list of nodes
            at += n.header;
            if (ends.empty()) return;
            if (at != ends.back()) cut_short("a list of nodes ends before its node does", at);
            continue;
        }
        const std::uint64_t limit = ends.empty() ? bytes.size() : ends.back();
        if (n.end > limit || n.end < at + n.header) cut_short("a node runs past the end", at);
        const std::uint64_t room = n.end - at - n.header;
        if (n.name_bytes > room || n.property_bytes > room - n.name_bytes)
            cut_short("a node's properties run past its end", at);
        if (ends.size() > 200) cut_short("nodes are nested too deeply", at);
        at += n.header + n.name_bytes + n.property_bytes;
        ends.push_back(n.end);
    }
}

void check_ascii_fbx(const Suspect& s) {
    const std::string_view text = text_of(s);
    if (text.substr(0, 4096).find("FBX") == std::string_view::npos) throw Error(ErrorCode::bad_file, "not an FBX file");
    const long long open = open_braces(s.bytes);
    if (open != 0)
        throw Error(ErrorCode::bad_file, open > 0 ? "the text ends inside a block; the file is cut short or damaged"
                                                  : "a block is closed that was never opened");
}

// --- 3DS -------------------------------------------------------------------------------------------------------------------

bool is_3ds_container(std::uint16_t id) {
    switch (id) {
        case 0x4D4D:
        case 0x3D3D:
        case 0x4100:
        case 0xAFFF:
        case 0xB000:
        case 0xA200:
        case 0xA204:
        case 0xA210:
        case 0xA220:
        case 0xA230:
        case 0xA33A:
        case 0xA33C:
        case 0xA33D:
        case 0xA33E:
            return true;
        default:
            return false;
    }
}

/// Where the blocks inside a block begin: an object (0x4000) has its name in front of them. 0: it holds none.
std::uint64_t inside_of_3ds(std::span<const std::byte> bytes, std::uint16_t id, std::uint64_t at, std::uint64_t end) {
    if (is_3ds_container(id)) return at;
    if (id != 0x4000) return 0;
    while (at < end && bytes[at] != std::byte(0)) ++at;
    if (at == end) cut_short("an object's name has no end", at);
    return at + 1;
}

/// What the faces of one 3DS mesh say twice: vertex numbers against the number of vertices, and the faces that the material
/// lists name against one another.
class Faces3ds {
public:
    explicit Faces3ds(const Suspect& s) : s_(s) {}
    void vertices(std::uint64_t begin, std::uint64_t end) {
        if (end - begin >= 2) vertex_count_ = little<std::uint16_t>(s_.bytes, begin);
        if (2 + vertex_count_ * 12 > end - begin) cut_short("a list of vertices runs past its block", begin);
    }
    /// @return where the blocks behind the list begin
    std::uint64_t faces(std::uint64_t begin, std::uint64_t end) {
        const std::uint64_t count = end - begin >= 2 ? little<std::uint16_t>(s_.bytes, begin) : 0;
        if (2 + count * 8 > end - begin) cut_short("a list of faces runs past its block", begin);
        listed_.assign(count, false);
        for (std::uint64_t f = 0; f < count; ++f)
            for (std::uint64_t k = 0; k < 3; ++k)
                if (little<std::uint16_t>(s_.bytes, begin + 2 + f * 8 + k * 2) >= vertex_count_)
                    wrong("faces have vertex numbers out of range");
        return begin + 2 + count * 8;
    }
    void material(std::uint64_t begin, std::uint64_t end) {
        while (begin < end && s_.bytes[begin] != std::byte(0)) ++begin;
        if (end - begin < 3) return;
        const std::uint64_t count = little<std::uint16_t>(s_.bytes, begin + 1);
        if (3 + count * 2 > end - begin) cut_short("a list of faces of a material runs past its block", begin);
        for (std::uint64_t i = 0; i < count; ++i) {
            const auto face = little<std::uint16_t>(s_.bytes, begin + 3 + i * 2);
            if (face >= listed_.size() || listed_[face])
                wrong("materials name faces that do not exist or already have a material");
            else
                listed_[face] = true;
        }
    }

private:
    void wrong(const char* what) {
        s_.report.add(Remark::warning, s_.path, {}, std::string(what) + "; the file is probably damaged");
    }
    const Suspect& s_;
    std::uint64_t vertex_count_ = 0;
    std::vector<bool> listed_;
};

/// Looks at a block; returns where the blocks inside it begin, 0 when it holds none.
std::uint64_t enter_3ds(const Suspect& s, Faces3ds& faces, std::uint16_t id, std::uint64_t begin, std::uint64_t end) {
    if (id == 0x4110) faces.vertices(begin, end);
    if (id == 0x4130) faces.material(begin, end);
    return id == 0x4120 ? faces.faces(begin, end) : inside_of_3ds(s.bytes, id, begin, end);
}

void check_fbx(const Suspect& s) {
    constexpr std::string_view binary("Kaydara FBX Binary  \0\x1a\0", 23);
    const std::string_view text = text_of(s);
    if (!text.starts_with(binary.substr(0, 18))) return check_ascii_fbx(s);
    if (!text.starts_with(binary) || text.size() < 27) throw Error(ErrorCode::bad_file, "the FBX header is damaged");
    const auto version = little<std::uint32_t>(s.bytes, 23);
    if (version < 7100)
        throw Error(ErrorCode::bad_file,
                    format_text("binary FBX of version {} is not supported (7100 or newer is)", version), {},
                    "save it as FBX 2013 or newer, or as glTF");
    if (version > 7900) throw Error(ErrorCode::bad_file, "unknown FBX version " + std::to_string(version));
    walk_fbx(s.bytes, version >= 7500);
}

void check_3ds(const Suspect& s) {
    struct Open {
        std::uint64_t at, end;
    };
    const std::uint64_t size = s.bytes.size();
    if (size < 6 || little<std::uint16_t>(s.bytes, 0) != 0x4D4D)
        throw Error(ErrorCode::bad_file, "not a 3DS file (it does not begin with block 0x4D4D)");
    const auto whole = little<std::uint32_t>(s.bytes, 2);
    if (whole > size)
        throw Error(ErrorCode::bad_file,
                    format_text("it promises {} bytes, but {} are there; the file is cut short", whole, size));
    if (whole < size) s.report.add(Remark::warning, s.path, {}, "bytes follow the last block");
    Faces3ds faces(s);
    std::vector<Open> open{{0, whole}};
    while (!open.empty()) {
        Open& o = open.back();
        if (o.end - o.at < 6) {  // a remainder too small for a block is padding
            open.pop_back();
            continue;
        }
        const std::uint64_t begin = o.at;
        const auto id = little<std::uint16_t>(s.bytes, begin);
        const auto bytes = little<std::uint32_t>(s.bytes, begin + 2);
        if (bytes < 6 || bytes > o.end - begin) cut_short("a block runs past the end of the one around it", begin);
        o.at += bytes;
        if (const std::uint64_t inside = enter_3ds(s, faces, id, begin + 6, begin + bytes))
            open.push_back({inside, begin + bytes});
        if (open.size() > 64) cut_short("blocks are nested too deeply", begin);
    }
}

void check_blend(const Suspect& s) {
    const std::string_view text = text_of(s);
    if (text.starts_with("\x1f\x8b")) return;  // gzip: Assimp unpacks it under the helper's memory limit
    if (text.starts_with("\x28\xb5\x2f\xfd"))
        throw Error(ErrorCode::bad_file, "compressed by zstd, which is not supported", {},
                    "save it without compression, or export glTF");
    if (!text.starts_with("BLENDER") || text.size() < 12) throw Error(ErrorCode::bad_file, "not a Blender file");
    const std::uint64_t pointer = text[7] == '-' ? 8 : text[7] == '_' ? 4 : 0;
    if (pointer == 0 || (text[8] != 'v' && text[8] != 'V'))
        throw Error(ErrorCode::bad_file, "the Blender header is damaged or of a newer kind", {}, "export glTF instead");
    const bool big = text[8] == 'V';
    const std::uint64_t header = 16 + pointer;
    bool described = false;
    for (std::uint64_t at = 12;;) {
        if (text.size() < header || at > text.size() - header) cut_short("the last block is missing", at);
        const std::string_view code = text.substr(at, 4);
        if (code == std::string_view("ENDB")) break;
        auto bytes = little<std::uint32_t>(s.bytes, at + 4);
        if (big) bytes = __builtin_bswap32(bytes);
        if (bytes > text.size() - at - header) cut_short("a block runs past the end", at);
        described = described || code == "DNA1";
        at += header + bytes;
    }
    if (!described) throw Error(ErrorCode::bad_file, "the block that describes all others is missing");
}

}  // namespace

constinit const Precheck fbx_precheck = {"fbx", check_fbx};
constinit const Precheck precheck_3ds = {"3ds", check_3ds};
constinit const Precheck blend_precheck = {"blend", check_blend};

}  // namespace rakelight::io
