// SPDX-License-Identifier: Apache-2.0
#include "io/import/temporary_file.h"

#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "io/files/descriptor.h"
#include "io/files/output_file.h"

namespace rakelight::io {

TemporaryFile::TemporaryFile(const std::string& name, std::span<const std::byte> bytes) {
    std::error_code fault, ignored;
    folder_ = (std::filesystem::temp_directory_path(fault) / "rakelight-XXXXXX").string();
    if (fault) throw Error(ErrorCode::failed, "there is no folder for temporary files: " + fault.message());
    if (::mkdtemp(folder_.data()) == nullptr)
        throw Error(ErrorCode::failed, "no temporary folder can be made: " + system_message(errno));
    path_ = folder_ + "/" + name;
    try {
        OutputFile file(path_);
        file.write(bytes);
        file.commit(Sync::later);
    } catch (...) {
        std::filesystem::remove_all(folder_, ignored);
        throw;
    }
}

TemporaryFile::~TemporaryFile() {
    ::unlink(path_.c_str());
    ::rmdir(folder_.c_str());
}

}  // namespace rakelight::io
