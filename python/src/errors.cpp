// SPDX-License-Identifier: Apache-2.0
#include "errors.h"

#include <rakelight/base/error.h>

namespace rakelight::python {
namespace {

const char* class_of(ErrorCode code) {
    switch (code) {
        case ErrorCode::usage:
            return "UsageError";
        case ErrorCode::not_found:
            return "NotFoundError";
        case ErrorCode::bad_file:
            return "BadFileError";
        case ErrorCode::failed:
        case ErrorCode::check_failed:
            break;
    }
    return "Error";
}

void raise(const Error& error) {
    try {
        const py::object type = py::module_::import("rakelight._errors").attr(class_of(error.code()));
        py::object exception = type(text_of(error.what()));
        exception.attr("reason") = text_of(error.reason());
        exception.attr("file") = text_of(error.file());
        exception.attr("place") = text_of(error.place());
        exception.attr("advice") = text_of(error.advice());
        exception.attr("setting") = text_of(error.setting());
        PyErr_SetObject(type.ptr(), exception.ptr());
    } catch (py::error_already_set& other) {
        other.restore();
    }
}

}  // namespace

py::str text_of(const std::string& bytes) {
    return py::reinterpret_steal<py::str>(PyUnicode_DecodeUTF8(bytes.data(), py::ssize_t(bytes.size()), "replace"));
}

void translate_errors() {
    py::register_local_exception_translator([](std::exception_ptr pointer) {
        try {
            if (pointer) std::rethrow_exception(pointer);
        } catch (const Error& error) {
            raise(error);
        } catch (const py::cast_error&) {
            raise(Error(ErrorCode::usage, "an argument has the wrong type"));
        }
    });
}

py::list remarks_of(const Report& report, std::size_t known) {
    py::list list;
    const std::vector<ReportEntry> entries = report.entries();
    for (std::size_t i = known; i < entries.size(); ++i) {
        const ReportEntry& e = entries[i];
        list.append(py::make_tuple(name_of(e.remark), text_of(e.file), text_of(e.place), text_of(e.message), e.count));
    }
    return list;
}

}  // namespace rakelight::python
