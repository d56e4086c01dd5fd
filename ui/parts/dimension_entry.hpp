#pragma once

#include "ui/input/pixels.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace forefront {

struct Document;

/// The field on the canvas in which the value of a dimension is edited.
struct DimensionEntry {
    std::optional<std::uint32_t> constraint; ///< id of the dimension while the field is open
    Pixel at{};                              ///< upper left corner of the field
    std::uint64_t revision = 0;              ///< of the document when it was opened
    int frames = 0;                          ///< that the field was drawn
    std::string text;                        ///< a number, or an expression of parameters
    std::string initial;                     ///< the text when it was opened
    bool restore = false;                    ///< the field is to get its initial text back
    std::string fault;                       ///< why the text was refused
    bool edited = false;                     ///< the text was changed
    /// Undo step that has just added the dimension, and that its value belongs to; empty: the dimension was there.
    std::string stroke;

    /// Opens the field of a dimension, which must exist, with its expression or value.
    void open(const Document &document, std::uint64_t documentRevision, std::uint32_t id, Pixel place);
    void close() { constraint.reset(); }
};

} // namespace forefront
