#pragma once

#include "ui/parts/tool.hpp"

#include <memory>
#include <vector>

namespace forefront {

/// Makes all tools in the order of the tool strip. The first one is active at start.
std::vector<std::unique_ptr<Tool>> makeTools();

} // namespace forefront
