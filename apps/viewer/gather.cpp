// SPDX-License-Identifier: Apache-2.0
#include "gather.h"

#include <filesystem>
#include <map>

#include <rakelight/error.h>

namespace rakelight::viewer {
namespace {

namespace fs = std::filesystem;

bool is_outside(const fs::path& name) {
    return !name.empty() && (name.is_absolute() || *name.lexically_normal().begin() == "..");
}

/// "folder/scene.scene.toml": "folder/scene-files"
fs::path files_beside(const fs::path& world) { return world.parent_path() / (world.stem().stem().string() + "-files"); }

class Gatherer {
public:
    explicit Gatherer(const fs::path& world) : folder_(world.parent_path()), files_(files_beside(world)) {}

    void take(std::string& name) {
        if (!is_outside(name)) return;
        auto [known, is_new] = copies_.try_emplace(name);
        if (is_new) known->second = copy(name);
        name = known->second;
    }
    std::size_t count() const { return copies_.size(); }

private:
    /// @return the copy's name from the world's folder
    std::string copy(const fs::path& name) const {
        const fs::path from = name.is_absolute() ? name : folder_ / name;
        std::error_code fault;
        fs::create_directories(files_, fault);
        fs::path to = files_ / name.filename();
        for (int i = 2; !fault && fs::exists(to, fault); ++i)
            to = files_ / (name.stem().string() + "-" + std::to_string(i) + name.extension().string());
        if (!fault) fs::copy_file(from, to, fault);
        if (fault)
            throw Error(ErrorCode::failed, "cannot be copied beside the scene: " + fault.message())
                .with_file(from.string());
        return (files_.filename() / to.filename()).generic_string();
    }

    fs::path folder_, files_;
    std::map<std::string, std::string> copies_;
};

}  // namespace

std::size_t gather_pictures(WorldFile& world, const std::string& path) {
    Gatherer gatherer(path);
    if (world.environment) gatherer.take(world.environment->file);
    for (WorldMaterial& material : world.materials)
        for (WorldValue& value : material.values)
            if (value.key.ends_with("_texture") && !value.words.empty()) gatherer.take(value.words[0]);
    for (WorldValue& value : world.render) {
        const RenderKey* const key = find_render_key(value.key);
        if (!key || key->kind != RenderKey::Kind::file) continue;
        for (std::string& word : value.words) gatherer.take(word);
    }
    return gatherer.count();
}

}  // namespace rakelight::viewer
