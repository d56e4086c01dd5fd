#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace forefront {

struct Shell;

/// A drawing with unsaved changes that an earlier run of the program left behind.
struct UnsavedDrawing {
    std::string title;
    std::string about;             ///< number of shapes, time of the last change
    std::filesystem::path journal; ///< file that keeps it
    std::string text;              ///< of its project
    /// Opens it as an unsaved document. Replaces the list in which it is kept, so call a copy.
    std::function<void(Shell &)> open;
};

} // namespace forefront
