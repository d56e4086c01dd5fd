#pragma once

#include "ui/app/app_context.hpp"

namespace forefront::shell {

/// The fixed layout: rectangles in pixels of this frame.
struct Layout {
    PixelRect menu, tools, canvas, column, timeline, status;
};
Layout layOut(const AppContext &context);

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
