// SPDX-License-Identifier: Apache-2.0
// The files that Assimp may see: those of the model's own folder tree, for reading only.
#pragma once
#include <assimp/IOSystem.hpp>

#include <string>

namespace rakelight::import_helper {

/// Everything outside the folder, everything that is no regular file and every wish to write is answered with "not there".
/// Where it is requested, UTF-16 text is handed out as UTF-8: Assimp's ASE reader knows no other.
class FolderIo final : public Assimp::IOSystem {
public:
    FolderIo(const std::string& model, bool allow_outside, bool convert_utf16);
    bool Exists(const char* path) const override;
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* path, const char* mode) override;
    void Close(Assimp::IOStream* stream) override;

private:
    bool allowed(const char* path) const;
    std::string folder_;  ///< canonical, with a slash at the end
    bool allow_outside_, convert_utf16_;
};

}  // namespace rakelight::import_helper
