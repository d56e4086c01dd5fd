#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace forefront {

/// Encodes bytes as base64 (RFC 4648) with padding.
std::string toBase64(std::string_view bytes);
/// Decodes base64; std::nullopt if the text is not valid. Blanks and line ends are skipped.
std::optional<std::string> fromBase64(std::string_view text);

} // namespace forefront
