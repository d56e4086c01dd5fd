#include "core/base/version.hpp"

namespace forefront {

const char *version() {
    return FOREFRONT_VERSION;
}

} // namespace forefront
