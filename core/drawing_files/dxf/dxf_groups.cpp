#include "core/drawing_files/dxf/dxf_groups.hpp"

#include <algorithm>
#include <charconv>

namespace forefront {

/// Returns the next line without surrounding blanks, and the byte at which it begins.
std::string_view DxfGroups::line(std::size_t &offset) {
    constexpr std::string_view kBlanks(" \t\r\0", 4);
    const std::size_t end = std::min(text_.find('\n', at_), end_);
    std::string_view content = text_.substr(at_, end - at_);
    const std::size_t first = std::min(content.find_first_not_of(kBlanks), content.size());
    offset = at_ + first;
    content.remove_prefix(first);
    content.remove_suffix(content.size() - (content.find_last_not_of(kBlanks) + 1));
    at_ = std::min(end + 1, end_);
    return content;
}

bool DxfGroups::next(DxfGroup &group) {
    if (!ok() || !faults_.proceed(at_)) {
        return false;
    }
    std::size_t place = 0;
    std::string_view code;
    while (code.empty()) { // some programs leave blank lines at the end
        if (at_ >= end_) {
            return false;
        }
        code = line(place);
    }
    const auto [last, error] = std::from_chars(code.data(), code.data() + code.size(), group.code);
    if (error != std::errc() || last != code.data() + code.size()) {
        return fail(place, "bad-syntax", "expected a group code, found " + inQuotes(code),
                    "each value of a DXF file follows a line with the number of its group");
    }
    if (at_ >= end_) {
        return fail(place, "bad-syntax", "the file ends before the value of group " + std::to_string(group.code),
                    "the file may have been cut short");
    }
    group.value = line(group.offset);
    return true;
}

} // namespace forefront
