// SPDX-License-Identifier: Apache-2.0
// Checks as JUnit's XML: what build servers show as tests.
#include <algorithm>

#include <programs/tools/inspection_report.h>

#include "tools/html.h"
#include "tools/report_json.h"

namespace rakelight {
namespace {

std::string attribute(const char* name, const std::string& value) {
    return std::string(" ") + name + "=\"" + html_text(value) + "\"";
}

std::string test_case(const InspectionRow& row, const std::string& name, const std::string& inside) {
    const std::string head =
        "    <testcase" + attribute("classname", row.file.empty() ? "?" : row.file) + attribute("name", name);
    return head + (inside.empty() ? "/>\n" : ">\n" + inside + "    </testcase>\n");
}

std::string fault(const char* kind, const std::string& type, const std::string& message) {
    return std::string("      <") + kind + attribute("type", type) + attribute("message", message) + ">" +
           html_text(message) + "</" + kind + ">\n";
}

struct Suite {
    std::string cases;
    std::size_t tests = 0, failures = 0, errors = 0;
};

Suite suite_of(const InspectionRow& row, const CheckLimits& limits) {
    Suite suite;
    const auto add = [&](const std::string& name, const std::string& inside) {
        suite.cases += test_case(row, name, inside);
        ++suite.tests;
    };
    if (row.error) {
        add("load", fault("error", name_of(row.error->code()), row.error->what()));
        suite.errors = 1;
        return suite;
    }
    add("load", "");
    if (!row.check) return suite;
    for (const std::string& limit : names_of(limits)) {
        const auto failed =
            std::ranges::find_if(*row.check, [&](const CheckFailure& failure) { return failure.limit == limit; });
        const bool passed = failed == row.check->end();
        add(limit, passed ? "" : fault("failure", limit, failed->message));
        suite.failures += !passed;
    }
    return suite;
}

std::string counts(std::size_t tests, std::size_t failures, std::size_t errors) {
    return attribute("tests", std::to_string(tests)) + attribute("failures", std::to_string(failures)) +
           attribute("errors", std::to_string(errors));
}

}  // namespace

std::string to_junit(std::span<const InspectionRow> rows, const CheckLimits& limits) {
    std::string suites;
    std::size_t tests = 0, failures = 0, errors = 0;
    for (const InspectionRow& row : rows) {
        const Suite s = suite_of(row, limits);
        suites += "  <testsuite" + attribute("name", row.file) + counts(s.tests, s.failures, s.errors) + ">\n" +
                  s.cases + "  </testsuite>\n";
        tests += s.tests, failures += s.failures, errors += s.errors;
    }
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"rakelight inspect\"" +
           counts(tests, failures, errors) + ">\n" + suites + "</testsuites>\n";
}

}  // namespace rakelight
