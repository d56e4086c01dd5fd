#include "core/files/components/gdal_component.hpp"

#include "core/components/gdal/gdal_readers.hpp"

#include <cstring>

namespace {

constexpr forefront::GdalFunctions kFunctions = {forefront::gdal::readMap, forefront::gdal::readRaster};

} // namespace

extern "C" __attribute__((visibility("default"))) const void *forefront_gdal(const char *version) {
    return std::strcmp(version, FOREFRONT_VERSION) == 0 ? &kFunctions : nullptr;
}
