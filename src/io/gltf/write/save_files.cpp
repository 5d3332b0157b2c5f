// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/write/save_files.h"

#include <cstring>
#include <filesystem>
#include <optional>
#include <set>
#include <system_error>

#include <nlohmann/json.hpp>

#include <rakelight_internal/base/file_ending.h>

#include "io/files/beside.h"
#include "io/files/file.h"
#include "io/files/output_file.h"
#include "io/gltf/container.h"
#include "io/gltf/write/save_compact.h"

namespace rakelight::io::gltf {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t magic = 0x46546C67, json_type = 0x4E4F534A, binary_type = 0x004E4942;

std::uint32_t word_at(std::span<const std::byte> bytes, std::size_t offset) {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + offset, 4);
    return word;
}

void add_word(std::vector<std::byte>& out, std::uint64_t word) {
    const auto narrow = std::uint32_t(word);
    const auto* raw = reinterpret_cast<const std::byte*>(&narrow);
    out.insert(out.end(), raw, raw + 4);
}

void add(std::vector<std::byte>& out, std::span<const std::byte> bytes) {
    out.insert(out.end(), bytes.begin(), bytes.end());
}

void pad(std::vector<std::byte>& out, char filler = 0) {
    while (out.size() % 4 != 0) out.push_back(std::byte(filler));
}

std::span<const std::byte> bytes_of(const std::string& text) { return std::as_bytes(std::span(text)); }

/// Chunks that are neither JSON nor BIN, as they lie after those (open_container has checked all sizes).
std::span<const std::byte> other_chunks(std::span<const std::byte> file) {
    const auto whole = file.first(word_at(file, 8));
    std::size_t at = 12;
    for (int chunk = 0; at + 8 <= whole.size(); ++chunk) {
        const std::uint32_t type = word_at(whole, at + 4);
        if (type != (chunk == 0 ? json_type : binary_type) || chunk > 1) return whole.subspan(at);
        at += 8 + std::size_t(word_at(whole, at));
    }
    return {};
}

/// A reference inside the model as a relative path; empty for a data URI.
std::string relative_name(const std::string& uri) {
    if (uri.starts_with("data:")) return {};
    std::string name = percent_decode(uri).value_or(uri);
    for (char& c : name)
        if (c == '\\') c = '/';
    return fs::path(name).lexically_normal().string();
}

}  // namespace

std::string percent_encoded(const std::string& name) {
    constexpr const char* digits = "0123456789ABCDEF";
    std::string out;
    for (const char c : name) {
        const bool is_plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '-' ||
                              c == '_' || c == '.' || c == '~';
        const auto u = static_cast<unsigned char>(c);
        if (is_plain)
            out += c;
        else
            out += {'%', digits[u >> 4], digits[u & 15]};
    }
    return out;
}

namespace {

bool is_fallback(const OrderedJson& buffer) {
    for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"})
        if (buffer.contains("extensions") && buffer["extensions"].contains(name)) return !buffer.contains("uri");
    return false;
}

}  // namespace

OutputModel::OutputModel(const Document& document, Buffers& buffers, OrderedJson& tree, const std::string& output)
    : document_(document), tree_(tree), output_(output), is_glb_(file_ending(output) == "glb") {
    const std::span<const std::byte> file = *document.file();
    const bool source_is_glb = word_at(file, 0) == magic;
    repacked_ = is_glb_ != source_is_glb;
    if (source_is_glb && is_glb_) more_chunks_ = other_chunks(file);
    const std::size_t count = document.count(buffer_kind);
    const bool has_own = source_is_glb && count > 0 && document.has_binary() && !tree_["buffers"][0].contains("uri");
    if (has_own) {
        add(base_, buffers.buffer(0, document.root()).bytes);
    } else if (is_glb_) {
        take_in_buffers(buffers);
    } else {
        buffer_ = count;
    }
    pad(base_);
}

/// All buffers that have bytes become one, the first; views follow.
void OutputModel::take_in_buffers(Buffers& buffers) {
    repacked_ = true;
    const std::size_t count = document_.count(buffer_kind);
    std::vector<std::pair<std::size_t, std::uint64_t>> moved;  // new number, shift
    OrderedJson list = OrderedJson::array({OrderedJson::object()});
    for (std::size_t b = 0; b < count; ++b) {
        const OrderedJson& buffer = tree_["buffers"][b];
        if (is_fallback(buffer)) {
            moved.emplace_back(list.size(), 0);
            list.push_back(buffer);
            continue;
        }
        pad(base_);
        moved.emplace_back(0, base_.size());
        add(base_, buffers.buffer(std::uint32_t(b), document_.root()).bytes);
    }
    tree_["buffers"] = std::move(list);
    const auto move = [&](OrderedJson& view) {
        if (!view.contains("buffer") || !view["buffer"].is_number_unsigned()) return;
        const auto old = view["buffer"].get<std::uint64_t>();
        if (old >= moved.size()) return;  // of a view that nothing uses
        const auto& [number, shift] = moved[std::size_t(old)];
        view["buffer"] = number;
        if (shift > 0) view["byteOffset"] = view.value("byteOffset", std::uint64_t(0)) + shift;
    };
    if (!tree_.contains("bufferViews")) return;
    for (OrderedJson& view : tree_["bufferViews"]) {
        move(view);
        if (view.contains("extensions") && view["extensions"].is_object())
            for (OrderedJson& extension : view["extensions"])
                if (extension.is_object()) move(extension);
    }
}

