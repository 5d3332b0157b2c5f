// SPDX-License-Identifier: Apache-2.0
#include "folder_io.h"

#include <assimp/MemoryIOWrapper.h>
#include <assimp/IOStream.hpp>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <climits>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>

#include "base/utf16.h"

namespace rakelight::import_helper {
namespace {

std::string canonical(const char* path) {
    char resolved[PATH_MAX];
    return realpath(path, resolved) ? resolved : "";
}

bool is_regular(const char* path) {
    struct stat info {};
    return stat(path, &info) == 0 && S_ISREG(info.st_mode);
}

/// Read-only. Seeks outside the file fail, as Assimp expects.
class FileStream final : public Assimp::IOStream {
public:
    FileStream(int file, std::size_t size) : file_(file), size_(size) {}
    ~FileStream() override { close(file_); }
    size_t Read(void* to, size_t element, size_t count) override {
        if (element == 0 || count > SIZE_MAX / element) return 0;
        std::size_t done = 0;
        while (done < element * count) {
            const ssize_t got = pread(file_, static_cast<char*>(to) + done, element * count - done, off_t(at_));
            if (got <= 0) break;
            done += std::size_t(got);
            at_ += std::size_t(got);
        }
        return done / element;
    }
    size_t Write(const void*, size_t, size_t) override { return 0; }
    aiReturn Seek(size_t offset, aiOrigin origin) override {
        const std::size_t base = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? at_ : size_;
        const std::size_t target = base + offset;  // a negative offset comes as a wrapped unsigned one
        if (target > size_) return aiReturn_FAILURE;
        at_ = target;
        return aiReturn_SUCCESS;
    }
    size_t Tell() const override { return at_; }
    size_t FileSize() const override { return size_; }
    void Flush() override {}

private:
    int file_;
    std::size_t size_, at_ = 0;
};

/// A UTF-16 file's text as UTF-8; null for every other file.
Assimp::IOStream* converted(FileStream& file) {
    char mark[2] = {};
    const bool read = file.Read(mark, 1, 2) == 2;
    file.Seek(0, aiOrigin_SET);
    if (!read || !((mark[0] == '\xFF' && mark[1] == '\xFE') || (mark[0] == '\xFE' && mark[1] == '\xFF')))
        return nullptr;
    std::string bytes(file.FileSize(), '\0');
    bytes.resize(file.Read(bytes.data(), 1, bytes.size()));
    file.Seek(0, aiOrigin_SET);
    const auto text = utf8_from_utf16(bytes);
    if (!text) return nullptr;
    auto* copy = new std::uint8_t[text->size()];
    std::memcpy(copy, text->data(), text->size());
    return new Assimp::MemoryIOStream(copy, text->size(), true);
}

}  // namespace

FolderIo::FolderIo(const std::string& model, bool allow_outside, bool convert_utf16)
    : allow_outside_(allow_outside), convert_utf16_(convert_utf16) {
    const std::size_t slash = model.rfind('/');
    folder_ = canonical(slash == std::string::npos ? "." : slash == 0 ? "/" : model.substr(0, slash).c_str());
    if (folder_.empty() || folder_.back() != '/') folder_ += '/';
}

bool FolderIo::allowed(const char* path) const {
    const std::string real = canonical(path);
    return !real.empty() && is_regular(real.c_str()) &&
           (allow_outside_ || real.compare(0, folder_.size(), folder_) == 0);
}

bool FolderIo::Exists(const char* path) const { return path && allowed(path); }

Assimp::IOStream* FolderIo::Open(const char* path, const char* mode) {
    if (!path || !mode || std::strpbrk(mode, "wa+") || !allowed(path)) return nullptr;
    const int file = open(path, O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
    struct stat info {};
    if (file < 0) return nullptr;
    if (fstat(file, &info) != 0 || !S_ISREG(info.st_mode)) {
        close(file);
        return nullptr;
    }
    auto* stream = new FileStream(file, std::size_t(info.st_size));
    if (!convert_utf16_) return stream;
    Assimp::IOStream* text = converted(*stream);
    if (text) delete stream;
    return text ? text : stream;
}

void FolderIo::Close(Assimp::IOStream* stream) { delete stream; }

}  // namespace rakelight::import_helper
