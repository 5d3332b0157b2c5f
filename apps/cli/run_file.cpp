// SPDX-License-Identifier: Apache-2.0
#include "run_file.h"

#include <new>

namespace rakelight::cli {

Error current_error(const std::string& file) {
    try {
        throw;
    } catch (const Error& error) {
        return error.with_file(file);
    } catch (const std::bad_alloc&) {
        return Error(ErrorCode::failed, "out of memory").with_file(file);
    } catch (const std::exception& error) {
        return Error(ErrorCode::failed, std::string("unexpected: ") + error.what()).with_file(file);
    }
}

}  // namespace rakelight::cli
