#pragma once

#include "ui/input/keys.hpp"

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

enum class InputKind : std::uint8_t {
    MouseMove,   ///< x, y: framebuffer pixels from the upper left corner
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
};

/// Stands in front of Dear ImGui 1.86, which polls the state of the input once per frame and so loses fast changes: a
/// click within one frame, ctrl+A. The queue lets one change of a kind through per frame, in order. It is also where
/// input is recorded and replayed.
class InputQueue {
  public:
    void push(InputEvent event);
    /// The events of this frame: the longest beginning of the queue in which no change would hide another.
    std::vector<InputEvent> takeFrame();
    bool empty() const { return events_.empty(); }

    /// From now on every event taken is kept with the number of its frame.
    void startRecording();
    /// One event a line, "FRAME KIND ...", as replay() reads it.
    std::string recording() const;
    /// Queues a recording: its events appear at the same distance in frames. False if a line is not understood.
    bool replay(const std::string &recording);
    bool replaying() const { return !replay_.empty(); }

  private:
    struct Timed {
        std::uint64_t frame = 0;
        InputEvent event;
    };

    std::deque<InputEvent> events_;
    std::uint64_t frame_ = 0;
    std::optional<std::uint64_t> recordFrom_;
    std::vector<Timed> recorded_;
    std::deque<Timed> replay_;
};

} // namespace forefront
