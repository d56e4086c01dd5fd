#pragma once

namespace forefront::icon {

// Font Awesome 4.7 in UTF-8. All code points lie below U+FFFF, as Dear ImGui 1.86 needs.
inline constexpr const char *kSelect = "\xef\x89\x85";     // mouse-pointer
inline constexpr const char *kPolygon = "\xef\x81\x80";    // pencil
inline constexpr const char *kPolyline = "\xef\x88\x81";   // line-chart
inline constexpr const char *kCircle = "\xef\x87\x9b";     // circle-thin
inline constexpr const char *kRectangle = "\xef\x82\x96";  // square-o
inline constexpr const char *kEllipse = "\xef\x84\x8c";    // circle-o
inline constexpr const char *kRegular = "\xef\x86\xb2";    // cube
inline constexpr const char *kArc = "\xef\x80\x9e";        // repeat
inline constexpr const char *kPoint = "\xef\x86\x92";      // dot-circle-o
inline constexpr const char *kBrush = "\xef\x87\xbc";      // paint-brush
inline constexpr const char *kSource = "\xef\x81\x9b";     // crosshairs
inline constexpr const char *kGradient = "\xef\x81\x82";   // adjust
inline constexpr const char *kEraser = "\xef\x84\xad";     // eraser
inline constexpr const char *kPlay = "\xef\x81\x8b";       // play
inline constexpr const char *kPause = "\xef\x81\x8c";      // pause
inline constexpr const char *kToStart = "\xef\x81\x89";    // fast-backward
inline constexpr const char *kToEnd = "\xef\x81\x90";      // fast-forward
inline constexpr const char *kBack = "\xef\x81\x88";       // step-backward
inline constexpr const char *kForward = "\xef\x81\x91";    // step-forward
inline constexpr const char *kStop = "\xef\x81\x8d";       // stop
inline constexpr const char *kEye = "\xef\x81\xae";        // eye
inline constexpr const char *kEyeClosed = "\xef\x81\xb0";  // eye-slash
inline constexpr const char *kWarning = "\xef\x81\xb1";    // exclamation-triangle
inline constexpr const char *kError = "\xef\x81\x97";      // times-circle
inline constexpr const char *kInfo = "\xef\x81\x9a";       // info-circle
inline constexpr const char *kCheck = "\xef\x80\x8c";      // check
inline constexpr const char *kCross = "\xef\x80\x8d";      // times
inline constexpr const char *kFolder = "\xef\x81\xbb";     // folder
inline constexpr const char *kFolderOpen = "\xef\x81\xbc"; // folder-open
inline constexpr const char *kFile = "\xef\x80\x96";       // file-o
inline constexpr const char *kSave = "\xef\x83\x87";       // floppy-o
inline constexpr const char *kExport = "\xef\x82\x8e";     // external-link
inline constexpr const char *kImport = "\xef\x82\x90";     // sign-in
inline constexpr const char *kUndo = "\xef\x83\xa2";       // undo
inline constexpr const char *kRedo = "\xef\x80\x9e";       // repeat
inline constexpr const char *kSearch = "\xef\x80\x82";     // search
inline constexpr const char *kSettings = "\xef\x80\x93";   // cog
inline constexpr const char *kHelp = "\xef\x81\x99";       // question-circle
inline constexpr const char *kTrash = "\xef\x87\xb8";      // trash
inline constexpr const char *kMagnet = "\xef\x81\xb6";     // magnet
inline constexpr const char *kFit = "\xef\x82\xb2";        // arrows-alt
inline constexpr const char *kRight = "\xef\x83\x9a";      // caret-right
inline constexpr const char *kDown = "\xef\x83\x97";       // caret-down
inline constexpr const char *kUp = "\xef\x81\xa2";         // arrow-up
inline constexpr const char *kDot = "\xef\x84\x91";        // circle
inline constexpr const char *kBolt = "\xef\x83\xa7";       // bolt
inline constexpr const char *kClock = "\xef\x80\x97";      // clock-o
inline constexpr const char *kPlus = "\xef\x81\xa7";       // plus
inline constexpr const char *kMinus = "\xef\x81\xa8";      // minus
inline constexpr const char *kSun = "\xef\x86\x85";        // sun-o
inline constexpr const char *kMoon = "\xef\x86\x86";       // moon-o
inline constexpr const char *kKeyboard = "\xef\x84\x9c";   // keyboard-o
inline constexpr const char *kImage = "\xef\x80\xbe";      // picture-o
inline constexpr const char *kTag = "\xef\x80\xab";        // tag
inline constexpr const char *kFlag = "\xef\x80\xa4";       // flag
inline constexpr const char *kHome = "\xef\x80\x95";       // home
inline constexpr const char *kRefresh = "\xef\x80\xa1";    // refresh
inline constexpr const char *kUnlock = "\xef\x82\x9c";     // unlock
inline constexpr const char *kLock = "\xef\x80\xa3";       // lock
inline constexpr const char *kList = "\xef\x80\xba";       // list
inline constexpr const char *kColumns = "\xef\x83\x9b";    // columns
inline constexpr const char *kBook = "\xef\x80\xad";       // book
inline constexpr const char *kMeasure = "\xef\x81\xbe";    // arrows-h
inline constexpr const char *kSlot = "\xef\x88\x84";       // toggle-off
inline constexpr const char *kTrim = "\xef\x83\x84";       // scissors

/// Every icon above: the only ones that the fonts hold.
inline constexpr const char *kAll[] = {
    kSelect,  kPolygon,   kPolyline, kCircle, kRectangle, kEllipse, kRegular,  kArc,    kPoint,      kBrush,
    kSource,  kGradient,  kEraser,   kPlay,   kPause,     kToStart, kToEnd,    kBack,   kForward,    kStop,
    kEye,     kEyeClosed, kWarning,  kError,  kInfo,      kCheck,   kCross,    kFolder, kFolderOpen, kFile,
    kSave,    kExport,    kImport,   kUndo,   kRedo,      kSearch,  kSettings, kHelp,   kTrash,      kMagnet,
    kFit,     kRight,     kDown,     kUp,     kDot,       kBolt,    kClock,    kPlus,   kMinus,      kSun,
    kMoon,    kKeyboard,  kImage,    kTag,    kFlag,      kHome,    kRefresh,  kUnlock, kLock,       kList,
    kColumns, kBook,      kMeasure,  kSlot,   kTrim};

} // namespace forefront::icon
