#pragma once

#include <cstdint>
#include <memory>
#include <vector>

namespace forefront {

struct AppContext;

/// Where a panel stands in the right column.
enum class PanelPlace : std::uint8_t {
    Stacked, ///< under a heading of its own, one above the other
    Tabbed   ///< a tab of the group at the bottom
};

/// A part of the right column. One file a panel, one line in makePanels().
class Panel {
  public:
    virtual ~Panel() = default;
    /// Stable name; the heading (or tab) is the widget "panel/ID".
    virtual const char *id() const = 0;
    virtual const char *title() const = 0;
    virtual PanelPlace place() const { return PanelPlace::Stacked; }
    /// Height wanted in design pixels, for the stacked ones; 0: as high as its content.
    virtual double height() const { return 0.0; }
    /// Draws the content with Dear ImGui and ui/widgets.hpp; the width is ImGui::GetContentRegionAvail().x.
    virtual void draw(AppContext &context) = 0;
};

/// All panels from top to bottom, then the tabs from left to right.
std::vector<std::unique_ptr<Panel>> makePanels();

} // namespace forefront
