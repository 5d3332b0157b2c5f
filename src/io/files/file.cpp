// SPDX-License-Identifier: Apache-2.0
#include "io/files/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <new>
#include <system_error>
#include <utility>

#include <rakelight_internal/base/text.h>

#include "io/files/descriptor.h"

namespace rakelight::io {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_input(const std::string& path, const std::string& reason) {
    throw Error(ErrorCode::not_found, reason).with_file(path);
}

bool is_ascii_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// "C:\x" and "C:x".
bool begins_with_drive(const std::string& path) {
    return path.size() >= 2 && path[1] == ':' && is_ascii_letter(path[0]);
}

[[noreturn]] void refuse_missing(const std::string& path, int error) {
    if (error != ENOENT || !begins_with_drive(path)) refuse_input(path, "cannot be opened: " + system_message(error));
    const std::size_t slash = path.find_last_of("/\\:");
    throw Error(ErrorCode::not_found, "is a path on another machine", {},
                "give the path of '" + one_line(path.substr(slash + 1), 80) + "' on this one")
        .with_file(path);
}

void require_regular(const std::string& path, const struct ::stat& status) {
    if (S_ISDIR(status.st_mode)) refuse_input(path, "is a folder, not a file");
    if (!S_ISREG(status.st_mode)) refuse_input(path, "is not a regular file");
}

/// A FIFO would block in open() and a device may act on it, so look before; fstat() after, because the name may have changed.
int open_regular(const std::string& path, struct ::stat& status) {
    if (path.empty()) throw Error(ErrorCode::not_found, "the file name is empty");
    if (path.find('\0') != std::string::npos) refuse_input(path, "the file name holds a zero byte");
    if (::stat(path.c_str(), &status) != 0) refuse_missing(path, errno);
    require_regular(path, status);
    Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)};
    if (file.fd < 0 || ::fstat(file.fd, &status) != 0) refuse_input(path, "cannot be opened: " + system_message(errno));
    require_regular(path, status);
    return std::exchange(file.fd, -1);
}

/// Reads up to `bytes.size()` bytes; a file that was cut meanwhile gives fewer.
void read_all(const std::string& path, int fd, std::vector<std::byte>& bytes) {
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t got = ::read(fd, bytes.data() + done, bytes.size() - done);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) refuse_input(path, "cannot be read: " + system_message(errno));
        if (got == 0) break;
        done += std::size_t(got);
    }
    bytes.resize(done);
}

/// "http://x", "file:x" and "data:x"; a colon elsewhere may be part of a file name.
bool has_scheme(const std::string& reference) {
    const std::size_t colon = reference.find(':');
    if (colon == std::string::npos || colon == 0 || !is_ascii_letter(reference[0])) return false;
    const std::string scheme = lower_case(reference.substr(0, colon));
    for (const char c : scheme) {
        if (!is_ascii_letter(c) && !(c >= '0' && c <= '9') && c != '+' && c != '-' && c != '.') return false;
    }
    static constexpr std::array known{"http", "https", "ftp", "ftps", "file", "data"};
    for (const char* name : known)
        if (scheme == name) return true;
    return reference.compare(colon, 3, "://") == 0;
}

[[noreturn]] void refuse_reference(const std::string& reference, const std::string& why) {
    throw Error(ErrorCode::bad_file, "the reference to '" + one_line(reference, 160) + "' " + why, {},
                "copy the file into the model's folder, or use 'allow-outside' if you trust the model")
        .naming({"allow-outside"});
}

/// Such a file is not on this machine, wherever references may lead.
void refuse_drive(const std::string& reference) {
    if (!begins_with_drive(reference)) return;
    const std::size_t slash = reference.find_last_of("/\\:");
    throw Error(ErrorCode::bad_file, "the reference to '" + one_line(reference, 160) + "' is a path on another machine",
                {}, "put '" + one_line(reference.substr(slash + 1), 80) + "' beside the model, and refer to it there");
}

bool lies_inside(const fs::path& path, const fs::path& folder) {
    auto inner = path.begin();
    for (auto outer = folder.begin(); outer != folder.end(); ++outer, ++inner) {
        if (outer->empty()) return true;  // a trailing slash
        if (inner == path.end() || *inner != *outer) return false;
    }
    return true;
}

/// Both sides with every symbolic link and ".." resolved, so that a link inside the folder cannot lead out.
void require_inside(const fs::path& folder, const fs::path& joined, const std::string& reference) {
    std::error_code error;
    const fs::path root = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, error);
    if (error) refuse_reference(reference, "cannot be resolved");
    const fs::path target = fs::weakly_canonical(fs::absolute(joined, error), error);
    if (error) refuse_reference(reference, "cannot be resolved");
    const fs::path absolute_root = fs::absolute(root, error).lexically_normal();
    if (error || !lies_inside(target, absolute_root)) refuse_reference(reference, "leaves the model's folder");
}

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

