// SPDX-License-Identifier: Apache-2.0
#include "io/files/held_outputs.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <set>
#include <system_error>

#include "base/assert.h"
#include "io/files/beside.h"
#include "io/files/descriptor.h"
#include "io/files/file.h"

namespace rakelight::io {
namespace {

thread_local HeldOutputs* held_here = nullptr;

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

File opened(const std::string& path) {
    return {std::fopen(path.c_str(), "rb"), [](std::FILE* f) { return f ? std::fclose(f) : 0; }};
}

bool has_same_bytes(const std::string& a, const std::string& b) {
    const File x = opened(a), y = opened(b);
    std::array<char, 65536> p, q;
    for (std::size_t got = p.size(); x && y && got == p.size();) {
        got = std::fread(p.data(), 1, p.size(), x.get());
        if (std::fread(q.data(), 1, q.size(), y.get()) != got || !std::equal(p.begin(), p.begin() + got, q.begin()))
            return false;
    }
    return x && y;
}

[[noreturn]] void refuse(const std::string& path) {
    throw Error(ErrorCode::failed, "cannot be written: " + system_message(errno)).with_file(path);
}

}  // namespace

HeldOutputs::HeldOutputs() {
    RL_ASSERT(held_here == nullptr, "held outputs do not nest");
    held_here = this;
}

HeldOutputs::~HeldOutputs() {
    held_here = nullptr;
    for (const Held& held : files_) {
        if (!held.temporary.empty()) ::unlink(held.temporary.c_str());
        if (!held.backup.empty()) ::unlink(held.backup.c_str());
    }
}

HeldOutputs* HeldOutputs::current() { return held_here; }

void HeldOutputs::take(const std::string& temporary, const std::string& path, MadeFolders& folders) {
    const auto same = std::ranges::find_if(files_, [&](const Held& h) { return is_same_place(h.path, path); });
    if (same != files_.end()) {
        if (!has_same_bytes(same->temporary, temporary))
            throw Error(ErrorCode::failed, "two outputs need a file of this name with different content", {},
                        "write them to different folders")
                .with_file(path);
        ::unlink(temporary.c_str());
    } else {
        Held& held = files_.emplace_back();
        held.temporary = temporary, held.path = path;
        held.unfinished.watch(temporary);
    }
    folders.give_to(folders_);
}

void HeldOutputs::put_in_place(Held& held) {
    if (files_.size() > 1 && is_regular_file(held.path)) {
        held.backup = held.temporary + ".old";
        // A second name for the old content; file systems without such names leave a moment without the file.
        if (::link(held.path.c_str(), held.backup.c_str()) != 0 &&
            std::rename(held.path.c_str(), held.backup.c_str()) != 0) {
            held.backup.clear();
            refuse(held.path);
        }
    }
    if (std::rename(held.temporary.c_str(), held.path.c_str()) == 0) return;
    const int code = errno;
    if (!held.backup.empty() && std::rename(held.backup.c_str(), held.path.c_str()) == 0) {
        ::unlink(held.backup.c_str());  // rename() of two names of one file leaves both
        held.backup.clear();
    }
    errno = code;
    refuse(held.path);
}

void HeldOutputs::put_back() noexcept {
    for (; renamed_ > 0; --renamed_) {
        Held& held = files_[renamed_ - 1];
        if (held.backup.empty())
            ::unlink(held.path.c_str());
        else if (std::rename(held.backup.c_str(), held.path.c_str()) == 0)
            held.backup.clear();
    }
}

void HeldOutputs::commit() {
    try {
        for (Held& held : files_) {
            put_in_place(held);
            held.temporary.clear(), held.unfinished.forget();
            ++renamed_;
        }
    } catch (const Error&) {
        put_back();
        throw;
    }
    folders_.keep();
    std::set<std::string> folders;
    for (Held& held : files_) {
        if (!held.backup.empty()) ::unlink(held.backup.c_str());
        folders.insert(folder_of(held.path).string());
    }
    files_.clear(), renamed_ = 0;
    for (const std::string& folder : folders) sync_folder(folder);
}

}  // namespace rakelight::io
