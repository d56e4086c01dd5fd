#pragma once

#include "ui/platform/platform.hpp"
#include "ui/style/fonts.hpp"
#include "ui/style/icons.hpp"
#include "ui/style/theme.hpp"
#include "ui/widgets/widget_registry.hpp"

#include <algorithm>

namespace forefront {

/// Everything a widget needs: the platform, the look, the registry of names, and a way to ask for more frames.
struct WidgetContext {
    Platform &platform;
    WidgetRegistry widgets;
    Theme theme;
    Fonts fonts;
    float scale = 1.0F;         ///< pixels per design pixel
    int redraw = 3;             ///< number of frames to draw even without events
    double nextFrameAt = 1e300; ///< time of the next frame without input; reset at the start of each frame

    explicit WidgetContext(Platform &owner) : platform(owner) {}

    /// Converts design pixels to pixels.
    float px(double design) const { return static_cast<float>(design) * scale; }
    /// Requests two more frames, for changes on the screen that no input event causes.
    void animate() { redraw = std::max(redraw, 2); }
    /// Requests a frame at `time`, in seconds of Platform::now(), even without input (for a message that fades).
    void wakeAt(double time) { nextFrameAt = std::min(nextFrameAt, time); }
};

} // namespace forefront
