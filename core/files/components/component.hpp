#pragma once

#include "core/engine/base/result.hpp"

#include <string>

namespace forefront {

/// Loads an optional component: a shared library `forefront-NAME.so` that uses a large library which the program does
/// not need otherwise. Returns what its function `forefront_NAME` returns: the functions of the component. It stays
/// loaded. Looks only in the folder in the environment variable FOREFRONT_COMPONENTS, if it is set; else in the folders
/// `forefront` beside the file that holds this code and `lib/forefront` above it, then where the components were
/// installed.
///
/// Fault: missing-component, with the reason; `packages` names what to install on Debian, for the advice.
Result<const void *> loadComponent(const std::string &name, const std::string &packages);

/// The function that a component exports. `version`: that of the program, which must be the component's own; null is
/// returned for others, since both share types of C++.
using ComponentEntry = const void *(*)(const char *version);

} // namespace forefront
