#pragma once

#include <string>

namespace forefront {

/// Returns the code point of an icon.
constexpr int codeOf(const char *icon) {
    return ((icon[0] & 0x0f) << 12) | ((icon[1] & 0x3f) << 6) | (icon[2] & 0x3f);
}
/// Added to the code point of an icon, gives that of its squares alone, if it has any.
inline constexpr int kNodesOfIcon = 0x40;
/// Returns the squares of an icon, to be drawn over it in another colour.
inline std::string nodesOf(const char *icon) {
    return {icon[0], static_cast<char>(icon[1] + 1), icon[2]};
}

namespace icon {

// Icons as characters of the program's fonts, from the private area U+E000 of Unicode, in UTF-8. They are drawn from
// the paths in ui/style/icon_shapes.cpp. One icon has one meaning.
inline constexpr const char *kSelect = "\xee\x80\x80";      // Select
inline constexpr const char *kPolygon = "\xee\x80\x81";     // Polygon
inline constexpr const char *kRectangle = "\xee\x80\x82";   // Rectangle
inline constexpr const char *kCircle = "\xee\x80\x83";      // Circle
inline constexpr const char *kEllipse = "\xee\x80\x84";     // Ellipse
inline constexpr const char *kRegular = "\xee\x80\x85";     // Regular polygon
inline constexpr const char *kSlot = "\xee\x80\x86";        // Slot
inline constexpr const char *kPolyline = "\xee\x80\x87";    // Polyline
inline constexpr const char *kArc = "\xee\x80\x88";         // Arc
inline constexpr const char *kPoint = "\xee\x80\x89";       // Inner point
inline constexpr const char *kTrim = "\xee\x80\x8a";        // Trim and extend
inline constexpr const char *kRegion = "\xee\x80\x8b";      // Region
inline constexpr const char *kBrush = "\xee\x80\x8c";       // Size brush
inline constexpr const char *kEraser = "\xee\x80\x8d";      // Eraser
inline constexpr const char *kSource = "\xee\x80\x8e";      // Size source
inline constexpr const char *kGradient = "\xee\x80\x8f";    // Gradient
inline constexpr const char *kMeasure = "\xee\x80\x90";     // Measure
inline constexpr const char *kPicture = "\xee\x80\x91";     // Background picture
inline constexpr const char *kTrace = "\xee\x80\x92";       // What made this?
inline constexpr const char *kProbe = "\xee\x80\x93";       // Probe
inline constexpr const char *kGuess = "\xee\x80\x94";       // Guess the next node
inline constexpr const char *kLayers = "\xee\x80\x95";      // Layers
inline constexpr const char *kSnapDrawing = "\xee\x80\x96"; // Snap to drawing
inline constexpr const char *kSnapGrid = "\xee\x80\x97";    // Snap to grid
inline constexpr const char *kFit = "\xee\x80\x98";         // Zoom to all
inline constexpr const char *kEye = "\xee\x80\x99";         // Visible
inline constexpr const char *kEyeClosed = "\xee\x80\x9a";   // Hidden
inline constexpr const char *kSearch = "\xee\x80\x9b";      // Search commands
inline constexpr const char *kPlay = "\xee\x80\x9c";        // Play
inline constexpr const char *kForward = "\xee\x80\x9d";     // Step forward
inline constexpr const char *kBack = "\xee\x80\x9e";        // Step back
inline constexpr const char *kToStart = "\xee\x80\x9f";     // To the start
inline constexpr const char *kToEnd = "\xee\x80\xa0";       // To the end
inline constexpr const char *kFlag = "\xee\x80\xa1";        // Breakpoint
inline constexpr const char *kDown = "\xee\x80\xa2";        // Open
inline constexpr const char *kRight = "\xee\x80\xa3";       // Closed
inline constexpr const char *kPlus = "\xee\x80\xa4";        // Add
inline constexpr const char *kLock = "\xee\x80\xa5";        // Lock
inline constexpr const char *kCheck = "\xee\x80\xa6";       // Passed
inline constexpr const char *kCross = "\xee\x80\xa7";       // Failed
inline constexpr const char *kWarning = "\xee\x80\xa8";     // Warning
inline constexpr const char *kRunPlot = "\xee\x80\xa9";     // Curves of the run
inline constexpr const char *kTheme = "\xee\x80\xaa";       // Dark or light theme
inline constexpr const char *kComputer = "\xee\x80\xab";    // This computer
inline constexpr const char *kPause = "\xee\x80\xac";       // Pause
inline constexpr const char *kClock = "\xee\x80\xad";       // Out of date
inline constexpr const char *kError = "\xee\x80\xae";       // Error
inline constexpr const char *kInfo = "\xee\x80\xaf";        // Note
inline constexpr const char *kUnknown = "\xee\x80\xb0";     // Not known
inline constexpr const char *kKeyboard = "\xee\x80\xb1";    // Keyboard shortcuts
inline constexpr const char *kPanels = "\xee\x80\xb2";      // Panels beside the canvas
inline constexpr const char *kTrash = "\xee\x80\xb3";       // Remove
inline constexpr const char *kUnlock = "\xee\x80\xb4";      // Unlocked
inline constexpr const char *kHome = "\xee\x80\xb5";        // Home folder
inline constexpr const char *kFolder = "\xee\x80\xb6";      // Folder
inline constexpr const char *kFile = "\xee\x80\xb7";        // File
inline constexpr const char *kUp = "\xee\x80\xb8";          // Up
inline constexpr const char *kPin = "\xee\x80\xb9";         // In all workspaces

// Glyphs of sketch constraints.
inline constexpr const char *kMarkCoincident = "\xee\x82\x80";    // Coincident points
inline constexpr const char *kMarkOnCurve = "\xee\x82\x81";       // Point on a curve
inline constexpr const char *kMarkMidpoint = "\xee\x82\x82";      // Point in the middle
inline constexpr const char *kMarkHorizontal = "\xee\x82\x83";    // Horizontal
inline constexpr const char *kMarkVertical = "\xee\x82\x84";      // Vertical
inline constexpr const char *kMarkParallel = "\xee\x82\x85";      // Parallel
inline constexpr const char *kMarkPerpendicular = "\xee\x82\x86"; // Perpendicular
inline constexpr const char *kMarkCollinear = "\xee\x82\x87";     // Collinear
inline constexpr const char *kMarkTangent = "\xee\x82\x88";       // Tangent
inline constexpr const char *kMarkEqual = "\xee\x82\x89";         // Equal
inline constexpr const char *kMarkConcentric = "\xee\x82\x8a";    // Concentric
inline constexpr const char *kMarkSymmetric = "\xee\x82\x8b";     // Symmetric
inline constexpr const char *kMarkFixed = "\xee\x82\x8c";         // Fixed

} // namespace icon

} // namespace forefront
