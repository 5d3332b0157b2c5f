// SPDX-License-Identifier: Apache-2.0
// New vertex and index data for a glTF file: bytes in one region, with the bufferViews and accessors that name them.
#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include <rakelight/scene/scene.h>

#include "io/gltf/elements.h"
#include "io/gltf/write/save_tree.h"

namespace rakelight::io::gltf {

/// Appends data. Equal contents are stored once, so primitives that share an array continue sharing it.
class NewData {
public:
    /// @param buffer  the number of the buffer that the region will be part of
    /// @param offset  where in that buffer the region begins, a multiple of 4
    NewData(OrderedJson& root, std::size_t buffer, std::uint64_t offset)
        : root_(root), buffer_(buffer), offset_(offset) {}

    /// Unit vectors of `width` numbers each, as f32, i8 or i16. @return accessor
    std::uint32_t directions(std::span<const float> numbers, std::uint32_t width, ComponentType type);
    /// @param least  the smallest type to use; a larger one is taken where an index needs it. u8, u16 or u32
    std::uint32_t indices(std::span<const std::uint32_t> values, ComponentType least);
    /// A vertex attribute of which vertices were copied: the elements, then for each entry of `copied` that element
    /// again, all bytes as they are. `model` is the accessor that it replaces: its name, extras, min and max stay.
    std::uint32_t extended(const Elements& elements, std::span<const std::uint32_t> copied, const OrderedJson& model);

    /// Numbers that are no vertex data: key times, key values, matrices. `width` 1, 3, 4 or 16 in each element.
    /// @param bounds  min and max are written (key times must have them)
    std::uint32_t numbers(std::span<const float> values, std::uint32_t width, bool bounds = false);

    /// What is added next is compressed by this extension (see save_meshopt.h), where that can be; "": not.
    void compress_as(std::string extension) { extension_ = std::move(extension); }

    std::span<const std::byte> bytes() const { return bytes_; }

private:
    std::uint32_t accessor(std::vector<std::byte> data, std::uint32_t stride, int target, OrderedJson description);
    OrderedJson new_view(std::span<const std::byte> data, std::uint32_t stride, int target, std::size_t count);
    OrderedJson& root_;
    std::size_t buffer_;
    std::uint64_t offset_;
    std::vector<std::byte> bytes_;
    std::string extension_;
    struct Known {
        std::size_t begin, size;
        std::uint32_t stride;
        int target;
        std::string extension;
        std::vector<std::byte> data;  ///< of compressed views, else they lie in bytes_
        std::uint32_t view;
    };
    std::multimap<std::uint64_t, Known> views_;       ///< by a hash of the bytes
    std::map<std::string, std::uint32_t> accessors_;  ///< by their text
};

}  // namespace rakelight::io::gltf
