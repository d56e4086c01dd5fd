#pragma once

#include "ui/parts/shell.hpp"

#include <string>

namespace forefront::shell {

/// Registers the actions of tools, view, run and help.
void addShellActions(ActionRegistry &actions);
/// Registers the actions of lessons.
void addLessonActions(ActionRegistry &actions);

/// The rectangles of the main window in this frame, in pixels.
struct Layout {
    PixelRect menu, tabs, options, tools, lessons, canvas, sides, figures, below, column, timeline, status;
    PixelRect open;           ///< the part of the canvas that neither the column nor a dialog in its place covers
    PixelRect rulerX, rulerY; ///< above the canvas and left of it; empty if hidden
};
Layout layOut(const Shell &context);
/// Returns true if the window is too narrow for the column beside the canvas: it opens over the canvas on demand.
bool columnFloats(const Shell &context);
/// Returns true if a lesson is shown in a window so narrow that the column is hidden meanwhile: both would leave no
/// canvas.
bool lessonAlone(const Shell &context);
/// Returns true if the column is shown, beside the canvas or over it.
bool columnShown(const Shell &context);

/// The arrangement of the tool buttons; design pixels.
struct Strip {
    int columns = 1, rows = 1;
    double button = 32.0;
    bool lines = true; ///< hairlines between groups, in one column

    double width() const;
};
/// Returns one column if it fits into `height` pixels, otherwise smaller buttons or more columns.
Strip stripOf(const Shell &context, double height);

/// The widths of the bands along the edges of the canvas that plates and legends cover, in design pixels. On a wide
/// canvas, top and bottom are constant, so that the view does not jump when a tool is chosen, a layer is shown or the
/// first shape is drawn.
struct CanvasBands {
    double top = 0.0;     ///< options of the tool, progress
    double legends = 0.0; ///< width of the lowest row of legends, from the right
    double bottom = 0.0;  ///< legends, hints
};
CanvasBands bandsOf(const Shell &context, const PixelRect &canvas);
/// Returns the part of the canvas between the bands, or on a low canvas beside the plates, in pixels.
PixelRect freeRoom(const Shell &context, const PixelRect &canvas);

void drawMenuBar(Shell &context, const PixelRect &rect);
/// Draws the tabs of the documents; nothing while there is only one.
void drawTabs(Shell &context, const PixelRect &rect);
/// Draws the menu of the selection at the pointer, if a tool asked for it.
void drawContextMenu(Shell &context);
/// Draws the field on the canvas in which something is named.
void drawNameField(Shell &context, const PixelRect &canvas);
/// Draws the field on the canvas in which the value of a dimension is edited.
void drawDimensionField(Shell &context, const PixelRect &canvas);
/// Draws a button below what is wrong with a field, if a dimension holds the size that was typed there. It gives the
/// dimension that size, or the parameter that the dimension follows.
void drawFieldOffer(Shell &context);
/// Draws an entry of a menu that runs an action. Its widget is PREFIX and the id of the action.
void actionItem(Shell &context, const Action &action, std::string_view prefix = "menu/");
/// Draws an entry of a menu that opens the submenu of an action.
void submenu(Shell &context, const Action &action, std::string_view prefix = "menu/");
/// Opens the menu of the legend at a pixel. Returns false if there is none.
bool openLegendMenu(Shell &context, Pixel pixel);
/// Lets the user drag the limit in the legend of the quality.
void drawLegendLimit(Shell &context);
void drawToolStrip(Shell &context, const PixelRect &rect);
/// Draws the bar with the options of the active tool, and the drawer below its right end for what does not fit.
void drawOptionsBar(Shell &context, const PixelRect &rect);
/// Draws the button that shows the layers over the upper right corner of the canvas, and what is open of their
/// switches, the log at the lower edge and the history below the menu bar.
void drawPlates(Shell &context, const Layout &layout);
void drawColumn(Shell &context, const PixelRect &rect);
/// Draws the panel below the canvas, if the workspace has one.
void drawBelow(Shell &context, const PixelRect &rect);
/// Draws the lessons, or the page of the open one, and outlines the widgets that it points to.
void drawLessons(Shell &context, const PixelRect &rect);
/// Outlines the widgets that the page of the open lesson points to, where they were drawn in the last frame.
void drawHighlights(Shell &context);
/// Draws the runs beside the one on the canvas, and a table of their work below.
void drawSides(Shell &context, const PixelRect &views, const PixelRect &table);
/// Returns one line on the state of the run: how to begin, what the current advance does, why a run failed.
std::string stateText(const Shell &context);
void drawTimeline(Shell &context, const PixelRect &rect);
/// Draws the rulers along the canvas, with marks at the coordinates of the pointer, if they are shown.
void drawRulers(Shell &context, const Layout &layout);
void drawStatusBar(Shell &context, const PixelRect &rect);
/// Returns true while a mesh is made at full speed.
bool isMeshing(const Workspace &context);
/// Draws the hint strip, the out-of-date badge, the progress and the newest message over the canvas.
void drawCanvasNotes(Shell &context, const PixelRect &canvas);

/// Draws soft shadows round the menus, dialogs and tooltips of this frame, which lift them off what they cover.
void drawShadows(const WidgetContext &context);

/// Begins a borderless window that fills `rect`; pair with ImGui::End().
void beginRegion(const char *name, const PixelRect &rect, Colour background, float padX, float padY);

} // namespace forefront::shell
