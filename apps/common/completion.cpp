// SPDX-License-Identifier: Apache-2.0
#include "completion.h"

#include <rakelight/world/values.h>

namespace rakelight::apps {
namespace {

using Script = std::string (*)(const Program&);
constexpr Word<Script> shells[] = {{"bash", bash_completion}, {"zsh", zsh_completion}, {"fish", fish_completion}};

}  // namespace

std::vector<std::string> completion_shells() { return names_of<shells>(); }

std::string completion_for(const Program& program, const std::vector<std::string>& words) {
    if (words.empty() || words[0] != "--completion") return {};
    if (words.size() != 2) throw Error(ErrorCode::usage, "--completion takes a shell: bash, zsh or fish");
    return values::word<Script>("completion", words[1], shells)(program);
}

}  // namespace rakelight::apps
