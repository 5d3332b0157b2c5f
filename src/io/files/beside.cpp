// SPDX-License-Identifier: Apache-2.0
#include "io/files/beside.h"

#include <system_error>

#include <rakelight/base/error.h>

#include "io/files/file.h"
#include "io/files/output_file.h"

namespace rakelight::io {

namespace fs = std::filesystem;

fs::path folder_of(const std::string& path) {
    const fs::path parent = fs::path(path).parent_path();
    return parent.empty() ? fs::path(".") : parent;
}

bool is_same_folder(const std::string& a, const std::string& b) {
    std::error_code error;
    return fs::equivalent(folder_of(a), folder_of(b), error) && !error;
}

bool is_same_place(const std::string& a, const std::string& b) {
    if (fs::path(a).filename() != fs::path(b).filename()) return false;
    const auto folder = [](const std::string& path) {
        std::error_code error;
        return fs::weakly_canonical(fs::absolute(folder_of(path), error), error);
    };
    return folder(a) == folder(b);
}

void write_file(const std::string& path, std::span<const std::byte> bytes) {
    OutputFile file(path);
    file.write(bytes);
    file.commit();
}

bool is_inside(const std::string& name) {
    const fs::path path(name);
    return !name.empty() && path.is_relative() && *path.begin() != ".." && name.find("://") == std::string::npos;
}

void copy_beside(const std::vector<NamedFile>& files, const std::string& output, Context& context) {
    std::vector<const NamedFile*> missing;
    for (const NamedFile& file : files) {
        const std::string to = (folder_of(output) / file.name).string();
        if (!is_regular_file(to))
            missing.push_back(&file);
        else if (*read_file(to, context) != *read_file(file.path, context))
            throw Error(ErrorCode::failed,
                        "'" + one_line(file.name, 80) + "' already exists and differs from the model's file", {},
                        "write to the model's own folder, to an empty one, or as .glb");
    }
    for (const NamedFile* file : missing) {
        write_file((folder_of(output) / file->name).string(), *read_file(file->path, context));
    }
}

}  // namespace rakelight::io
