#include "core/drawing_files/dxf/dxf_text.hpp"

#include "core/engine/base/letter_case.hpp"
#include "core/files/common/names.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>

#if __has_include(<iconv.h>)
#include <iconv.h>
#define FOREFRONT_ICONV 1
#else
#define FOREFRONT_ICONV 0
#endif

namespace forefront {

namespace {

bool isAscii(std::string_view text) {
    return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

void appendUtf8(std::string &text, std::uint32_t character) {
    if (character < 0x80) {
        text += static_cast<char>(character);
    } else if (character < 0x800) {
        text += static_cast<char>(0xc0 | (character >> 6));
        text += static_cast<char>(0x80 | (character & 0x3f));
    } else {
        text += static_cast<char>(0xe0 | (character >> 12));
        text += static_cast<char>(0x80 | ((character >> 6) & 0x3f));
        text += static_cast<char>(0x80 | (character & 0x3f));
    }
}

/// Returns the name of a code page for iconv: "ANSI_1252" and "DOS850" are "CP1252" and "CP850".
[[maybe_unused]] std::string pageName(std::string_view codepage) {
    const std::string lower = lowerCase(codepage);
    const std::size_t digits = lower.find_first_of("0123456789");
    if (lower.starts_with("iso8859") || lower.starts_with("iso-8859")) {
        return lower;
    }
    return digits == std::string::npos ? "CP1252" : "CP" + lower.substr(digits);
}

std::string decoded(std::string_view text, std::string_view codepage) {
#if FOREFRONT_ICONV
    const iconv_t page = iconv_open("UTF-8", pageName(codepage).c_str());
    if (page == reinterpret_cast<iconv_t>(-1)) { // NOLINT: this is how iconv_open() fails
        return std::string(text);
    }
    std::string from(text), to(4 * text.size() + 4, '\0');
    char *in = from.data(), *out = to.data();
    std::size_t left = from.size(), room = to.size();
    while (left > 0 && iconv(page, &in, &left, &out, &room) == static_cast<std::size_t>(-1) && left > 0 && room > 3) {
        for (const char c : std::string_view("\xef\xbf\xbd")) { // U+FFFD
            *out++ = c;
            --room;
        }
        ++in;
        --left;
    }
    iconv_close(page);
    to.resize(to.size() - room);
    return to;
#else
    static_cast<void>(codepage);
    return std::string(text);
#endif
}

/// Replaces \U+XXXX, which older versions write for characters outside their code page.
std::string unescaped(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        std::uint32_t character = 0;
        if ((text.starts_with("\\U+") || text.starts_with("\\u+")) && text.size() >= 7) {
            const auto [end, error] = std::from_chars(text.data() + 3, text.data() + 7, character, 16);
            const bool surrogate = character >= 0xd800 && character < 0xe000;
            if (error == std::errc() && end == text.data() + 7 && !surrogate) {
                appendUtf8(result, character);
                text.remove_prefix(7);
                continue;
            }
        }
        result += text.front();
        text.remove_prefix(1);
    }
    return result;
}

} // namespace

std::string DxfEncoding::name(std::string_view text) const {
    const bool plain = utf8 || isAscii(text);
    return cleanName(unescaped(plain ? std::string(text) : decoded(text, codepage)));
}

} // namespace forefront
