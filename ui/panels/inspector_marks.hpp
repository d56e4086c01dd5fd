#pragma once

#include "core/engine/base/vec2.hpp"

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

/// Draws what is known of a face without a region, by a place in it.
void inspectFace(Shell &context, Vec2 place);

} // namespace forefront
