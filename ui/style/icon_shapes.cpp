#include "ui/style/icon_shapes.hpp"

#include "ui/style/icons.hpp"

#include <array>

namespace forefront {

namespace {

constexpr std::array kShapes = {
    IconShape{.text = icon::kSelect, .meaning = "Select", .stroke = "M5 3V15.5L8.3 12.4L10.6 17L12.7 16L10.5 11.6H15Z"},
    IconShape{.text = icon::kPolygon, .meaning = "Polygon", .stroke = "M4.5 8L11 4L16 9.5L13 16H6Z", .nodes = "4.5 8  11 4  16 9.5  13 16  6 16"},
    IconShape{.text = icon::kRectangle, .meaning = "Rectangle", .stroke = "M4 5.5H16V14.5H4Z", .nodes = "4 5.5  16 14.5"},
    IconShape{.text = icon::kCircle, .meaning = "Circle", .stroke = "M16.5 10A6.5 6.5 0 1 1 3.5 10A6.5 6.5 0 1 1 16.5 10Z", .helper = "M10 10H16.5", .nodes = "10 10  16.5 10"},
    IconShape{.text = icon::kEllipse, .meaning = "Ellipse", .stroke = "M17.5 10A7.5 4.5 0 1 1 2.5 10A7.5 4.5 0 1 1 17.5 10Z", .helper = "M10 10H17.5M10 10V5.5", .nodes = "17.5 10  10 5.5"},
    IconShape{.text = icon::kRegular, .meaning = "Regular polygon", .stroke = "M10 3L16.1 6.5V13.5L10 17L3.9 13.5V6.5Z", .nodes = "10 10  10 3"},
    IconShape{.text = icon::kSlot, .meaning = "Slot", .stroke = "M6.5 6H13.5A4 4 0 0 1 13.5 14H6.5A4 4 0 0 1 6.5 6Z", .helper = "M6.5 10H13.5", .nodes = "6.5 10  13.5 10"},
    IconShape{.text = icon::kPolyline, .meaning = "Polyline", .stroke = "M3.5 14.5L7.5 6.5L12 12.5L16.5 5.5", .nodes = "3.5 14.5  7.5 6.5  12 12.5  16.5 5.5"},
    IconShape{.text = icon::kArc, .meaning = "Arc", .stroke = "M3.5 14.5A6.6 6.6 0 0 1 16.5 14.5", .nodes = "3.5 14.5  10 9  16.5 14.5"},
    IconShape{.text = icon::kPoint, .meaning = "Constraint point", .stroke = "M10 3L17 15.5H3Z", .helper = "M10 3V11M17 15.5L10 11L3 15.5", .dots = "10 11 2.2"},
    IconShape{.text = icon::kTrim, .meaning = "Trim and extend", .stroke = "M7.5 3V17M2.5 10H7.5", .helper = "M12 5L15.5 8.5M15.5 5L12 8.5", .dashed = "M10 10H17.5"},
    IconShape{.text = icon::kRegion, .meaning = "Region", .stroke = "M4 5.5L10 3.5L16.5 6.5L15 15.5L6 16.5Z", .helper = "M6.3 14.5L14.2 6.6M5.2 10L10.4 4.8M10 15.2L15.8 9.4", .dots = "10.2 10.2 1.9"},
    IconShape{.text = icon::kBrush, .meaning = "Size brush", .stroke = "M17 3L10.8 9.2M11.3 13C10.4 15.8 6.6 17.2 3 16C4.6 15.2 4.4 13.9 5 12.3C5.7 10.4 8 9.2 9.8 9.6C11.3 10 11.8 11.5 11.3 13Z", .helper = "M13 16.5H17M14.5 13.5H17"},
    IconShape{.text = icon::kEraser, .meaning = "Eraser", .stroke = "M3 12.5L10.8 4.7A1.4 1.4 0 0 1 12.8 4.7L16 7.9A1.4 1.4 0 0 1 16 9.9L9.5 16.5H7ZM6.9 8.6L12.1 13.8", .helper = "M12 16.5H17.5"},
    IconShape{.text = icon::kSource, .meaning = "Size source", .stroke = "M14 10A4 4 0 1 1 6 10A4 4 0 1 1 14 10Z", .dashed = "M17.5 10A7.5 7.5 0 1 1 2.5 10A7.5 7.5 0 1 1 17.5 10Z", .dots = "10 10 1.6"},
    IconShape{.text = icon::kGradient, .meaning = "Gradient", .stroke = "M5.5 14.5L12.6 7.4", .fill = "M17.8 5.4A3.2 3.2 0 1 1 11.4 5.4A3.2 3.2 0 1 1 17.8 5.4Z", .dots = "4.4 15.6 1.7"},
    IconShape{.text = icon::kMeasure, .meaning = "Measure", .stroke = "M3 5V15M17 5V15M3.5 10H16.5M6 7.5L3.5 10L6 12.5M14 7.5L16.5 10L14 12.5"},
    IconShape{.text = icon::kPicture, .meaning = "Background picture", .stroke = "M4 4H16A1 1 0 0 1 17 5V15A1 1 0 0 1 16 16H4A1 1 0 0 1 3 15V5A1 1 0 0 1 4 4ZM3 13L7.5 8.8L11.5 12.6L13.3 11L17 14", .dots = "13 7.3 1.3"},
    IconShape{.text = icon::kTrace, .meaning = "What made this?", .stroke = "M8.5 16.5H17.5L13 8.8ZM9.5 5.5C6 4.5 3 6.8 3 10C3 11.6 3.7 13 4.8 14M9.5 5.5L7 3.2M9.5 5.5L7.2 8"},
    IconShape{.text = icon::kProbe, .meaning = "Probe", .stroke = "M3 16.5H12L7.5 9ZM8.6 11L12 7.5 M11 2.5H17.5V7.5H11Z", .helper = "M13 5H15.5", .dots = "7.6 13.6 1.3"},
    IconShape{.text = icon::kGuess, .meaning = "Guess the next node", .stroke = "M3 16H17M12.2 5A2.2 2.2 0 1 1 7.8 5A2.2 2.2 0 1 1 12.2 5Z", .dashed = "M4 15L8.6 7.6M16 15L11.4 7.6", .nodes = "3 16  17 16"},
    IconShape{.text = icon::kLayers, .meaning = "Layers", .stroke = "M10 3L17.5 7L10 11L2.5 7Z", .helper = "M2.5 10.5L10 14.5L17.5 10.5M2.5 14L10 18L17.5 14"},
    IconShape{.text = icon::kSnapDrawing, .meaning = "Snap to drawing", .stroke = "M4 4V10A6 6 0 0 0 16 10V4H12.5V10A2.5 2.5 0 0 1 7.5 10V4ZM4 7H7.5M12.5 7H16"},
    IconShape{.text = icon::kSnapGrid, .meaning = "Snap to grid", .stroke = "", .helper = "M3 7H17M3 13H17M7 3V17M13 3V17", .nodes = "13 7"},
    IconShape{.text = icon::kFit, .meaning = "Zoom to all", .stroke = "M3 7V3H7M13 3H17V7M17 13V17H13M7 17H3V13", .helper = "M7 7H13V13H7Z"},
    IconShape{.text = icon::kEye, .meaning = "Visible", .stroke = "M2.5 10C4.5 6.5 7 5 10 5C13 5 15.5 6.5 17.5 10C15.5 13.5 13 15 10 15C7 15 4.5 13.5 2.5 10Z", .dots = "10 10 2.3"},
    IconShape{.text = icon::kEyeClosed, .meaning = "Hidden", .stroke = "M3 12.5L17 12.5M5.5 12.5L4.3 15M10 12.5V15.5M14.5 12.5L15.7 15"},
    IconShape{.text = icon::kSearch, .meaning = "Search commands", .stroke = "M13.5 8.5A5 5 0 1 1 3.5 8.5A5 5 0 1 1 13.5 8.5ZM12.2 12.2L17 17"},
    IconShape{.text = icon::kPlay, .meaning = "Play", .stroke = "", .fill = "M6 4L16 10L6 16Z"},
    IconShape{.text = icon::kForward, .meaning = "Step forward", .stroke = "M15.5 4.5V15.5", .fill = "M5 4L12.5 10L5 16Z"},
    IconShape{.text = icon::kBack, .meaning = "Step back", .stroke = "M4.5 4.5V15.5", .fill = "M15 4L7.5 10L15 16Z"},
    IconShape{.text = icon::kToStart, .meaning = "To the start", .stroke = "M3.2 4.5V15.5", .fill = "M16.5 5L10.5 10L16.5 15ZM10.5 5L4.5 10L10.5 15Z"},
    IconShape{.text = icon::kToEnd, .meaning = "To the end", .stroke = "M16.8 4.5V15.5", .fill = "M3.5 5L9.5 10L3.5 15ZM9.5 5L15.5 10L9.5 15Z"},
    IconShape{.text = icon::kFlag, .meaning = "Breakpoint", .stroke = "M5 3V17", .fill = "M5 3.5H15L12.5 7L15 10.5H5Z"},
    IconShape{.text = icon::kDown, .meaning = "Open", .stroke = "M6 8L10 12L14 8"},
    IconShape{.text = icon::kRight, .meaning = "Closed", .stroke = "M8 6L12 10L8 14"},
    IconShape{.text = icon::kPlus, .meaning = "Add", .stroke = "M10 4V16M4 10H16"},
    IconShape{.text = icon::kLock, .meaning = "Lock", .stroke = "M5 9H15V16.5H5ZM7 9V6.5A3 3 0 0 1 13 6.5V9"},
    IconShape{.text = icon::kCheck, .meaning = "Passed", .stroke = "M4 10.5L8.5 15L16.5 5.5"},
    IconShape{.text = icon::kCross, .meaning = "Failed", .stroke = "M5 5L15 15M15 5L5 15"},
    IconShape{.text = icon::kWarning, .meaning = "Warning", .stroke = "M10 3L17.5 16.5H2.5ZM10 8V12", .dots = "10 14.2 0.9"},
    IconShape{.text = icon::kRunPlot, .meaning = "Curves of the run", .stroke = "M3.5 3V16.5H17M6 5.5C7.5 11 11 13.5 16.5 14"},
    IconShape{.text = icon::kTheme, .meaning = "Dark or light theme", .stroke = "M17 10A7 7 0 1 1 3 10A7 7 0 1 1 17 10Z", .fill = "M10 3A7 7 0 0 1 10 17Z"},
    IconShape{.text = icon::kComputer, .meaning = "This computer", .stroke = "M4 4H16V12.5H4ZM2.5 16.5H17.5", .dots = "10 14.6 0.9"},
    IconShape{.text = icon::kPause, .meaning = "Pause", .stroke = "", .fill = "M5.5 4.5H8V15.5H5.5ZM12 4.5H14.5V15.5H12Z"},
    IconShape{.text = icon::kClock, .meaning = "Out of date", .stroke = "M17 10A7 7 0 1 1 3 10A7 7 0 1 1 17 10ZM10 5.8V10L13 12"},
    IconShape{.text = icon::kError, .meaning = "Error", .stroke = "M17 10A7 7 0 1 1 3 10A7 7 0 1 1 17 10ZM7.4 7.4L12.6 12.6M12.6 7.4L7.4 12.6"},
    IconShape{.text = icon::kInfo, .meaning = "Note", .stroke = "M17 10A7 7 0 1 1 3 10A7 7 0 1 1 17 10ZM10 9.4V13.8", .dots = "10 6.6 1"},
    IconShape{.text = icon::kUnknown, .meaning = "Not known", .stroke = "M17 10A7 7 0 1 1 3 10A7 7 0 1 1 17 10ZM8 8.2C8 6.9 8.9 6.2 10 6.2C11.1 6.2 12 7 12 8.1C12 9.6 10 9.6 10 11.4", .dots = "10 13.9 0.95"},
    IconShape{.text = icon::kKeyboard, .meaning = "Keyboard shortcuts", .stroke = "M2.5 5.5H17.5V15H2.5Z", .helper = "M7 12H13", .dots = "5.6 8.6 0.85  8.5 8.6 0.85  11.5 8.6 0.85  14.4 8.6 0.85"},
    IconShape{.text = icon::kPanels, .meaning = "Panels beside the canvas", .stroke = "M3 4.5H17V15.5H3ZM12 4.5V15.5", .helper = "M14 7.5H15M14 10H15"},
    IconShape{.text = icon::kTrash, .meaning = "Remove", .stroke = "M3.5 5.5H16.5M8 5.5V3.5H12V5.5M5 5.5L6 16.5H14L15 5.5", .helper = "M8.6 8.5V13.8M11.4 8.5V13.8"},
    IconShape{.text = icon::kUnlock, .meaning = "Unlocked", .stroke = "M5 9H15V16.5H5ZM12 9V6A2.6 2.6 0 0 1 17.2 6V7.5"},
    IconShape{.text = icon::kHome, .meaning = "Home folder", .stroke = "M3 10L10 3.5L17 10M5 8.5V16.5H15V8.5M10 16.5V12"},
    IconShape{.text = icon::kFolder, .meaning = "Folder", .stroke = "M3 15.5V4.5H8L10 6.8H17V15.5Z"},
    IconShape{.text = icon::kFile, .meaning = "File", .stroke = "M5 2.8H11.5L15 6.3V17.2H5ZM11.5 2.8V6.3H15"},
    IconShape{.text = icon::kUp, .meaning = "Up", .stroke = "M10 16V4.5M5.5 9L10 4.5L14.5 9"},
};

} // namespace

std::span<const IconShape> iconShapes() {
    return kShapes;
}

} // namespace forefront
