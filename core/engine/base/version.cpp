#include "core/engine/base/version.hpp"

namespace forefront {

const char *version() {
    return FOREFRONT_VERSION;
}

} // namespace forefront
