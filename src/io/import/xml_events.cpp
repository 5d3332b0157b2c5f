// SPDX-License-Identifier: Apache-2.0
#include "io/import/xml_events.h"

#include <expat.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <string>
#include <type_traits>

#include <rakelight/base/error.h>

namespace rakelight::io {
namespace {

constexpr int deepest = 512;
constexpr std::size_t step = std::size_t(1) << 20;  ///< [bytes] given at once: expat counts them in an int

/// Between expat's callbacks, which no exception may pass, and a handler.
class Parser {
public:
    explicit Parser(XmlHandler& handler) : handler_(handler), expat_(XML_ParserCreate(nullptr), XML_ParserFree) {
        if (!expat_) throw Error(ErrorCode::failed, "out of memory");
        XML_SetUserData(expat_.get(), this);
        XML_SetElementHandler(
            expat_.get(),
            [](void* self, const char* name, const char** pairs) { of(self).start(name, XmlAttributes(pairs)); },
            [](void* self, const char* name) {
                of(self).guarded([&] { of(self).handler_.end(name); });
                --of(self).depth_;
            });
        XML_SetCharacterDataHandler(expat_.get(), [](void* self, const char* text, int size) {
            of(self).guarded([&] { of(self).handler_.text({text, std::size_t(size)}, of(self).line()); });
        });
        XML_SetStartDoctypeDeclHandler(expat_.get(), [](void* self, const char*, const char*, const char*, int) {
            of(self).guarded([&] { of(self).refuse("a document type or entity declaration, which is refused"); });
        });
        XML_SetUnknownEncodingHandler(
            expat_.get(),
            [](void*, const char*, XML_Encoding* encoding) {
                for (int i = 0; i < 256; ++i) encoding->map[i] = i;
                encoding->data = nullptr, encoding->convert = nullptr, encoding->release = nullptr;
                return int(XML_STATUS_OK);
            },
            nullptr);
    }

    void read(std::span<const std::byte> bytes) {
        for (std::size_t at = 0; at == 0 || at < bytes.size(); at += step) {
            const std::span<const std::byte> part = bytes.subspan(at, std::min(step, bytes.size() - at));
            const bool is_last = at + part.size() == bytes.size();
            const auto status =
                XML_Parse(expat_.get(), reinterpret_cast<const char*>(part.data()), int(part.size()), is_last);
            if (thrown_) std::rethrow_exception(thrown_);
            if (status != XML_STATUS_OK)
                refuse(std::string("not well-formed XML: ") + XML_ErrorString(XML_GetErrorCode(expat_.get())));
        }
    }

private:
    static Parser& of(void* self) { return *static_cast<Parser*>(self); }
    std::uint64_t line() const { return XML_GetCurrentLineNumber(expat_.get()); }
    [[noreturn]] void refuse(const std::string& what) const {
        throw Error(ErrorCode::bad_file, what, "line " + std::to_string(line()));
    }

    void start(const char* name, const XmlAttributes& attributes) {
        guarded([&] {
            if (++depth_ > deepest) refuse("elements are nested more than 512 deep");
            handler_.start(name, attributes);
        });
    }

    template <class Call>
    void guarded(const Call& call) {
        if (thrown_) return;
        try {
            call();
        } catch (...) {
            thrown_ = std::current_exception();
            XML_StopParser(expat_.get(), XML_FALSE);
        }
    }

    XmlHandler& handler_;
    std::unique_ptr<std::remove_pointer_t<XML_Parser>, void (*)(XML_Parser)> expat_;
    int depth_ = 0;
    std::exception_ptr thrown_;
};

}  // namespace

std::string_view XmlAttributes::operator[](std::string_view name) const {
    for (const char* const* pair = pairs_; *pair; pair += 2)
        if (name == pair[0]) return pair[1];
    return {};
}

void read_xml(std::span<const std::byte> bytes, XmlHandler& handler) { Parser(handler).read(bytes); }

}  // namespace rakelight::io
