#pragma once

#include <string>

namespace forefront {

struct Judgement;
struct Workspace;

/// Draws the list of the measures, and of the fields of an opened mesh, and chooses the one to show. Width in design
/// pixels.
void drawMeasureChoice(Workspace &context, const std::string &name, float width);

/// Draws the ends of the colour map, "PREFIX/from" and "PREFIX/to", and the button "PREFIX/fit". Draws nothing for
/// regions, whose colours have no order.
void drawMeasureRange(Workspace &context, const Judgement &judgement, const std::string &prefix);

} // namespace forefront