int base64_digit(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    return c == '+' ? 62 : c == '/' ? 63 : -1;
}

}  // namespace

Bytes charged_bytes(std::vector<std::byte> bytes, MemoryCharge charge) {
    struct Both {
        std::vector<std::byte> bytes;
        MemoryCharge charge;
    };
    const std::shared_ptr<const Both> both(new Both{std::move(bytes), std::move(charge)});
    return {both, &both->bytes};
}

Bytes read_file(const std::string& path, Context& context, bool is_told) {
    context.note_file(path);
    struct ::stat status {};
    const Descriptor file{open_regular(path, status)};
    const std::uint64_t size = std::uint64_t(status.st_size);
    try {
        MemoryCharge charge = is_told ? MemoryCharge(context.memory(), size, "the file")
                                      : MemoryCharge::of_file(context.memory(), size, "the file");
        std::vector<std::byte> bytes(static_cast<std::size_t>(size));
        read_all(path, file.fd, bytes);
        return charged_bytes(std::move(bytes), std::move(charge));
    } catch (const Error& error) {
        throw error.with_file(path);
    } catch (const std::bad_alloc&) {
        throw Error(ErrorCode::bad_file, "does not fit into memory").with_file(path);
    }
}

InputFile::InputFile(std::string path, Context& context) : path_(std::move(path)) {
    context.note_file(path_);
    struct ::stat status {};
    Descriptor file{open_regular(path_, status)};
    file_ = ::fdopen(file.fd, "rb");
    if (file_ == nullptr) refuse_input(path_, "cannot be opened: " + system_message(errno));
    file.fd = -1;
    size_ = std::uint64_t(status.st_size);
}

std::size_t InputFile::read(std::span<std::byte> bytes) {
    const std::size_t got = std::fread(bytes.data(), 1, bytes.size(), file_);
    if (got < bytes.size() && std::ferror(file_) != 0) refuse_input(path_, "cannot be read: " + system_message(errno));
    return got;
}

void InputFile::seek(std::uint64_t position) {
    if (::fseeko(file_, off_t(position), SEEK_SET) != 0)
        refuse_input(path_, "cannot be read: " + system_message(errno));
}

bool is_regular_file(const std::string& path) {
    struct ::stat status {};
    return path.find('\0') == std::string::npos && ::stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode);
}

std::string resolve_reference(const std::string& model_path, const std::string& reference, bool allow_outside) {
    std::string relative = reference;
    for (char& c : relative)
        if (c == '\\') c = '/';
    if (relative.empty()) throw Error(ErrorCode::bad_file, "an empty file reference");
    if (relative.find('\0') != std::string::npos) refuse_reference(reference, "holds a zero byte");
    refuse_drive(reference);
    if (!allow_outside && has_scheme(relative)) refuse_reference(reference, "is not a file beside the model");
    if (!allow_outside && relative[0] == '/') refuse_reference(reference, "is an absolute path");
    const fs::path folder = fs::path(model_path).parent_path();
    const fs::path joined = folder / relative;
    if (!allow_outside) require_inside(folder, joined, reference);
    return joined.string();
}

std::string why_not_found(const std::string& model_path, const std::string& reference, const std::string& done) {
    try {
        if (is_regular_file(resolve_reference(model_path, reference, true)))
            return " lies outside the model's folder; " + done + " ('allow-outside' permits it)";
    } catch (const Error&) {  // not even a name
    }
    return " is not in the model's folder; " + done;
}

std::optional<std::string> percent_decode(const std::string& uri) {
    std::string text;
    text.reserve(uri.size());
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] != '%') {
            text += uri[i];
            continue;
        }
        if (uri.size() - i < 3) return std::nullopt;
        const int high = hex_digit(uri[i + 1]), low = hex_digit(uri[i + 2]);
        if (high < 0 || low < 0) return std::nullopt;
        text += char(high * 16 + low);
        i += 2;
    }
    return text;
}

std::optional<std::vector<std::byte>> base64_decode(std::string_view text) {
    std::size_t padding = 0;
    while (padding < 2 && padding < text.size() && text[text.size() - 1 - padding] == '=') ++padding;
    if (padding != 0 && text.size() % 4 != 0) return std::nullopt;
    text.remove_suffix(padding);
    if (text.size() % 4 == 1) return std::nullopt;
    std::vector<std::byte> bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    int held = 0;
    for (const char c : text) {
        const int digit = base64_digit(c);
        if (digit < 0) return std::nullopt;
        bits = bits << 6 | std::uint32_t(digit);
        held += 6;
        if (held >= 8) bytes.push_back(std::byte(bits >> (held -= 8) & 0xff));
    }
    return bytes;
}

}  // namespace rakelight::io
