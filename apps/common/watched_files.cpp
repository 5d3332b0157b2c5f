// SPDX-License-Identifier: Apache-2.0
#include "watched_files.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <thread>

namespace rakelight::apps {
namespace {

std::filesystem::file_time_type time_of(const std::string& file) {
    std::error_code fault;
    const auto time = std::filesystem::last_write_time(file, fault);
    return fault ? std::filesystem::file_time_type{} : time;
}

}  // namespace

void WatchedFiles::begin(const std::string& file) {
    if (files_.empty() || files_[0].path != file) files_.assign(1, {.path = file});
    if (file.empty()) files_.clear();
    began_ = std::filesystem::file_time_type::clock::now();
    for (File& f : files_) f.read = f.seen = time_of(f.path);
    next_ = 0;
}

/// Files that are known keep the time of begin(), and what is younger than that counts as changed: a change while they were read
/// is not missed.
void WatchedFiles::take(const std::vector<std::string>& files) {
    if (files_.empty()) return;
    std::map<std::string, File> known;
    for (const File& f : files_) known.emplace(f.path, f);
    files_.resize(1);
    known.at(files_[0].path).path.clear();  // it is there
    for (const std::string& path : files) {
        if (files_.size() >= most_) break;
        const auto [file, is_new] = known.emplace(path, File{.path = path});
        if (is_new) file->second.read = file->second.seen = std::min(time_of(path), began_);
        if (!file->second.path.empty()) files_.push_back(file->second);
        file->second.path.clear();  // each once
    }
    next_ = 0;
}

void WatchedFiles::add(const std::vector<std::string>& files, std::optional<Time> began) {
    for (const std::string& path : files) {
        if (files_.empty() || files_.size() >= most_) return;
        if (std::ranges::find(files_, path, &File::path) != files_.end()) continue;
        const Time now = time_of(path), read = began ? std::min(now, *began) : now;
        files_.push_back({.path = path, .read = read, .seen = read});
    }
}

bool WatchedFiles::has_changed() {
    bool has_settled = false, is_changing = false;
    for (std::size_t n = std::min(at_once, files_.size()); n > 0; --n) {
        File& f = files_[next_];
        next_ = (next_ + 1) % files_.size();
        const Time now = time_of(f.path);
        if (now == Time{} || now == f.read) continue;
        (now == f.seen ? has_settled : is_changing) = true;
        f.seen = now;
    }
    return has_settled && !is_changing;
}

std::string WatchedFiles::wait() {
    constexpr auto pause = std::chrono::milliseconds(100);
    while (!has_changed()) std::this_thread::sleep_for(pause);
    std::string changed;
    for (File& f : files_) {
        if (f.seen != f.read && changed.empty()) changed = f.path;
        f.read = f.seen;
    }
    return changed;
}

}  // namespace rakelight::apps
