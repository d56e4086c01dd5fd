#pragma once

#include "core/files/source/source.hpp"
#include "core/files/text/text_scanner.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace forefront {

/// A group of a DXF file: a line with its code, which says what the value means, and a line with the value.
struct DxfGroup {
    int code = 0;
    std::string_view value; ///< without surrounding blanks
    std::size_t offset = 0; ///< of the value in the text
};

/// Reads the groups of a part of a DXF text in order. The first fault is kept with its line; after it, reading fails.
class DxfGroups {
  public:
    explicit DxfGroups(const SourceText &source) : DxfGroups(source, 0, source.text.size()) {}
    DxfGroups(const SourceText &source, std::size_t begin, std::size_t end)
        : text_(source.text), faults_(source), at_(begin), end_(end) {}

    /// Returns false at the end, and after a fault. Faults: bad-syntax, cancelled.
    bool next(DxfGroup &group);
    /// Returns the byte after the last group.
    std::size_t offset() const { return at_; }
    bool ok() const { return faults_.ok(); }
    const Diagnostics &faults() const { return faults_.faults(); }
    bool fail(std::size_t offset, std::string code, std::string message, std::string advice = {}) {
        return faults_.fail(offset, std::move(code), std::move(message), std::move(advice));
    }

  private:
    std::string_view line(std::size_t &offset);

    std::string_view text_;
    TextScanner faults_;
    std::size_t at_;
    std::size_t end_;
};

} // namespace forefront
