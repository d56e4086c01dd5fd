#include "core/drawing/document/number_address.hpp"

#include <charconv>
#include <system_error>
#include <vector>

namespace forefront {
namespace {

std::vector<std::string_view> pieces(std::string_view text) {
    std::vector<std::string_view> list;
    while (true) {
        const std::size_t end = text.find('/');
        list.push_back(text.substr(0, end));
        if (end == std::string_view::npos) {
            return list;
        }
        text.remove_prefix(end + 1);
    }
}

std::optional<std::uint32_t> parseIndex(std::string_view text) {
    std::uint32_t value = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    return fault == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

} // namespace

std::optional<NumberAddress> parseAddress(std::string_view text) {
    const std::vector<std::string_view> parts = pieces(text);
    const std::optional<NumberOwner::Kind> kind = fromWord<NumberOwner::Kind>(parts[0]);
    const std::size_t place = kind == NumberOwner::Kind::Spacing ? 1 : 2; // only the spacing has no id
    const std::optional<Quantity> quantity =
        kind && parts.size() > place ? fromWord<Quantity>(parts[place]) : std::nullopt;
    if (!quantity) {
        return std::nullopt;
    }
    NumberAddress address{{*kind, 0}, *quantity};
    const std::optional<std::uint32_t> id = place == 2 ? parseIndex(parts[1]) : 0;
    const std::optional<std::uint32_t> handle = address.hasHandle() && parts.size() > 3 ? parseIndex(parts[3]) : 0;
    if (!id || !handle || parts.size() != place + (address.hasHandle() ? 2U : 1U)) {
        return std::nullopt;
    }
    address.owner.id = *id;
    address.handle = *handle;
    return address;
}

std::string toString(const NumberAddress &address) {
    std::string text(wordOf(address.owner.kind));
    if (address.owner.kind != NumberOwner::Kind::Spacing) {
        text += '/' + std::to_string(address.owner.id);
    }
    text += '/';
    text += wordOf(address.quantity);
    return address.hasHandle() ? text + '/' + std::to_string(address.handle) : text;
}

} // namespace forefront
