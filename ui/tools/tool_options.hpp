#pragma once

#include <cstdint>

namespace forefront {

struct AppContext;

namespace ui {
class Flow;
}

/// "Tag [ 1 ]  name", an item of the options of a tool.
void drawTagOption(AppContext &context, ui::Flow &flow, std::int32_t &tag, const char *tooltip);
/// "LABEL [ 0.5 ]" for a positive number; true when it changed.
bool drawSizeOption(AppContext &context, ui::Flow &flow, const char *name, const char *label, double &value,
                    const char *tooltip);

} // namespace forefront
