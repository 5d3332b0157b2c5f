// SPDX-License-Identifier: Apache-2.0
#include "gather.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <vector>

#include <rakelight/base/error.h>
#include <rakelight/world/render_keys.h>
#include <rakelight_internal/tools/text_file.h>

namespace rakelight::viewer {
namespace {

namespace fs = std::filesystem;

bool is_outside(const fs::path& name) {
    return !name.empty() && (name.is_absolute() || *name.lexically_normal().begin() == "..");
}

/// "folder/scene.scene.toml": "folder/scene-files"
fs::path files_beside(const fs::path& world) { return world.parent_path() / (world.stem().stem().string() + "-files"); }

Error not_copied(const fs::path& from, const std::string& why) {
    return Error(ErrorCode::failed, "cannot be copied beside the scene: " + why).with_file(from.string());
}

std::string bytes_of(const fs::path& from) {
    std::error_code fault;
    if (!fs::is_regular_file(from, fault)) throw not_copied(from, fault ? fault.message() : "it is not a regular file");
    std::ifstream file(from, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(file), {}};
    if (!file) throw not_copied(from, "it cannot be read");
    return bytes;
}

/// Copies that are to be made, and then those that were; they go again unless they are kept.
class Copies {
public:
    explicit Copies(const fs::path& world) : folder_(world.parent_path()), files_(files_beside(world)) {}
    Copies(const Copies&) = delete;
    Copies& operator=(const Copies&) = delete;
    ~Copies() {
        std::error_code ignored;
        for (const fs::path& file : made_) fs::remove(file, ignored);
        if (is_folder_made_) fs::remove(files_, ignored);
    }

    /// Renames a file of the world to its copy where it lies outside.
    void take(std::string& name) {
        if (!is_outside(name)) return;
        auto [known, is_new] = names_.try_emplace(name);
        if (is_new) known->second = free_name(name);
        name = (files_.filename() / known->second).generic_string();
    }
    std::size_t count() const { return names_.size(); }

    void make() {
        std::error_code fault;
        if (!names_.empty()) is_folder_made_ = fs::create_directories(files_, fault);
        for (const auto& [name, copy] : names_) {
            const fs::path from = fs::path(name).is_absolute() ? fs::path(name) : folder_ / name;
            if (fault) throw not_copied(from, fault.message());
            const std::string bytes = bytes_of(from);
            made_.push_back(files_ / copy);
            save_text(made_.back().string(), bytes);
        }
    }
    void keep() { made_.clear(), is_folder_made_ = false; }

private:
    fs::path free_name(const fs::path& name) const {
        const auto is_taken = [this](const fs::path& file) {
            std::error_code ignored;
            for (const auto& [other, copy] : names_)
                if (copy == file) return true;
            return fs::exists(files_ / file, ignored);
        };
        fs::path file = name.filename();
        for (int i = 2; is_taken(file); ++i)
            file = name.stem().string() + "-" + std::to_string(i) + name.extension().string();
        return file;
    }

    fs::path folder_, files_;
    std::map<std::string, fs::path> names_;  ///< as the world has it, and of the copy
    std::vector<fs::path> made_;
    bool is_folder_made_ = false;
};

void take_files(Copies& copies, WorldFile& world) {
    if (world.environment) copies.take(world.environment->file);
    for (WorldMaterial& material : world.materials)
        for (WorldValue& value : material.values)
            if (value.key.ends_with("_texture") && !value.words.empty()) copies.take(value.words[0]);
    for (WorldValue& value : world.render) {
        if (!names_files(value)) continue;
        for (std::string& word : value.words) copies.take(word);
    }
}

}  // namespace

std::size_t save_with_files(WorldFile world, const std::string& path) {
    Copies copies(path);
    take_files(copies, world);
    to_toml(world);  // settings that cannot be written are found before anything is copied
    copies.make();
    save_world(world, path);
    copies.keep();
    return copies.count();
}

}  // namespace rakelight::viewer
