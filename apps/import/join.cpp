// SPDX-License-Identifier: Apache-2.0
// Assimp hands out a vertex per corner for most formats. Joining those that are equal in every attribute changes no picture and
// no topology that the file had: two vertices that differ in one bit of one attribute stay two.
#include "join.h"

#include <cstring>

#include "base/hash_key.h"

namespace rakelight::import_helper {
namespace {

/// The bytes of all attributes of one vertex, attribute after attribute.
struct Rows {
    struct Column {
        const unsigned char* bytes;
        std::size_t stride;
    };
    std::vector<Column> columns;
    HashKey key = hash_key_of_this_run();

    template <class T>
    void add(const std::vector<T>& values) {
        if (!values.empty()) columns.push_back({reinterpret_cast<const unsigned char*>(values.data()), sizeof(T)});
    }
    /// Keyed: a file could be made whose vertices all meet under a hash that everybody knows.
    std::uint64_t hash(std::uint32_t v) const {
        std::uint64_t h = key.a;
        for (const Column& c : columns)
            for (std::size_t i = 0; i < c.stride; i += 4) {
                std::uint32_t word;
                std::memcpy(&word, c.bytes + c.stride * v + i, 4);
                h = folded_product(h ^ word, key.b);
            }
        return h;
    }
    bool equal(std::uint32_t a, std::uint32_t b) const {
        for (const Column& c : columns)
            if (std::memcmp(c.bytes + c.stride * a, c.bytes + c.stride * b, c.stride) != 0) return false;
        return true;
    }
};

template <class T>
void keep(std::vector<T>& values, const std::vector<std::uint32_t>& kept) {
    if (values.empty()) return;
    for (std::size_t i = 0; i < kept.size(); ++i) values[i] = values[kept[i]];  // kept[i] >= i, since kept ascends
    values.resize(kept.size());
    values.shrink_to_fit();
}

Rows rows_of(const Part& p) {
    Rows rows;
    rows.add(p.positions);
    rows.add(p.normals);
    rows.add(p.tangents);
    rows.add(p.colors);
    rows.add(p.influences);
    for (const auto& set : p.texcoords) rows.add(set);
    for (const Shape& s : p.shapes) {
        rows.add(s.positions);
        rows.add(s.normals);
    }
    return rows;
}

/// For every vertex the first one that equals it; vertices that nothing uses get `nothing`.
std::vector<std::uint32_t> representatives(const Part& p, std::uint64_t& met) {
    const Rows rows = rows_of(p);
    const std::size_t vertices = p.positions.size();
    std::vector<std::uint32_t> first(vertices, nothing);
    for (std::uint32_t i : p.indices) first[i] = i;
    std::size_t slots = 16;
    while (slots < vertices * 2) slots *= 2;
    std::vector<std::uint32_t> table(slots, nothing);
    for (std::uint32_t v = 0; v < vertices; ++v) {
        if (first[v] == nothing) continue;
        std::size_t slot = rows.hash(v) & (slots - 1);
        for (; table[slot] != nothing && !rows.equal(table[slot], v); slot = (slot + 1) & (slots - 1)) ++met;
        if (table[slot] == nothing) table[slot] = v;
        first[v] = table[slot];
    }
    return first;
}

}  // namespace

void join_equal_vertices(Part& part, std::uint64_t* met) {
    std::uint64_t met_here = 0;
    const std::vector<std::uint32_t> first = representatives(part, met_here);
    if (met) *met = met_here;
    std::vector<std::uint32_t> kept, number(first.size(), nothing);
    for (std::uint32_t v = 0; v < first.size(); ++v)
        if (first[v] == v) {
            number[v] = std::uint32_t(kept.size());
            kept.push_back(v);
        }
    for (std::uint32_t& i : part.indices) i = number[first[i]];
    keep(part.positions, kept);
    keep(part.normals, kept);
    keep(part.tangents, kept);
    keep(part.colors, kept);
    keep(part.influences, kept);
    for (auto& set : part.texcoords) keep(set, kept);
    for (Shape& s : part.shapes) {
        keep(s.positions, kept);
        keep(s.normals, kept);
    }
}

}  // namespace rakelight::import_helper
