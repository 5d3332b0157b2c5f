// SPDX-License-Identifier: Apache-2.0
// The broken files of ../shared/hostile, and what each must get.
#pragma once
#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "support/shared.h"

namespace rakelight::test {

struct HostileCase {
    std::string name;     ///< below the folder
    std::string fault;    ///< what is wrong with it
    std::string verdict;  ///< "refuse", "warn+render", "either", ...
    std::filesystem::path path;
};

/// Those of cases.json that have a verdict and are there.
inline std::vector<HostileCase> hostile_cases() {
    const std::filesystem::path root = shared_dir() / "hostile";
    std::ifstream in(root / "cases.json");
    std::vector<HostileCase> cases;
    for (const auto& entry : nlohmann::json::parse(in)) {
        HostileCase each{entry[0].get<std::string>(), entry[1].get<std::string>(), entry[2].get<std::string>(), {}};
        each.path = root / each.name;
        if (each.verdict != "-" && std::filesystem::exists(each.path)) cases.push_back(std::move(each));
    }
    return cases;
}

}  // namespace rakelight::test
