#pragma once

#include "core/files/text/text_scanner.hpp"

#include <pugixml.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace forefront {

/// The numbers of a data item of an XDMF file.
struct XdmfNumbers {
    std::vector<std::uint64_t> dimensions;
    std::vector<double> values; ///< as many as the product of the dimensions

    /// Returns the number of rows: the first dimension.
    std::size_t rows() const { return dimensions.empty() ? 0 : static_cast<std::size_t>(dimensions.front()); }
    /// Returns the number of values in each row.
    std::size_t columns() const { return rows() == 0 ? 0 : values.size() / rows(); }
};

inline std::size_t offsetOfXml(const pugi::xml_node &node) {
    return node.offset_debug() > 0 ? static_cast<std::size_t>(node.offset_debug()) : 0;
}

/// Reads the data item of an element, from the text itself or from an HDF5 file beside it. Returns false after
/// recording a failure in the scanner: bad-syntax, bad-count, bad-number, cannot-read, missing-component.
bool readXdmfItem(TextScanner &scanner, const pugi::xml_node &parent, XdmfNumbers &numbers);

} // namespace forefront
