// SPDX-License-Identifier: Apache-2.0
#include <rakelight/base/current_error.h>

#include <new>
#include <stdexcept>
#include <system_error>

namespace rakelight {

Error current_error(const std::string& out_of_memory) {
    try {
        throw;
    } catch (const Error& error) {
        return error;
    } catch (const std::bad_alloc&) {
        return Error(ErrorCode::failed, out_of_memory);
    } catch (const std::length_error&) {  // a container larger than any memory
        return Error(ErrorCode::failed, out_of_memory);
    } catch (const std::system_error& error) {
        return Error(ErrorCode::failed, "unexpected: " + error.code().message());
    } catch (const std::runtime_error& error) {  // of a library, for people
        return Error(ErrorCode::failed, std::string("unexpected: ") + error.what());
    } catch (...) {  // a logic error, whose text names functions instead of the problem
        return Error(ErrorCode::failed, "an internal error stopped the work", {}, "please report it with the file");
    }
}

}  // namespace rakelight
