#pragma once

#include "ui/editor/app_context.hpp"

namespace forefront::shell {

/// The fixed layout: rectangles in pixels of this frame.
struct Layout {
    PixelRect menu, tools, canvas, column, timeline, status;
};
Layout layOut(const AppContext &context);

/// How the buttons of the tools stand in their strip; design pixels.
struct Strip {
    int columns = 1, rows = 1;
    double button = 34.0;

    double width() const;
};
/// One column where it fits into `height` pixels, smaller buttons or more columns where it does not.
Strip stripOf(const AppContext &context, double height);

/// What plates and legends take of the edges of the canvas, design pixels. The view must not jump when a tool is
/// chosen, a layer shown or the first shape drawn: as long as the canvas is wide enough, none of that changes top and
/// bottom.
struct CanvasBands {
    double top = 0.0;     ///< options of the tool, progress
    double legends = 0.0; ///< what the lowest row of legends takes of the width, from the right
    double bottom = 0.0;  ///< legends, hints
};
CanvasBands bandsOf(const AppContext &context, const PixelRect &canvas);
/// The part of the canvas between them, in pixels.
PixelRect freeRoom(const AppContext &context, const PixelRect &canvas);

void drawMenuBar(AppContext &context, const PixelRect &rect);
void drawToolStrip(AppContext &context, const PixelRect &rect);
void drawToolOptions(AppContext &context, const PixelRect &canvas);
void drawColumn(AppContext &context, const PixelRect &rect);
void drawTimeline(AppContext &context, const PixelRect &rect);
void drawStatusBar(AppContext &context, const PixelRect &rect);
/// Over the canvas: hint strip, out-of-date badge, progress, newest message.
void drawCanvasNotes(AppContext &context, const PixelRect &canvas);

/// Opens a borderless window that fills `rect`; pair with ImGui::End().
void beginRegion(const char *name, const PixelRect &rect, Colour background, float padX, float padY);

} // namespace forefront::shell
