// SPDX-License-Identifier: Apache-2.0
// The files that an OBJ model needs beside it.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include <rakelight/base/context.h>

#include "io/files/beside.h"
#include "io/reader.h"

namespace rakelight::io::obj {

/// The MTL files that `text` names and the pictures that those name, also of maps that are not read here; each once,
/// found as the reader finds them. What is missing is left out (the reader has said so); what does not lie in the
/// model's folder is left out with a warning.
std::vector<NamedFile> material_files(std::string_view text, const std::string& model_path, const ReadOptions& options,
                                      Context& context);

}  // namespace rakelight::io::obj
