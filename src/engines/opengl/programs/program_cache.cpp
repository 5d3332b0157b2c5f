// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/programs/program_cache.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <vector>

#include "base/format_text.h"

namespace rakelight::opengl {
namespace {

/// What a file begins with.
struct Header {
    std::uint64_t hash, format;  ///< of what follows; the driver's number for its form
};

/// FNV-1a (Fowler, Noll & Vo 1991): names, not secrets.
std::uint64_t hash_of(std::string_view text, std::uint64_t hash = 0xcbf29ce484222325ull) {
    for (const char c : text) hash = (hash ^ std::uint64_t(static_cast<unsigned char>(c))) * 0x100000001b3ull;
    return hash;
}

std::filesystem::path folder() {
    const char* const wish = std::getenv("RAKELIGHT_GL_CACHE");
    if (wish && std::strcmp(wish, "off") == 0) return {};
    if (const char* const cache = std::getenv("XDG_CACHE_HOME"); cache && cache[0] == '/')
        return std::filesystem::path(cache) / "rakelight" / "gl";
    const char* const home = std::getenv("HOME");
    return home && home[0] == '/' ? std::filesystem::path(home) / ".cache" / "rakelight" / "gl"
                                  : std::filesystem::path();
}

std::string hexadecimal(std::uint64_t number) {
    std::string digits;
    for (int shift = 60; shift >= 0; shift -= 4) digits += "0123456789abcdef"[number >> shift & 15];
    return digits;
}

}  // namespace

void remove_least_used(const std::filesystem::path& folder, std::uintmax_t most_bytes) {
    struct File {
        std::filesystem::file_time_type used;
        std::uintmax_t bytes;
        std::filesystem::path path;
    };
    std::vector<File> files;
    std::uintmax_t bytes = 0;
    std::error_code fault;
    for (std::filesystem::directory_iterator at(folder, fault), end; !fault && at != end; at.increment(fault)) {
        std::error_code gone;  // others remove files, too
        const File file{at->last_write_time(gone), at->file_size(gone), at->path()};
        if (gone) continue;
        files.push_back(file);
        bytes += file.bytes;
    }
    std::ranges::sort(files, {}, &File::used);
    for (std::size_t i = 0; i < files.size() && bytes > most_bytes; ++i) {
        bytes -= files[i].bytes;
        std::filesystem::remove(files[i].path, fault);
    }
}

ProgramCache::ProgramCache(const Driver& driver, const ProgramText& text) {
    const std::filesystem::path in = driver.has_program_binaries ? folder() : std::filesystem::path();
    if (in.empty()) return;
    const std::uint64_t a = hash_of(text.pixels.text, hash_of(text.vertices.text, hash_of(driver.identity)));
    const std::uint64_t b = hash_of(driver.identity, hash_of(text.vertices.text, hash_of(text.pixels.text)));
    file_ = in / (hexadecimal(a) + hexadecimal(b) + ".bin");
}

bool ProgramCache::load(GLuint program) const {
    std::error_code fault;
    if (file_.empty() || !std::filesystem::is_regular_file(file_, fault)) return false;
    const std::uintmax_t size = std::filesystem::file_size(file_, fault);
    Header header{};
    if (fault || size <= sizeof header || size > most_bytes) return false;
    std::filesystem::last_write_time(file_, std::filesystem::file_time_type::clock::now(), fault);  // it is in use
    std::ifstream file(file_, std::ios::binary);
    std::vector<char> bytes(std::size_t(size) - sizeof header);
    if (!file.read(reinterpret_cast<char*>(&header), sizeof header) ||
        !file.read(bytes.data(), std::streamsize(bytes.size())) || header.hash != hash_of({bytes.data(), bytes.size()}))
        return false;
    glProgramBinary(program, GLenum(header.format), bytes.data(), GLsizei(bytes.size()));
    return glGetError() == GL_NO_ERROR;
}

void ProgramCache::prepare(GLuint program) const {
    if (!file_.empty()) glProgramParameteri(program, GL_PROGRAM_BINARY_RETRIEVABLE_HINT, GL_TRUE);
}

void ProgramCache::store(GLuint program) const {
    if (file_.empty()) return;
    GLint size = 0;
    glGetProgramiv(program, GL_PROGRAM_BINARY_LENGTH, &size);
    if (size <= 0 || std::size_t(size) > most_bytes) return;
    GLenum format = 0;
    std::vector<char> bytes(std::size_t(size), '\0');
    glGetProgramBinary(program, size, &size, &format, bytes.data());
    if (glGetError() != GL_NO_ERROR || size <= 0) return;
    const Header header{hash_of({bytes.data(), std::size_t(size)}), format};
    static std::atomic<unsigned> count{0};
    std::error_code fault;
    std::filesystem::create_directories(file_.parent_path(), fault);
    const std::filesystem::path part = format_text("{}.{}.{}.part", file_.string(), getpid(), ++count);
    {
        std::ofstream file(part, std::ios::binary);
        file.write(reinterpret_cast<const char*>(&header), sizeof header);
        file.write(bytes.data(), size);
        if (!file.flush()) fault = std::make_error_code(std::errc::io_error);
    }
    if (!fault) std::filesystem::rename(part, file_, fault);
    if (fault)
        std::filesystem::remove(part, fault);
    else
        remove_least_used(file_.parent_path(), most_bytes);
}

}  // namespace rakelight::opengl
