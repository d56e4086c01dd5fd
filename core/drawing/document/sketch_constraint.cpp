#include "core/drawing/document/sketch_constraint.hpp"

#include <charconv>
#include <system_error>

namespace forefront {
namespace {

/// Reads an index from the start of a text and removes it.
std::optional<std::uint32_t> takeIndex(std::string_view &text) {
    std::uint32_t value = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (fault != std::errc()) {
        return std::nullopt;
    }
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return value;
}

} // namespace

std::optional<SketchPart> parseSketchPart(std::string_view text) {
    if (const auto kind = fromWord<SketchPartKind>(text); kind && *kind >= SketchPartKind::Origin) {
        return SketchPart{0, *kind, 0};
    }
    constexpr std::string_view kShape = "shape/";
    if (!text.starts_with(kShape)) {
        return std::nullopt;
    }
    text.remove_prefix(kShape.size());
    const std::optional<std::uint32_t> id = takeIndex(text);
    const std::size_t end = text.rfind('/');
    if (!id || !text.starts_with('/') || end == 0) {
        return std::nullopt;
    }
    const auto kind = fromWord<SketchPartKind>(text.substr(1, end - 1));
    text.remove_prefix(end + 1);
    const std::optional<std::uint32_t> index = takeIndex(text);
    if (!kind || *kind >= SketchPartKind::Origin || !index || !text.empty()) {
        return std::nullopt;
    }
    return SketchPart{*id, *kind, *index};
}

std::string toString(const SketchPart &part) {
    const std::string word(wordOf(part.kind));
    return part.kind >= SketchPartKind::Origin
               ? word
               : "shape/" + std::to_string(part.shape) + '/' + word + '/' + std::to_string(part.index);
}

} // namespace forefront
