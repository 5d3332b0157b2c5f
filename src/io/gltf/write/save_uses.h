// SPDX-License-Identifier: Apache-2.0
// Who refers to the accessors of a glTF file, and which of their arrays may be overwritten where they lie.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "io/gltf/elements.h"
#include "io/gltf/write/save_tree.h"

namespace rakelight::io::gltf {

/// References to each accessor, over the whole file.
class AccessorUses {
public:
    explicit AccessorUses(const OrderedJson& tree);
    /// False: the file uses an extension of which is not known whether it refers to accessors.
    bool are_all_known() const { return are_all_known_; }
    std::uint32_t count(std::size_t accessor) const { return accessor < counts_.size() ? counts_[accessor] : 0; }
    std::size_t accessors() const { return counts_.size(); }

private:
    void add(const OrderedJson& owner, const char* name);
    void add_members(const OrderedJson& owner, const char* name);
    std::vector<std::uint32_t> counts_;
    bool are_all_known_ = true;
};

/// The arrays of a binary chunk that only one attribute of one primitive uses.
class OwnArrays {
public:
    /// @param binary  what buffer 0 holds so far; a part of it is overwritten by replace()
    OwnArrays(const OrderedJson& tree, const AccessorUses& uses, std::span<std::byte> binary);

    /// Overwrites the elements of an accessor, and its min and max where it has them; nothing else of the file changes.
    /// @return false, with nothing done: others use the accessor or its bytes, its data is sparse, compressed or
    /// elsewhere,
    ///         or its count, width or type are not those of the new numbers
    bool replace(OrderedJson& tree, std::size_t accessor, std::span<const float> numbers, std::uint32_t width,
                 ComponentType type);

private:
    struct Array {
        std::size_t view = 0;
        std::uint64_t begin = 0, end = 0;  ///< in the binary chunk; equal: not to be overwritten
        std::uint32_t stride = 0;
    };
    void find_arrays(const OrderedJson& tree);
    void keep_apart(const OrderedJson& tree, const AccessorUses& uses);
    std::vector<Array> arrays_;  ///< [accessors]
    std::span<std::byte> binary_;
};

/// A number of the file that is a count or an index; parts that are not drawn were never checked.
std::optional<std::uint64_t> whole_number(const OrderedJson& owner, const char* name);

/// [bufferViews] Whether anything refers to each: an accessor that is used, a sparse part, an image, compressed geometry.
std::vector<bool> live_views(const OrderedJson& tree, const AccessorUses& uses);

/// [bytes] in arrays that something referred to before, and nothing does now.
std::uint64_t unused_bytes(const OrderedJson& tree, const AccessorUses& before, const AccessorUses& now);

}  // namespace rakelight::io::gltf
