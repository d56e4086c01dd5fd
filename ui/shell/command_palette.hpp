#pragma once

#include "ui/parts/dialog.hpp"

#include <memory>

namespace forefront {

/// Finds an action by a part of its name and runs it.
std::unique_ptr<Dialog> makePalette();

} // namespace forefront
