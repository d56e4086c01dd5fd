#pragma once

#include <vector>

namespace forefront::shell {

/// A section of the column, for the division of its height; pixels.
struct Section {
    bool open = true;      ///< shows its content
    bool keepsOpen = true; ///< the user or a command opened it
    bool first = false;    ///< gets the height of its content before others
    float content = 0.0F;  ///< height of its whole content; 0: not known yet
};

/// Measures of the sections in pixels.
struct SectionMeasures {
    float heading = 0.0F, gap = 0.0F; ///< of each section; the gap follows an open one
    float lowest = 0.0F;              ///< an open section shows at least this much of its content
    bool wholeFirst = false;          ///< others fold where those that come first could not be whole
};

/// Folds the lower sections for which a column of this height has no room, except those that stay open, the last one
/// that is left and, with `wholeFirst`, those that come first, and divides the height among the open ones: those that
/// come first and low ones get what they need, the others share the rest. Returns the heights of their contents, 0 for
/// folded ones. If the lowest heights do not fit, the sum exceeds the height.
std::vector<float> sectionHeights(std::vector<Section> &sections, const SectionMeasures &measures, float height);

} // namespace forefront::shell
