#pragma once

#include "ui/input/keys.hpp"
#include "ui/input/pixels.hpp"

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

enum class InputKind : std::uint8_t {
    MouseMove,   ///< x, y: framebuffer pixels from the upper-left corner
    MouseButton, ///< code: MouseButton; pressed
    Scroll,      ///< x, y: wheel steps
    Key,         ///< code: key; pressed; repeated
    Text,        ///< code: Unicode code point
    Focus,       ///< pressed: gained
    Drop,        ///< paths: files dropped
    Close        ///< the user wants to close the window
};

struct InputEvent {
    InputKind kind = InputKind::MouseMove;
    double x = 0.0, y = 0.0;
    int code = 0;
    bool pressed = false;
    bool repeated = false;
    Modifiers modifiers;
    std::vector<std::string> paths;
    double time = 0.0; ///< of a button: when it arrived, in seconds of Platform::now(); 0: in the frame that takes it

    /// Returns when the event arrived. With slow frames, that is before `now`, the time of the frame that takes it.
    double arrival(double now) const { return time > 0.0 ? time : now; }
};

/// Returns true if a key only writes a character, which a field that is being edited takes as text.
bool writesText(const InputEvent &event);

/// Queues input for Dear ImGui 1.86, which polls the input state once per frame and so loses fast changes, such as a
/// click within one frame or Ctrl+A. The queue passes on one change of each kind per frame, in order. Wheel notches and
/// the keys that the caller names may share a frame, so that slow frames do not cause a backlog. The queue also records
/// and replays input.
class InputQueue {
  public:
    /// Returns true for key events that may share a frame, because they are handled in order and without Dear ImGui.
    using SharesFrame = std::function<bool(const InputEvent &)>;

    void push(InputEvent event);
    /// Takes the events of this frame: the longest prefix of the queue in which no change hides another. Drops what a
    /// key that is held down repeats within the frame.
    std::vector<InputEvent> takeFrame(const SharesFrame &sharesFrame = {});
    bool empty() const { return events_.empty(); }

    /// Starts recording every event taken, with its frame number.
    void startRecording();
    /// Returns the recording, one event per line: "FRAME KIND ...".
    std::string recording() const;
    /// Queues a recording, with the same number of frames between its events. Returns false if a line is invalid.
    bool replay(const std::string &recording);
    bool replaying() const { return !replay_.empty(); }

  private:
    struct Timed {
        std::uint64_t frame = 0;
        InputEvent event;
    };

    std::deque<InputEvent> events_;
    Pixel pointer_{}; ///< position of the last move taken, pixels
    std::uint64_t frame_ = 0;
    std::optional<std::uint64_t> recordFrom_;
    std::vector<Timed> recorded_;
    std::deque<Timed> replay_;
};

} // namespace forefront
