#pragma once

#include "core/files/components/gdal_component.hpp"
#include "core/files/source/source.hpp"

#include <initializer_list>
#include <string>

namespace forefront {

/// A file as GDAL gets it: by its path or, where that is unknown, from memory.
struct GdalSource {
    /// `drivers`: GDAL's names of the formats that the file may have.
    GdalSource(const SourceText &source, std::initializer_list<const char *> drivers);
    GdalSource(const GdalSource &) = delete;
    GdalSource &operator=(const GdalSource &) = delete;

    std::string bytes; ///< of a file in memory
    GdalFile file;
};

/// Returns the failure of GDAL as a fault.
Diagnostics gdalFailure(const GdalReport &report);
/// Passes the warnings of GDAL on.
void noteWarnings(const GdalReport &report, const SourceText &source);

} // namespace forefront
