#pragma once

#include "ui/parts/context_menu.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

struct Shell;

/// Position of a panel in the right column.
enum class PanelPlace : std::uint8_t {
    Stacked, ///< one above the other, each with its own heading
    Tabbed   ///< a tab of the group at the bottom
};

/// A part of the right column. To add one, write its file and add a line to makePanels().
class Panel {
  public:
    virtual ~Panel() = default;
    /// Returns the stable name of the panel; its heading (or tab) is the widget "panel/ID".
    virtual const char *id() const = 0;
    virtual const char *title() const = 0;
    virtual PanelPlace place() const { return PanelPlace::Stacked; }
    /// Returns the height of a stacked panel in design pixels; 0: as high as its content.
    virtual double height() const { return 0.0; }
    /// Returns true if a stacked panel is folded in a low window until the user unfolds it.
    virtual bool foldsInLowWindow() const { return false; }
    /// Draws the content with Dear ImGui and ui/widgets/widgets.hpp; the width is ImGui::GetContentRegionAvail().x.
    virtual void draw(Shell &context) = 0;
    /// Returns the commands of the panel for a right click that no row of it has handled.
    virtual std::vector<ContextGroup> menu(Shell &) { return {}; }
};

} // namespace forefront
