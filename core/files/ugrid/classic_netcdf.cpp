#include "core/files/ugrid/classic_netcdf.hpp"

#include <algorithm>

namespace forefront {

namespace {

enum Tag : std::uint32_t { Dimensions = 10, Variables = 11, Attributes = 12 };
enum Type : std::uint32_t { Char = 2, Int = 4, Double = 6 };

std::size_t padded(std::size_t bytes) {
    return (bytes + 3) / 4 * 4;
}

std::size_t nameBytes(std::string_view name) {
    return 4 + padded(name.size());
}

std::size_t attributesBytes(const std::vector<NetcdfAttribute> &attributes) {
    std::size_t bytes = 8;
    for (const NetcdfAttribute &attribute : attributes) {
        bytes += nameBytes(attribute.name) + 8;
        if (const auto *const text = std::get_if<std::string>(&attribute.value)) {
            bytes += padded(text->size());
        } else if (const auto *const reals = std::get_if<std::vector<double>>(&attribute.value)) {
            bytes += 8 * reals->size();
        } else {
            bytes += 4 * std::get<std::vector<std::int32_t>>(attribute.value).size();
        }
    }
    return bytes;
}

class HeaderWriter {
  public:
    explicit HeaderWriter(TextWriter &out) : out_(out), numbers_(out) {}

    void number(std::size_t value) { numbers_.integer(static_cast<std::uint32_t>(value)); }
    void wide(std::uint64_t value) { numbers_.wide(value); }
    void text(std::string_view text) { out_ << text << std::string_view("\0\0\0", padded(text.size()) - text.size()); }
    void name(std::string_view name) {
        number(name.size());
        text(name);
    }
    void list(Tag tag, std::size_t count) { // an empty list has no tag
        number(count == 0 ? 0U : static_cast<std::uint32_t>(tag));
        number(count);
    }
    void attributes(const std::vector<NetcdfAttribute> &attributes) {
        list(Attributes, attributes.size());
        for (const NetcdfAttribute &attribute : attributes) {
            name(attribute.name);
            if (const auto *const value = std::get_if<std::string>(&attribute.value)) {
                number(Char);
                name(*value); // laid out as a name is
                continue;
            }
            if (const auto *const reals = std::get_if<std::vector<double>>(&attribute.value)) {
                number(Double);
                number(reals->size());
                for (const double value : *reals) {
                    numbers_.real(value);
                }
                continue;
            }
            const auto &values = std::get<std::vector<std::int32_t>>(attribute.value);
            number(Int);
            number(values.size());
            for (const std::int32_t value : values) {
                numbers_.integer(static_cast<std::uint32_t>(value));
            }
        }
    }

  private:
    TextWriter &out_;
    BigEndian numbers_;
};

} // namespace

void ClassicNetcdf::write(TextWriter &out) const {
    const auto bytesOf = [this](const NetcdfVariable &variable) {
        std::uint64_t bytes = variable.real ? 8 : 4;
        for (const std::uint32_t dimension : variable.dimensions) {
            bytes *= dimensions[dimension].length;
        }
        return bytes;
    };
    std::uint64_t begin = 8 + 8 + attributesBytes(attributes) + 8;
    for (const Dimension &dimension : dimensions) {
        begin += nameBytes(dimension.name) + 4;
    }
    for (const NetcdfVariable &variable : variables) {
        begin += nameBytes(variable.name) + 4 + 4 * variable.dimensions.size() + attributesBytes(variable.attributes) +
                 4 + 4 + 8;
    }
    HeaderWriter header(out);
    out << std::string_view("CDF\2", 4);
    header.number(0); // records
    header.list(Dimensions, dimensions.size());
    for (const Dimension &dimension : dimensions) {
        header.name(dimension.name);
        header.number(dimension.length);
    }
    header.attributes(attributes);
    header.list(Variables, variables.size());
    for (const NetcdfVariable &variable : variables) {
        header.name(variable.name);
        header.number(variable.dimensions.size());
        for (const std::uint32_t dimension : variable.dimensions) {
            header.number(dimension);
        }
        header.attributes(variable.attributes);
        header.number(variable.real ? Double : Int);
        header.number(std::min<std::uint64_t>(bytesOf(variable), 0xffffffffU)); // readers compute larger sizes
        header.wide(begin);
        begin += bytesOf(variable);
    }
    BigEndian values(out);
    for (const NetcdfVariable &variable : variables) {
        variable.write(values);
    }
}

} // namespace forefront
