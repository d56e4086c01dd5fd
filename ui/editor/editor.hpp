#pragma once

#include "ui/input/input_queue.hpp"
#include "ui/parts/shell.hpp"

#include <filesystem>
#include <memory>
#include <string>

namespace forefront {

/// What an editor is opened with.
struct EditorSetup {
    std::filesystem::path settingsFolder; ///< empty: nothing is remembered
    std::filesystem::path stateFolder;    ///< for the recovery journal, see stateFolder(); empty: none is kept
    std::filesystem::path file;           ///< project or domain to open
    bool sample = true;                   ///< open the first sample where no file is given
    std::filesystem::path stateFile;      ///< where each frame's state is written for tests of the real window
};

/// The whole editor, on any platform. One object, one thread.
class Editor {
  public:
    Editor(Platform &platform, EditorSetup options);
    ~Editor();
    Editor(const Editor &) = delete;
    Editor &operator=(const Editor &) = delete;

    /// Takes input, builds the user interface, draws and presents one frame.
    void frame();
    /// Seconds the platform may sleep before the next frame; 0: something moves.
    double sleepSeconds() const;
    /// False while nothing has happened since the last frame; drawing would repeat it.
    bool needsFrame() const;
    bool running() const;
    /// True when the picture will not change any more without input: nothing queued, computed or animated.
    bool settled() const;

    Shell &context();
    InputQueue &input();
    std::uint64_t frames() const;
    /// Opens a project or any domain format; faults go to the log. True if opened.
    bool open(const std::filesystem::path &file);

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace forefront
