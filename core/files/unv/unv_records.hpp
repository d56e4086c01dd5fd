#pragma once

#include "core/files/common/names.hpp"
#include "core/files/common/part_groups.hpp"
#include "core/files/text/columns.hpp"
#include "core/files/text/text_writer.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string_view>
#include <vector>

namespace forefront {

/// The line before and after a dataset.
inline constexpr std::string_view kUnvDelimiter = "    -1\n";

/// Names have 40 characters, and readers stop at blanks; numbers have columns of 10, with a blank between them.
inline constexpr GroupLimits kUnvGroups = {999'999'999, 40, asIdentifier};

/// Writes integers in columns of 10, eight on a line.
class UnvRecord {
  public:
    explicit UnvRecord(TextWriter &out) : out_(out) {}
    template <class Integer>
    void add(Integer value) {
        writeColumn(out_, value, 10);
        if (++count_ % 8 == 0) {
            out_ << '\n';
        }
    }
    void end() {
        if (count_ % 8 != 0) {
            out_ << '\n';
        }
        count_ = 0;
    }

  private:
    TextWriter &out_;
    std::size_t count_ = 0;
};

inline void writeUnvRow(TextWriter &out, std::initializer_list<std::uint64_t> values) {
    UnvRecord record(out);
    for (const std::uint64_t value : values) {
        record.add(value);
    }
    record.end();
}

/// Writes a number with 17 digits, which read back to the same bits, and Fortran's exponent of double precision.
inline void writeUnvReal(TextWriter &out, double value) {
    std::array<char, 32> text;
    char *const end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, 16).ptr;
    std::replace(text.data(), end, 'e', 'D');
    const auto length = static_cast<std::size_t>(end - text.data());
    out << std::string_view("         ").substr(0, 25 - std::min<std::size_t>(length, 25))
        << std::string_view(text.data(), length);
}

/// Writes a permanent group. `type`: of its entities, 7 nodes or 8 elements.
template <class Label>
void writeUnvGroup(const PartGroup &group, int type, const std::vector<std::uint32_t> &entities, Label label,
                   TextWriter &out) {
    writeUnvRow(out, {static_cast<std::uint64_t>(group.number), 0, 0, 0, 0, 0, 0, entities.size()});
    out << group.label << '\n';
    UnvRecord record(out);
    for (const std::uint32_t entity : entities) {
        record.add(type);
        record.add(label(entity));
        record.add(0);
        record.add(0);
    }
    record.end();
}

} // namespace forefront
