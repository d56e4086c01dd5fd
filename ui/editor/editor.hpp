#pragma once

#include "ui/input/input_queue.hpp"
#include "ui/parts/shell.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace forefront {

class Canvas;

/// The settings an editor starts with.
struct EditorSetup {
    std::filesystem::path settingsFolder;      ///< empty: settings are neither read nor saved
    std::filesystem::path stateFolder;         ///< for the recovery journal, see stateFolder(); empty: no journal
    std::filesystem::path file;                ///< project or domain to open
    std::vector<std::filesystem::path> others; ///< projects or domains to open in further tabs
    bool judge = false;                        ///< open `file` as a mesh to inspect, not as a drawing
    bool sample = true;                        ///< open the first sample if no file is given
    bool startPage = false;                    ///< otherwise, show the page with ways to begin
    bool reopens = false;                      ///< if no file is given, open those of the last time as the settings say
    std::filesystem::path stateFile; ///< file that receives the state of each frame, for tests of the real window
};

/// The whole editor, on any platform. One object, one thread.
class Editor {
  public:
    Editor(Platform &platform, EditorSetup options);
    ~Editor();
    Editor(const Editor &) = delete;
    Editor &operator=(const Editor &) = delete;

    /// Processes input, builds the user interface, draws and presents one frame.
    void frame();
    /// Returns how many seconds the platform may sleep before the next frame; 0 while something is animated.
    double sleepSeconds() const;
    /// Returns false if nothing has happened since the last frame, so that drawing would only repeat it.
    bool needsFrame() const;
    bool running() const;
    /// Returns true if the picture can only change through new input: nothing is queued, being computed or animated.
    bool settled() const;

    Shell &context();
    InputQueue &input();
    std::uint64_t frames() const;
    const Canvas &canvas() const;
    /// Opens a project or a file in any domain format and logs its faults. Returns true if it was opened.
    bool open(const std::filesystem::path &file);

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace forefront
