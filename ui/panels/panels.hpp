#pragma once

#include "ui/panels/panel.hpp"

#include <memory>

namespace forefront {

std::unique_ptr<Panel> makeLayersPanel();
std::unique_ptr<Panel> makeLogPanel();

} // namespace forefront
