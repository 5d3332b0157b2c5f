// SPDX-License-Identifier: Apache-2.0
// Which lines of a GLSL text #if leaves out: as far as the text alone can tell.
#pragma once
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "engines/shader_tokens.h"

namespace rakelight {

enum class Branch { live, dead, unknown };

class ShaderBranches {
public:
    /// Of the lines here. Unknown: it depends on the engine or the driver.
    Branch state() const { return open_.empty() ? Branch::live : open_.back().state; }
    /// @param is_defined  whether a macro is; none: unknown
    /// @return whether the directive is one of branches that needs no more reading
    bool take(const ShaderDirective& directive, const std::function<std::optional<bool>(std::string_view)>& is_defined);

private:
    struct Open {
        Branch state, outside;
        bool had_live = false, had_unknown = false;  ///< branches before this one
    };
    void enter(std::optional<bool> condition);
    std::vector<Open> open_;
};

}  // namespace rakelight
