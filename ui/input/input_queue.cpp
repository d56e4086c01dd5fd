#include "ui/input/input_queue.hpp"

#include <sstream>

namespace forefront {

namespace {

/// Distance in pixels that the pointer may move between wheel notches of one frame; turning the wheel jitters it.
constexpr double kWheelJitter = 4.0;

/// The changes in a frame so far.
struct FrameChanges {
    bool button = false, scrolled = false, key = false, text = false;
    bool sharedKey = false; ///< only keys that may share a frame have changed
    Pixel pointer{};
    std::optional<Pixel> wheelAt; ///< where the pointer was when the wheel first turned
    std::optional<int> pressed;   ///< the key that was pressed, if it may not share the frame

    /// Returns true if `event` must wait for the next frame. A move after a button change would shift the click; two
    /// changes of a button or key would hide each other; text belongs to the key before it. Wheel notches add up, and
    /// keys with `shares` are handled in order.
    bool conflicts(const InputEvent &event, bool shares) const {
        switch (event.kind) {
        case InputKind::MouseMove:
            return button ||
                   (scrolled && !(wheelAt && glm::distance(*wheelAt, Pixel(event.x, event.y)) <= kWheelJitter));
        case InputKind::MouseButton:
            return button || scrolled || key || sharedKey;
        case InputKind::Scroll:
            return button || key || sharedKey;
        case InputKind::Key:
            return shares ? key || button || scrolled : key || sharedKey || text || button || scrolled;
        case InputKind::Text:
            return button || scrolled;
        default:
            return false;
        }
    }

    /// Returns true if a key that is held down repeats once more in this frame. More than one repetition a frame would
    /// wait in the queue, and the key would act on after its release.
    bool repeatsAgain(const InputEvent &event) const {
        return event.kind == InputKind::Key && event.pressed && event.repeated && pressed == event.code;
    }

    void note(const InputEvent &event, bool shares) {
        if (event.kind == InputKind::MouseMove) {
            pointer = Pixel(event.x, event.y);
        }
        if (event.kind == InputKind::Scroll && !scrolled) {
            wheelAt = pointer;
        }
        button = button || event.kind == InputKind::MouseButton;
        scrolled = scrolled || event.kind == InputKind::Scroll;
        key = key || (event.kind == InputKind::Key && !shares);
        if (event.kind == InputKind::Key && event.pressed && !shares) {
            pressed = event.code;
        }
        sharedKey = sharedKey || (event.kind == InputKind::Key && shares);
        text = text || event.kind == InputKind::Text;
    }
};

} // namespace

bool writesText(const InputEvent &event) {
    const bool printable = (event.code >= key::kSpace && event.code < key::kEscape) ||
                           (event.code >= key::kKeypad0 && event.code <= key::kKeypadDecimal) ||
                           event.code == key::kLeftShift || event.code == key::kRightShift;
    return printable && !event.modifiers.control() && !event.modifiers.alt();
}

void InputQueue::push(InputEvent event) {
    events_.push_back(std::move(event));
}

std::vector<InputEvent> InputQueue::takeFrame(const SharesFrame &sharesFrame) {
    ++frame_;
    while (!replay_.empty() && replay_.front().frame <= frame_) {
        events_.push_back(std::move(replay_.front().event));
        replay_.pop_front();
    }
    std::vector<InputEvent> taken;
    FrameChanges changes{.pointer = pointer_};
    while (!events_.empty()) {
        const bool shares = sharesFrame && events_.front().kind == InputKind::Key && sharesFrame(events_.front());
        if (!shares && changes.repeatsAgain(events_.front())) {
            events_.pop_front();
            continue;
        }
        if (changes.conflicts(events_.front(), shares)) {
            break;
        }
        changes.note(events_.front(), shares);
        taken.push_back(std::move(events_.front()));
        events_.pop_front();
    }
    pointer_ = changes.pointer;
    if (recordFrom_) {
        for (const InputEvent &event : taken) {
            recorded_.push_back({frame_ - *recordFrom_, event});
        }
    }
    return taken;
}

void InputQueue::startRecording() {
    recordFrom_ = frame_;
    recorded_.clear();
}

std::string InputQueue::recording() const {
    std::ostringstream out;
    out.precision(17);
    for (const Timed &timed : recorded_) {
        const InputEvent &e = timed.event;
        out << timed.frame << ' ' << static_cast<int>(e.kind) << ' ' << e.x << ' ' << e.y << ' ' << e.code << ' '
            << int{e.pressed} << ' ' << int{e.repeated} << ' ' << int{e.modifiers.bits};
        for (const std::string &path : e.paths) {
            out << '\t' << path;
        }
        out << '\n';
    }
    return out.str();
}

bool InputQueue::replay(const std::string &recording) {
    std::istringstream lines(recording);
    std::deque<Timed> read;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream fields(line.substr(0, line.find('\t')));
        Timed timed;
        int kind = 0, pressed = 0, repeated = 0, modifiers = 0;
        InputEvent &e = timed.event;
        if (!(fields >> timed.frame >> kind >> e.x >> e.y >> e.code >> pressed >> repeated >> modifiers) || kind < 0 ||
            kind > static_cast<int>(InputKind::Close)) {
            return false;
        }
        e.kind = static_cast<InputKind>(kind);
        e.pressed = pressed != 0;
        e.repeated = repeated != 0;
        e.modifiers.bits = static_cast<std::uint8_t>(modifiers & 7);
        for (std::size_t tab = line.find('\t'); tab != std::string::npos;) {
            const std::size_t end = line.find('\t', tab + 1);
            e.paths.push_back(line.substr(tab + 1, end == std::string::npos ? end : end - tab - 1));
            tab = end;
        }
        timed.frame += frame_;
        read.push_back(std::move(timed));
    }
    replay_ = std::move(read);
    return true;
}

} // namespace forefront
