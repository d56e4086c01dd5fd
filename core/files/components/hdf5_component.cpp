#include "core/files/components/hdf5_component.hpp"

#include "core/files/components/component.hpp"

namespace forefront {

Result<const Hdf5Functions *> hdf5Component() {
    static const Result<const void *> kLoaded = loadComponent("hdf5", "libhdf5-dev");
    if (!kLoaded) {
        return kLoaded.faults();
    }
    return static_cast<const Hdf5Functions *>(*kLoaded);
}

} // namespace forefront
