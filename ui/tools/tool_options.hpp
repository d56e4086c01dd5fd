#pragma once

#include <cstdint>

namespace forefront {

struct AppContext;

/// "Tag [ 1 ]  name" in the strip of a tool, followed by another item in the same line.
void drawTagOption(AppContext &context, std::int32_t &tag, const char *tooltip);
/// "LABEL [ 0.5 ]" for a positive number; true when it changed.
bool drawSizeOption(AppContext &context, const char *name, const char *label, double &value, const char *tooltip);

} // namespace forefront
