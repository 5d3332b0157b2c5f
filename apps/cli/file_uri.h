// SPDX-License-Identifier: Apache-2.0
// Files as file managers name them: "file:///home/me/a%20b.glb".
#pragma once
#include <string>

namespace rakelight::cli {

/// The path that a file's address means (RFC 8089: file:/PATH or file://HOST/PATH, where the host is empty, localhost or
/// this machine's name; %XX decoded). Words that are no address stay as they are.
/// @throws Error usage: an address of another kind or machine, a broken %XX, %00
std::string path_of_uri(const std::string& word);

/// Whether it begins as the address of a file: "file:/".
bool is_file_uri(const std::string& word);

}  // namespace rakelight::cli
