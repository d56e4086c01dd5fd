#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/mesher/options.hpp"

#include <string>

namespace forefront {

/// Returns the fault "not-stepped" of something that shows only fronts of triangles, for a job that makes
/// quadrilaterals; else none. `what`: its name, such as "a film".
inline Diagnostics refusalOfQuads(const MeshingOptions &options, const std::string &what) {
    if (!makesQuads(options)) {
        return {};
    }
    return error("not-stepped", what + " shows a front of triangles, not one of quadrilaterals",
                 "choose triangles, or step through the front in the editor");
}

} // namespace forefront
