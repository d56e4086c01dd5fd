#pragma once

#include <cstdint>

namespace forefront {

struct AppContext;

namespace ui {
class Flow;
}

/// Draws the option "Tag [ 1 ]  name".
void drawTagOption(AppContext &context, ui::Flow &flow, std::int32_t &tag, const char *tooltip);
/// Draws the option "LABEL [ 0.5 ]" for a positive number; true if it changed.
bool drawSizeOption(AppContext &context, ui::Flow &flow, const char *name, const char *label, double &value,
                    const char *tooltip);

} // namespace forefront