namespace {

/// The files that a glTF file names; none when it is not there or not one.
std::set<std::string> names_in(const std::string& path, Context& context) {
    std::set<std::string> names;
    if (!is_regular_file(path)) return names;
    try {
        OrderedJson tree = parse_ordered(*read_file(path, context));
        for_each_member(tree, [&](const std::string& name, const OrderedJson& value) {
            if (name == "uri" && value.is_string()) names.insert(relative_name(value.get_ref<const std::string&>()));
        });
    } catch (const Error&) {  // whatever it is, it is about to be replaced
    }
    return names;
}

}  // namespace

/// NAME.bin, or NAME.normals.bin, NAME.normals2.bin, ... where the model refers to a file of that name already, or one
/// is there that does not belong to the file that OUT replaces.
std::string OutputModel::free_name(Context& context) const {
    std::set<std::string> taken;
    for_each_member(tree_, [&](const std::string& name, const OrderedJson& value) {
        if (name == "uri" && value.is_string()) taken.insert(relative_name(value.get_ref<const std::string&>()));
    });
    const std::set<std::string> replaced = names_in(output_, context);
    const auto is_taken = [&](const std::string& name) {
        std::error_code error;
        return taken.contains(name) || (!replaced.contains(name) && fs::exists(folder_of(output_) / name, error));
    };
    const std::string stem = fs::path(output_).stem().string();
    std::string name = stem + ".bin";
    for (int n = 1; is_taken(name); ++n) name = stem + ".normals" + (n > 1 ? std::to_string(n) : "") + ".bin";
    return name;
}

void OutputModel::copy_references(Context& context) const {
    if (is_same_folder(document_.path(), output_)) return;
    std::set<std::string> names;
    for_each_member(tree_, [&](const std::string& name, const OrderedJson& value) {
        if (name == "uri" && value.is_string()) names.insert(relative_name(value.get_ref<const std::string&>()));
    });
    names.erase("");
    std::vector<NamedFile> files;
    for (const std::string& name : names) {
        if (is_inside(name) && is_regular_file((folder_of(document_.path()) / name).string())) {
            files.push_back({name, resolve_reference(document_.path(), name, document_.options().allow_outside)});
            continue;
        }
        context.report().add(
            Remark::warning, document_.path(), {},
            "the file '" + one_line(name, 80) + "' is not copied: it is missing or not in the model's folder");
    }
    copy_beside(files, output_, context);
}

void OutputModel::write(std::span<const std::byte> new_data, bool unchanged, bool keep_unused, Context& context) {
    copy_references(context);
    if (unchanged && !repacked_)
        write_file(output_, *document_.file());
    else if (is_glb_)
        write_glb(new_data, keep_unused);
    else
        write_gltf(new_data, context);
}

void OutputModel::write_glb(std::span<const std::byte> new_data, bool keep_unused) const {
    std::vector<std::byte> binary = base_;
    add(binary, new_data);
    if (!keep_unused) drop_dead_views(tree_, binary);
    if (!binary.empty())
        tree_["buffers"][0]["byteLength"] = binary.size();
    else if (tree_.contains("buffers") && tree_["buffers"].size() == 1)
        tree_.erase("buffers");  // the one that was to hold new data
    pad(binary);
    std::vector<std::byte> json;
    add(json, bytes_of(tree_.dump()));
    pad(json, ' ');
    const std::uint64_t size = 12 + 8 + json.size() + (binary.empty() ? 0 : 8 + binary.size()) + more_chunks_.size();
    if (size > 0xFFFFFFFFu)
        throw Error(ErrorCode::failed, "a GLB file cannot be larger than 4 GiB", {}, "write a .gltf file instead")
            .with_file(output_);
    std::vector<std::byte> out;
    out.reserve(std::size_t(size));
    add_word(out, magic), add_word(out, 2), add_word(out, size);
    add_word(out, json.size()), add_word(out, json_type), add(out, json);
    if (!binary.empty()) add_word(out, binary.size()), add_word(out, binary_type), add(out, binary);
    add(out, more_chunks_);
    write_file(output_, out);
}

void OutputModel::write_gltf(std::span<const std::byte> new_data, Context& context) {
    std::vector<std::byte> binary = base_;
    add(binary, new_data);
    // Both are whole before one replaces an older file: else a full disk leaves an old model with new data.
    std::optional<OutputFile> data;
    if (!binary.empty()) {
        const std::string name = free_name(context);
        OrderedJson& buffer = tree_["buffers"][buffer_];
        buffer["uri"] = percent_encoded(name);
        buffer["byteLength"] = binary.size();
        data.emplace((folder_of(output_) / name).string());
        data->write(binary);
        data->finish();
    }
    const std::span<const std::byte> file = *document_.file();
    const bool is_text = word_at(file, 0) != magic;
    OutputFile model(output_);
    model.write(bytes_of(to_text(tree_, is_text ? file : std::span<const std::byte>{})));
    model.finish();
    if (data) data->commit();
    model.commit();
}

}  // namespace rakelight::io::gltf
