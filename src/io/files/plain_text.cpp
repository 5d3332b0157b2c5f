// SPDX-License-Identifier: Apache-2.0
#include "io/files/plain_text.h"

#include "base/utf16.h"

namespace rakelight::io {

PlainText::PlainText(std::string_view bytes, const std::string& path, Context& context) : bytes_(bytes) {
    if (!bytes.starts_with("\xFF\xFE") && !bytes.starts_with("\xFE\xFF")) return;
    charge_ = MemoryCharge(context.memory(), bytes.size() / 2 * 3, "text in UTF-16");  // three bytes a unit at most
    converted_ = utf8_from_utf16(bytes).value_or(std::string());
    context.report().add(Remark::note, path, "", "UTF-16 text was read as UTF-8");
}

}  // namespace rakelight::io
