#pragma once

#include <string>
#include <string_view>

namespace forefront {

/// The encoding of the texts of a DXF file.
struct DxfEncoding {
    bool utf8 = false;    ///< since AC1021, the format of 2007; older files use a code page
    std::string codepage; ///< the value of $DWGCODEPAGE, such as "ANSI_1252"

    /// Returns a name of the file as UTF-8, cleaned as by cleanName(). Escapes \U+XXXX become characters. Bytes that
    /// the encoding does not define, and all those above 127 if the machine does not know the code page, become U+FFFD.
    std::string name(std::string_view text) const;
};

} // namespace forefront
