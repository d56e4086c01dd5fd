#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace forefront {

/// RFC 4648 with padding.
std::string toBase64(std::string_view bytes);
/// Nothing where the text is no base64; blanks and line ends are skipped.
std::optional<std::string> fromBase64(std::string_view text);

} // namespace forefront
