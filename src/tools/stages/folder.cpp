// SPDX-License-Identifier: Apache-2.0
#include "tools/stages/folder.h"

#include <unistd.h>

#include <fstream>
#include <set>

#include <nlohmann/json.hpp>

#include <rakelight/base/error.h>

#include "base/format_text.h"
#include "io/files/file.h"
#include "io/files/output_file.h"
#include "io/pictures/image_io.h"
#include "tools/report_json.h"

namespace rakelight::stages {
namespace {

namespace fs = std::filesystem;

constexpr const char *list_name = "stages.json", *schema = "rakelight.stages/1";
constexpr std::uintmax_t longest_list = 1 << 20;

[[noreturn]] void refuse(const std::string& reason, const fs::path& path) {
    throw Error(ErrorCode::failed, reason).with_file(path.string());
}

/// Names that an earlier run listed; empty where there is no such list.
std::set<std::string> listed_files(const fs::path& folder) {
    std::set<std::string> names;
    std::error_code error;
    const fs::path list = folder / list_name;
    if (!fs::is_regular_file(fs::symlink_status(list, error)) || fs::file_size(list, error) > longest_list)
        return names;
    std::ifstream in(list, std::ios::binary);
    const nlohmann::json json = nlohmann::json::parse(in, nullptr, false);
    if (!json.is_object() || json.value("schema", nlohmann::json()) != schema || !json.contains("files") ||
        !json["files"].is_array())
        return names;
    for (const nlohmann::json& name : json["files"])
        if (name.is_string()) names.insert(name.get<std::string>());
    names.insert(list_name);
    return names;
}

void check_target(const fs::path& target) {
    std::error_code error;
    const fs::file_status status = fs::symlink_status(target, error);
    if (!fs::exists(status)) return;
    if (!fs::is_directory(status)) refuse("is there and is no folder", target);
    std::set<std::string> ours;
    bool is_read = false;
    fs::directory_iterator entries(target, error), end;
    if (error) refuse("cannot be read: " + error.message(), target);
    for (; entries != end; entries.increment(error)) {
        if (error) refuse("cannot be read: " + error.message(), target);
        if (!is_read) ours = listed_files(target);
        is_read = true;
        if (!fs::is_regular_file(entries->symlink_status(error)) || !ours.contains(entries->path().filename().string()))
            throw Error(ErrorCode::failed, "the folder contains other files", entries->path().filename().string(),
                        "name a new or an empty folder")
                .with_file(target.string());
    }
}

fs::path beside(const fs::path& target, const char* what) {
    return target.parent_path() / (format_text(".{}.{}-{}", target.filename().string(), what, getpid()));
}

}  // namespace

NewFolder::NewFolder(const std::string& target) : target_(fs::absolute(target).lexically_normal()) {
    if (!target_.has_filename()) target_ = target_.parent_path();  // "out/"
    target_ = io::behind_links(target_.string());
    if (!target_.has_filename()) refuse("is no name for a folder", target);
    check_target(target_);
    above_.make_above(target.substr(0, target.find_last_not_of('/') + 1));  // messages have it as it was written
    work_ = beside(target_, "new");
    std::error_code error;
    if (!fs::create_directory(work_, error))
        refuse("cannot be made: " + (error ? error.message() : "a folder of that name is in the way"), target_);
    unfinished_.emplace_back().watch(work_.string());
}

NewFolder::~NewFolder() {
    std::error_code error;
    if (!work_.empty()) fs::remove_all(work_, error);
}

std::string NewFolder::watched(const std::string& name) {
    const std::string path = (work_ / name).string();
    unfinished_.emplace_back().watch(path);
    return path;
}

void NewFolder::write(const std::string& name, const std::string& text) {
    std::ofstream out(watched(name), std::ios::binary);
    out << text;
    out.close();
    if (!out) refuse("cannot be written", target_ / name);
    names_.push_back(name);
}

void NewFolder::write(const std::string& name, const Pixels& pixels) {
    io::write_image(watched(name), pixels, io::Sync::later);
    names_.push_back(name);
}

void NewFolder::finish() {
    const Json list = {{"schema", schema}, {"files", names_}};
    write(list_name, json_text(list, 1));
    for (const std::string& name : names_) io::sync_file((work_ / name).string());
    io::sync_folder(work_.string());
    check_target(target_);  // it may have changed meanwhile
    std::error_code error;
    const fs::path old = beside(target_, "old");
    const bool replaces = fs::exists(fs::symlink_status(target_, error));
    error.clear();  // "not there" is no fault
    if (replaces) fs::rename(target_, old, error);
    if (!error) fs::rename(work_, target_, error);
    if (error) {
        const std::string reason = error.message();
        if (replaces && !fs::exists(target_, error)) fs::rename(old, target_, error);
        refuse("cannot be put in place: " + reason, target_);
    }
    work_.clear();
    unfinished_.clear();
    above_.keep();
    io::sync_folder(target_.parent_path().string());
    if (replaces) fs::remove_all(old, error);
}

}  // namespace rakelight::stages
