#pragma once

#include <cstdint>
#include <string>

namespace forefront {

struct Shell;
struct WidgetContext;

/// Draws the heading of the inspector, which describes the selection.
void inspectorHeading(WidgetContext &context, const std::string &text);

/// Draws the fields of a size source.
void inspectSource(Shell &context, std::uint32_t index);

/// Draws the fields of a region, by its marker.
void inspectRegion(Shell &context, std::uint32_t index);

} // namespace forefront
