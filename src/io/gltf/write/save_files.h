// SPDX-License-Identifier: Apache-2.0
// The files of a glTF model as they are written: a GLB container, or JSON with buffers beside it.
#pragma once
#include <span>
#include <string>

#include "io/gltf/buffers.h"
#include "io/gltf/write/save_tree.h"

namespace rakelight::io::gltf {

/// A file's name as glTF refers to it (RFC 3986).
std::string percent_encoded(const std::string& name);

/// Where new data goes, and how the file is put together around it.
class OutputModel {
public:
    /// @param tree  the file's JSON, edited in place: buffers and their views when the container changes
    OutputModel(const Document& document, Buffers& buffers, OrderedJson& tree, const std::string& output);

    std::size_t buffer() const { return buffer_; }         ///< the buffer that new data is appended to
    std::uint64_t offset() const { return base_.size(); }  ///< its bytes so far, a multiple of 4
    std::span<std::byte> binary() { return base_; }        ///< its bytes so far, to be overwritten in part

    /// Writes everything, the model file last. `unchanged`: the source's bytes are the model file. `keep_unused`: of a GLB the
    /// bytes of views that nothing refers to stay.
    void write(std::span<const std::byte> new_data, bool unchanged, bool keep_unused, Context& context);

private:
    void take_in_buffers(Buffers& buffers);
    std::string free_name(Context& context) const;
    void copy_references(Context& context) const;
    void write_glb(std::span<const std::byte> new_data, bool keep_unused) const;
    void write_gltf(std::span<const std::byte> new_data, Context& context);
    const Document& document_;
    OrderedJson& tree_;
    std::string output_;
    bool is_glb_ = false, repacked_ = false;
    std::size_t buffer_ = 0;
    std::vector<std::byte> base_;             ///< what the buffer holds already (GLB), padded to 4
    std::span<const std::byte> json_;         ///< the source's JSON text
    std::span<const std::byte> more_chunks_;  ///< chunks after JSON and BIN, kept
};

}  // namespace rakelight::io::gltf
