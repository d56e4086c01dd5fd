#pragma once

#include "core/files/text/text_writer.hpp"
#include "core/files/text/xml_text.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

static_assert(std::endian::native == std::endian::little, "VTU files are written in the byte order of the machine");

/// Writes the headers of the arrays in the appended data, then the arrays in the same order.
class AppendedArrays {
  public:
    explicit AppendedArrays(TextWriter &out) : out_(out) {}

    void announce(const char *type, const char *name, std::size_t components, std::size_t bytes) {
        out_ << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" NumberOfComponents=\"" << components
             << "\" format=\"appended\" offset=\"" << offset_ << "\"/>\n";
        offset_ += bytes + sizeof(std::uint64_t);
        sizes_.push_back(bytes);
    }
    /// Writes the length in front of the next array.
    void begin() { put(static_cast<std::uint64_t>(sizes_[next_++])); }
    template <class T>
    void put(T value) {
        out_.bytes(&value, sizeof value);
    }

  private:
    TextWriter &out_;
    std::size_t offset_ = 0, next_ = 0;
    std::vector<std::size_t> sizes_;
};

} // namespace forefront
