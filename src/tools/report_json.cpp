// SPDX-License-Identifier: Apache-2.0
#include "tools/report_json.h"

#include <nlohmann/json.hpp>

#include <programs/base/exit_code.h>

namespace rakelight {

const char* name_of(ErrorCode code) {
    switch (code) {
        case ErrorCode::failed:
            return "failed";
        case ErrorCode::usage:
            return "usage";
        case ErrorCode::not_found:
            return "not_found";
        case ErrorCode::bad_file:
            return "bad_file";
        case ErrorCode::check_failed:
            return "check_failed";
    }
    return "failed";
}

Json remarks_json(const std::vector<ReportEntry>& remarks) {
    Json list = Json::array();
    for (const ReportEntry& r : remarks) {
        list.push_back({{"remark", name_of(r.remark)},
                        {"file", r.file},
                        {"place", r.place},
                        {"message", r.message},
                        {"count", r.count}});
        if (!r.settings.empty()) list.back()["settings"] = r.settings;
    }
    return list;
}

Json error_json(const Error& error) {
    return {{"code", name_of(error.code())}, {"exit_code", exit_code(error.code())},
            {"message", error.reason()},     {"setting", error.setting()},
            {"settings", error.related()},   {"file", error.file()},
            {"place", error.place()},        {"advice", error.advice()}};
}

std::string json_text(const Json& whole, int spaces_a_level) {
    return whole.dump(spaces_a_level, ' ', true, Json::error_handler_t::replace) + "\n";
}

std::string document(const char* schema, Json rows) {
    return json_text({{"schema", schema}, {"rows", std::move(rows)}});
}

}  // namespace rakelight
