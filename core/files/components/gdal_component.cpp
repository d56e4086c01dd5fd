#include "core/files/components/gdal_component.hpp"

#include "core/files/components/component.hpp"

namespace forefront {

Result<const GdalFunctions *> gdalComponent() {
    static const Result<const void *> kLoaded = loadComponent("gdal", "libgdal-dev");
    if (!kLoaded) {
        return kLoaded.faults();
    }
    return static_cast<const GdalFunctions *>(*kLoaded);
}

} // namespace forefront
