#include "core/files/components/gdal_source.hpp"

namespace forefront {

GdalSource::GdalSource(const SourceText &source, std::initializer_list<const char *> drivers) {
    if (source.path.empty()) {
        bytes = source.text;
        file.bytes = &bytes;
    } else {
        file.path = source.path.string();
    }
    file.drivers = drivers;
    file.projection = source.options.projection;
}

Diagnostics gdalFailure(const GdalReport &report) {
    return error("gdal", report.message, report.advice);
}

void noteWarnings(const GdalReport &report, const SourceText &source) {
    for (const std::string &warning : report.warnings) {
        source.warn("gdal", "GDAL: " + warning, 0);
    }
}

} // namespace forefront
