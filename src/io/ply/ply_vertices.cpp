// SPDX-License-Identifier: Apache-2.0
#include "io/ply/ply_vertices.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <string_view>

namespace rakelight::io::ply {
namespace {

constexpr std::uint64_t rows_per_task = 1 << 14;

struct Column {
    const Property* property;
    ColumnTarget target;
    std::size_t offset;  ///< [bytes] in a binary row without lists
};

std::vector<Column> columns_of(const Element& element, Format format, VertexTable& table, const std::string& path,
                               Context& context) {
    std::vector<Column> columns;
    std::size_t offset = 0;
    for (const Property& p : element.properties) {
        if (p.count_type)
            context.report().add(Remark::dropped, path, "",
                                 "the vertex list '" + one_line(p.name, 40) + "' is left out");
        columns.push_back({&p, p.count_type ? ColumnTarget{} : table.column(p.name, kind_of(p, format)), offset});
        offset += size_of(p.type);
    }
    return columns;
}

/// Floats of this machine's own byte order: what nearly all of a large file is.
void copy_floats(const char* from, std::size_t row_bytes, std::uint64_t first, std::uint64_t end,
                 const ColumnTarget& to) {
    for (std::uint64_t row = first; row < end; ++row)
        std::memcpy(to.floats + row * to.stride, from + row * row_bytes, sizeof(float));
}
void copy_bytes(const char* from, std::size_t row_bytes, std::uint64_t first, std::uint64_t end,
                const ColumnTarget& to) {
    for (std::uint64_t row = first; row < end; ++row)
        to.floats[row * to.stride] = float(std::uint8_t(from[row * row_bytes]));
}

void read_rows(std::string_view rows, const Element& element, Format format, const std::vector<Column>& columns,
               Context& context) {
    const std::size_t row_bytes = std::size_t(element.least_bytes(format));
    const bool is_big = format == Format::big_endian, is_native = is_big == (std::endian::native == std::endian::big);
    const auto read_column = [&](const Column& c, std::uint64_t first, std::uint64_t end) {
        const char* const from = rows.data() + c.offset;
        if (c.target.is_dropped()) return;
        if (c.target.floats && is_native && c.property->type == Type::f32)
            return copy_floats(from, row_bytes, first, end, c.target);
        if (c.target.floats && c.property->type == Type::u8) return copy_bytes(from, row_bytes, first, end, c.target);
        for (std::uint64_t row = first; row < end; ++row)
            c.target.set(row, binary_number(from + row * row_bytes, c.property->type, is_big));
    };
    context.parallel_for((element.count + rows_per_task - 1) / rows_per_task, [&](std::size_t task) {
        const std::uint64_t first = task * rows_per_task, end = std::min(element.count, first + rows_per_task);
        for (const Column& c : columns) read_column(c, first, end);
    });
}

}  // namespace

ColumnKind kind_of(const Property& property, Format format) {
    const Type t = property.type;
    ColumnKind kind;
    kind.is_real = is_real(t);
    kind.needs_double = t == Type::f64 || t == Type::i32 || t == Type::u32 || format == Format::ascii;
    kind.color = is_real(t) ? ColorScale::by_value : size_of(t) == 2 ? ColorScale::words : ColorScale::bytes;
    return kind;
}

void read_vertices(Cursor& cursor, const Element& element, Format format, VertexTable& table, const std::string& path,
                   Context& context) {
    const std::vector<Column> columns = columns_of(element, format, table, path, context);
    if (format != Format::ascii && !element.has_lists())
        return read_rows(cursor.rows(element), element, format, columns, context);
    cursor.begin(element);
    for (std::uint64_t row = 0; row < element.count; ++row) {
        if (row % 65536 == 0) context.throw_if_cancelled();
        for (const Column& c : columns) {
            if (c.property->count_type)
                cursor.skip(*c.property);
            else
                c.target.set(row, cursor.number(c.property->type));
        }
    }
}

}  // namespace rakelight::io::ply
