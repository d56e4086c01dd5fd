#pragma once

#include "core/files/text/text_writer.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace forefront {

/// Writes numbers with the highest byte first.
class BigEndian {
  public:
    explicit BigEndian(TextWriter &out) : out_(out) {}

    void integer(std::uint32_t value) { bytes(value, 4); }
    void real(double value) { bytes(std::bit_cast<std::uint64_t>(value), 8); }
    void wide(std::uint64_t value) { bytes(value, 8); }

  private:
    void bytes(std::uint64_t value, int count) {
        for (int k = count - 1; k >= 0; --k) {
            out_ << static_cast<char>(value >> (8 * k) & 0xffU);
        }
    }

    TextWriter &out_;
};

/// An attribute: a text, integers or numbers.
struct NetcdfAttribute {
    std::string name;
    std::variant<std::string, std::vector<std::int32_t>, std::vector<double>> value;
};

/// A variable of integers or doubles.
struct NetcdfVariable {
    std::string name;
    std::vector<std::uint32_t> dimensions; ///< indices; none: one value
    std::vector<NetcdfAttribute> attributes;
    bool real = false;
    std::function<void(BigEndian &)> write; ///< writes all values, as integer() or real()
};

/// A netCDF file in the classic format with 64-bit offsets (CDF-2), which every library of netCDF reads; after the
/// NetCDF Classic Format Specification of Unidata.
struct ClassicNetcdf {
    struct Dimension {
        std::string name;
        std::uint32_t length; ///< > 0
    };
    std::vector<Dimension> dimensions;
    std::vector<NetcdfAttribute> attributes;
    std::vector<NetcdfVariable> variables;

    void write(TextWriter &out) const;
};

} // namespace forefront
