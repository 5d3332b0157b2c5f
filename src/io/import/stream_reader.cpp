// SPDX-License-Identifier: Apache-2.0
#include "io/import/stream_reader.h"

#include <algorithm>
#include <cstring>

#include "base/format_text.h"

namespace rakelight::io::import_stream {
namespace {

constexpr std::uint32_t longest_text = 1u << 16;
constexpr std::size_t most_texcoord_sets = 16;

[[noreturn]] void broken(const std::string& what) {
    throw Error(ErrorCode::bad_file, "the import helper sent a broken stream (" + what + ")");
}

void require(bool holds, const char* what) {
    if (!holds) broken(what);
}

void check_index(std::uint32_t index, std::size_t size, bool may_be_nothing, const char* what) {
    require(index < size || (may_be_nothing && index == nothing), what);
}

/// RGBA8 of width x height; width * height fits, times 4 might not.
bool is_size_of(const Picture& p) {
    return p.bytes.size() % 4 == 0 && p.bytes.size() / 4 == std::uint64_t(p.width) * p.height;
}

void check_surfaces(const Document& d) {
    for (const Surface& s : d.surfaces)
        for (const TextureLink& t : s.links) {
            require(t.role < std::uint32_t(Role::count) && t.placement < std::uint32_t(Placement::count),
                    "role of a texture");
            require(t.wrap_u < std::uint32_t(WrapMode::count) && t.wrap_v < std::uint32_t(WrapMode::count),
                    "wrap mode");
            check_index(t.picture, d.pictures.size(), true, "picture of a texture");
        }
    for (const Picture& p : d.pictures) require(p.width == 0 ? p.height == 0 : is_size_of(p), "size of a picture");
}

void check_places(const Document& d) {
    for (std::size_t i = 0; i < d.places.size(); ++i) {
        check_index(d.places[i].parent, i, true, "parent of a node");
        for (std::uint32_t m : d.places[i].meshes) check_index(m, d.part_count, false, "mesh of a node");
    }
    for (const Lamp& l : d.lamps) {
        check_index(l.node, d.places.size(), true, "node of a light");
        require(l.type <= 3, "type of a light");
    }
    for (const View& v : d.views) check_index(v.node, d.places.size(), true, "node of a camera");
    require(d.joints.size() <= 65536, "number of joints");
    for (const Joint& j : d.joints) check_index(j.node, d.places.size(), false, "node of a joint");
}

void check_motions(const Document& d) {
    for (const Motion& m : d.motions)
        for (const Track& t : m.tracks) {
            check_index(t.node, d.places.size(), false, "node of an animation");
            require(t.path <= 2, "path of an animation");
            require(t.values.size() == t.times.size() * (t.path == 1 ? 4 : 3), "size of an animation");
        }
}

void check_document(const Document& d) {
    const auto is_axis = [](std::int32_t a) { return a >= 0 && a <= 2; };
    const auto is_sign = [](std::int32_t s) { return s == 1 || s == -1; };
    const AxisSystem& a = d.axes;
    require(is_axis(a.up) && is_axis(a.front) && is_axis(a.side) && is_sign(a.up_sign) && is_sign(a.front_sign) &&
                is_sign(a.side_sign),
            "axes");
    check_surfaces(d);
    check_places(d);
    check_motions(d);
}

void check_part(const Part& p, const Document& d) {
    const std::size_t v = p.positions.size(), i = p.indices.size();
    require(p.topology <= 2, "topology");
    require(v < nothing, "number of vertices");
    require(i % (3 - p.topology) == 0, "number of indices");
    check_index(p.surface, d.surfaces.size(), true, "material of a mesh");
    const auto fits = [v](std::size_t n) { return n == 0 || n == v; };
    require(fits(p.normals.size()) && fits(p.tangents.size()) && fits(p.colors.size()) && fits(p.influences.size()),
            "size of a vertex array");
    require(p.smoothing.empty() || (p.topology == 0 && p.smoothing.size() == i / 3), "size of a list of groups");
    require(p.polygons.empty() || (p.topology == 0 && p.polygons.size() == i / 3), "size of a triangle array");
    require(p.smoothing_hint.empty() || (p.topology == 0 && p.smoothing_hint.size() == i), "size of a corner array");
    require(p.texcoords.size() <= most_texcoord_sets, "number of texture coordinate sets");
    for (const auto& set : p.texcoords) require(set.size() == v, "size of a texture coordinate set");
    for (const Shape& s : p.shapes)
        require(s.positions.size() == v && fits(s.normals.size()), "size of a morph target");
    for (std::uint32_t k : p.indices) require(k < v, "vertex index");
    for (const Influence& f : p.influences)
        for (std::size_t k = 0; k < f.joints.size(); ++k)
            require(f.weights[k] == 0 || f.joints[k] < d.joints.size(), "joint of a vertex");
}

}  // namespace

void MemorySource::read(std::span<std::byte> to) {
    if (to.empty()) return;
    if (to.size() > rest_.size()) broken("it ends early");
    std::memcpy(to.data(), rest_.data(), to.size());
    rest_ = rest_.subspan(to.size());
}

void Reader::text(std::string& s) {
    std::uint32_t size = 0;
    value(size);
    require(size <= longest_text, "length of a text");
    s.resize(size);
    source_.read(std::as_writable_bytes(std::span(s)));
}

std::uint64_t Reader::checked_count(std::size_t element_bytes) {
    std::uint64_t count = 0;
    value(count);
    require(count <= ~std::uint64_t(0) / element_bytes, "count of an array");
    if (count != 0) charge_.grow(count * element_bytes, "the imported model");
    return count;
}

Import read_import(Source& source, Context& context) {
    Reader reader(source, context);
    Head head;
    reader.value(head);
    require(head.stream_magic == magic, "not the helper's");
    if (head.stream_version != version)
        throw Error(ErrorCode::failed,
                    format_text("the import helper speaks version {} of the stream, this program {}",
                                head.stream_version, version),
                    {}, "install both from one build");
    if (head.kind == std::uint32_t(Kind::refusal)) {
        std::string reason;
        reader.text(reason);
        throw Error(ErrorCode::bad_file, one_line(reason));
    }
    require(head.kind == std::uint32_t(Kind::scene), "unknown kind");
    Import result;
    transfer(reader, result.document);
    check_document(result.document);
    reader.charge().grow(std::uint64_t(result.document.part_count) * sizeof(Part), "the imported model");
    for (std::uint32_t i = 0; i < result.document.part_count; ++i) {
        context.throw_if_cancelled();
        Part& part = result.parts.emplace_back();
        transfer(reader, part);
        check_part(part, result.document);
    }
    std::uint64_t mark = 0;
    reader.value(mark);
    require(mark == end_mark, "no end mark");
    result.charge = std::move(reader.charge());
    return result;
}

}  // namespace rakelight::io::import_stream
