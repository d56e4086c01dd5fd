#pragma once

#include "ui/parts/context_menu.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

struct Shell;

/// Where a panel is shown.
enum class PanelPlace : std::uint8_t {
    Column, ///< a section of the column at the right, in the workspaces that list it
    Canvas, ///< over the upper right corner of the canvas, opened by a button there
    Drawer, ///< along the lower edge of the canvas, opened from the status bar
    Menu,   ///< below the menu bar, opened from the Edit menu
    Below   ///< below the canvas, in the workspace Judge
};

/// A part of the window with its own heading. To add one, write its file, add a line to makePanels(), and list it in
/// the presets of the workspaces that show it.
class Panel {
  public:
    virtual ~Panel() = default;
    /// Returns the stable name of the panel; its heading is the widget "panel/ID".
    virtual const char *id() const = 0;
    virtual const char *title() const = 0;
    virtual PanelPlace place() const { return PanelPlace::Column; }
    /// Draws the content with Dear ImGui and ui/widgets/widgets.hpp; the width is ImGui::GetContentRegionAvail().x.
    virtual void draw(Shell &context) = 0;
    /// Returns the commands of the panel for a right click that no row of it has handled.
    virtual std::vector<ContextGroup> menu(Shell &) { return {}; }
};

} // namespace forefront
