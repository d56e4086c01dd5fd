#include "ui/platform/x11_clipboard.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <poll.h>
#include <string_view>
#include <sys/eventfd.h>
#include <unistd.h>
#include <utility>
#include <vector>
#include <xcb/xcb.h>

namespace forefront {
namespace x11 {

using Clock = std::chrono::steady_clock;
constexpr auto kPatience = std::chrono::seconds(1); ///< for an answer of another program
constexpr std::size_t kChunk = 200'000;             ///< bytes sent at once; longer texts go in pieces
constexpr std::size_t kMaxBytes = std::size_t{1} << 30U;

struct Free {
    void operator()(void *reply) const { std::free(reply); }
};
template <class T>
using Reply = std::unique_ptr<T, Free>;
using Event = Reply<xcb_generic_event_t>;

enum Atom : std::uint8_t { Clipboard, Targets, Svg, Utf8, PlainUtf8, Plain, Incr, Manager, SaveTargets, Transfer };
constexpr std::array<std::string_view, Transfer + 1> kAtoms{
    "CLIPBOARD",  "TARGETS", "image/svg+xml",     "UTF8_STRING",  "text/plain;charset=utf-8",
    "text/plain", "INCR",    "CLIPBOARD_MANAGER", "SAVE_TARGETS", "FOREFRONT_TRANSFER"};
constexpr std::array kOffered{Svg, Utf8, PlainUtf8, Plain};

/// A connection to the X server with an invisible window. Errors of requests arrive as events, which are ignored: the
/// window of another program may vanish at any time.
class Connection {
  public:
    Connection() : xcb_(xcb_connect(nullptr, nullptr)) {
        if (!good()) {
            return;
        }
        std::array<xcb_intern_atom_cookie_t, kAtoms.size()> cookies{};
        for (std::size_t k = 0; k < kAtoms.size(); ++k) {
            cookies[k] = xcb_intern_atom(xcb_, 0, static_cast<std::uint16_t>(kAtoms[k].size()), kAtoms[k].data());
        }
        for (std::size_t k = 0; k < kAtoms.size(); ++k) {
            const Reply<xcb_intern_atom_reply_t> reply(xcb_intern_atom_reply(xcb_, cookies[k], nullptr));
            atoms_[k] = reply ? reply->atom : static_cast<xcb_atom_t>(XCB_ATOM_NONE);
        }
        const xcb_screen_t &screen = *xcb_setup_roots_iterator(xcb_get_setup(xcb_)).data;
        const std::uint32_t events = XCB_EVENT_MASK_PROPERTY_CHANGE;
        window_ = xcb_generate_id(xcb_);
        xcb_create_window(xcb_, XCB_COPY_FROM_PARENT, window_, screen.root, 0, 0, 1, 1, 0, XCB_WINDOW_CLASS_INPUT_ONLY,
                          screen.root_visual, XCB_CW_EVENT_MASK, &events);
        xcb_flush(xcb_);
    }
    ~Connection() { xcb_disconnect(xcb_); }
    Connection(const Connection &) = delete;
    Connection &operator=(const Connection &) = delete;

    bool good() const { return xcb_connection_has_error(xcb_) == 0; }
    xcb_connection_t *get() const { return xcb_; }
    xcb_window_t window() const { return window_; }
    xcb_atom_t atom(Atom which) const { return atoms_[which]; }
    int descriptor() const { return xcb_get_file_descriptor(xcb_); }

    /// Returns the next event; null if there is none before the end of the time.
    Event next(Clock::time_point end) const {
        for (;;) {
            if (Event event(xcb_poll_for_event(xcb_)); event) {
                return event;
            }
            const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now()).count();
            pollfd waits{descriptor(), POLLIN, 0};
            if (left <= 0 || !good() || ::poll(&waits, 1, static_cast<int>(left)) <= 0) {
                return nullptr;
            }
        }
    }
    /// Asks the owner of a selection for it in a form.
    void ask(Atom selection, Atom form) const {
        xcb_convert_selection(xcb_, window_, atom(selection), atom(form), atom(Transfer), XCB_CURRENT_TIME);
        xcb_flush(xcb_);
    }

  private:
    xcb_connection_t *xcb_;
    xcb_window_t window_ = XCB_WINDOW_NONE;
    std::array<xcb_atom_t, kAtoms.size()> atoms_{};
};

std::uint8_t kindOf(const Event &event) {
    return event->response_type & 0x7FU;
}

/// The data that a program left in a property of the window.
struct Left {
    bool inPieces = false;
    std::string bytes;
};

Left takeProperty(const Connection &x) {
    const auto cookie = xcb_get_property(x.get(), 1, x.window(), x.atom(Transfer), XCB_GET_PROPERTY_TYPE_ANY, 0,
                                         static_cast<std::uint32_t>(kMaxBytes / 4));
    const Reply<xcb_get_property_reply_t> reply(xcb_get_property_reply(x.get(), cookie, nullptr));
    Left left;
    if (reply) {
        left.inPieces = reply->type == x.atom(Incr);
        left.bytes.assign(static_cast<const char *>(xcb_get_property_value(reply.get())),
                          static_cast<std::size_t>(xcb_get_property_value_length(reply.get())));
    }
    return left;
}

/// Waits for the answer to ask(). Returns false if it is a refusal, or there is none.
bool answered(const Connection &x) {
    const auto end = Clock::now() + kPatience;
    while (const Event event = x.next(end)) {
        if (kindOf(event) == XCB_SELECTION_NOTIFY) {
            xcb_selection_notify_event_t answer{};
            std::memcpy(&answer, event.get(), sizeof answer);
            return answer.property != XCB_ATOM_NONE;
        }
    }
    return false;
}

/// Collects a text that comes in pieces, each after the one before was taken; an empty piece ends it.
std::string takePieces(const Connection &x) {
    std::string bytes;
    auto end = Clock::now() + kPatience;
    while (const Event event = x.next(end)) {
        xcb_property_notify_event_t change{};
        std::memcpy(&change, event.get(), sizeof change);
        if (kindOf(event) != XCB_PROPERTY_NOTIFY || change.atom != x.atom(Transfer) ||
            change.state != XCB_PROPERTY_NEW_VALUE) {
            continue;
        }
        const Left piece = takeProperty(x);
        if (piece.bytes.empty() || bytes.size() > kMaxBytes) {
            return bytes;
        }
        bytes += piece.bytes;
        end = Clock::now() + kPatience;
    }
    return {};
}

} // namespace x11

using namespace x11;

/// Owns the clipboard while it offers something, and answers other programs.
class X11Clipboard::Owner {
  public:
    Owner() : wake_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {}
    ~Owner() { ::close(wake_); }
    Owner(const Owner &) = delete;
    Owner &operator=(const Owner &) = delete;

    bool good() const { return x_.good() && wake_ >= 0; }

    void offer(std::string svg) {
        {
            const std::lock_guard lock(mutex_);
            offered_ = std::make_shared<const std::string>(std::move(svg));
        }
        xcb_set_selection_owner(x_.get(), x_.window(), x_.atom(Clipboard), XCB_CURRENT_TIME);
        owns();   // waits until the server knows, so that what is asked for next is this
        wakeUp(); // the wait may have taken events from the connection
    }

    /// Answers until stopped, then leaves the text to a clipboard manager if there is one.
    void run(const std::stop_token &stop) {
        const std::stop_callback atStop(stop, [this] { wakeUp(); });
        while (!stop.stop_requested() && x_.good()) {
            while (const Event event{xcb_poll_for_event(x_.get())}) {
                handle(event);
            }
            std::array<pollfd, 2> waits{pollfd{x_.descriptor(), POLLIN, 0}, pollfd{wake_, POLLIN, 0}};
            ::poll(waits.data(), waits.size(), -1);
            std::uint64_t wakes = 0;
            [[maybe_unused]] const auto read = ::read(wake_, &wakes, sizeof wakes);
        }
        if (x_.good() && owns()) {
            leaveToManager();
        }
    }

  private:
    /// A text on its way to a window, in pieces.
    struct Sending {
        xcb_window_t to = XCB_WINDOW_NONE;
        xcb_atom_t property = XCB_ATOM_NONE, form = XCB_ATOM_NONE;
        std::shared_ptr<const std::string> text;
        std::size_t sent = 0;
    };

    /// Ends the wait of run().
    void wakeUp() const {
        const std::uint64_t one = 1;
        [[maybe_unused]] const auto written = ::write(wake_, &one, sizeof one);
    }

    bool owns() const {
        const auto cookie = xcb_get_selection_owner(x_.get(), x_.atom(Clipboard));
        const Reply<xcb_get_selection_owner_reply_t> reply(xcb_get_selection_owner_reply(x_.get(), cookie, nullptr));
        return reply && reply->owner == x_.window();
    }

    std::shared_ptr<const std::string> offered() {
        const std::lock_guard lock(mutex_);
        return offered_;
    }

    void handle(const Event &event) {
        if (kindOf(event) == XCB_SELECTION_REQUEST) {
            xcb_selection_request_event_t request{};
            std::memcpy(&request, event.get(), sizeof request);
            answer(request);
        } else if (kindOf(event) == XCB_PROPERTY_NOTIFY) {
            xcb_property_notify_event_t change{};
            std::memcpy(&change, event.get(), sizeof change);
            if (change.state == XCB_PROPERTY_DELETE) {
                sendNext(change.window, change.atom);
            }
        }
    }

    void answer(const xcb_selection_request_event_t &request) {
        // Programs of before 1994 leave the choice of the property to the owner.
        const xcb_atom_t property = request.property != XCB_ATOM_NONE ? request.property : request.target;
        xcb_selection_notify_event_t answer{};
        answer.response_type = XCB_SELECTION_NOTIFY;
        answer.time = request.time;
        answer.requestor = request.requestor;
        answer.selection = request.selection;
        answer.target = request.target;
        if (put(request.requestor, property, request.target)) {
            answer.property = property;
        }
        std::array<char, 32> bytes{}; // the length of an event
        std::memcpy(bytes.data(), &answer, sizeof answer);
        xcb_send_event(x_.get(), 0, request.requestor, XCB_EVENT_MASK_NO_EVENT, bytes.data());
        xcb_flush(x_.get());
    }

    /// Puts the offered text, in a given form, into a property of another window. Returns false for an unknown form.
    bool put(xcb_window_t to, xcb_atom_t property, xcb_atom_t form) {
        const std::shared_ptr<const std::string> text = offered();
        if (form == x_.atom(Targets)) {
            std::array<xcb_atom_t, kOffered.size() + 1> forms{x_.atom(Targets)};
            std::transform(kOffered.begin(), kOffered.end(), forms.begin() + 1, [&](Atom a) { return x_.atom(a); });
            xcb_change_property(x_.get(), XCB_PROP_MODE_REPLACE, to, property, XCB_ATOM_ATOM, 32, forms.size(),
                                forms.data());
            return true;
        }
        const bool known = std::any_of(kOffered.begin(), kOffered.end(), [&](Atom a) { return x_.atom(a) == form; });
        if (!text || !known) {
            return false;
        }
        if (text->size() <= kChunk) {
            xcb_change_property(x_.get(), XCB_PROP_MODE_REPLACE, to, property, form, 8,
                                static_cast<std::uint32_t>(text->size()), text->data());
            return true;
        }
        const std::uint32_t events = XCB_EVENT_MASK_PROPERTY_CHANGE;
        xcb_change_window_attributes(x_.get(), to, XCB_CW_EVENT_MASK, &events);
        const auto size = static_cast<std::uint32_t>(text->size());
        xcb_change_property(x_.get(), XCB_PROP_MODE_REPLACE, to, property, x_.atom(Incr), 32, 1, &size);
        constexpr std::size_t kMostAtOnce = 8; // windows that vanished never take the rest
        if (sending_.size() == kMostAtOnce) {
            sending_.erase(sending_.begin());
        }
        sending_.push_back({to, property, form, text});
        return true;
    }

    /// Sends the next piece of a text when the one before was taken; an empty one ends it.
    void sendNext(xcb_window_t to, xcb_atom_t property) {
        const auto found = std::find_if(sending_.begin(), sending_.end(), [&](const Sending &sending) {
            return sending.to == to && sending.property == property;
        });
        if (found == sending_.end()) {
            return;
        }
        const std::size_t size = std::min(kChunk, found->text->size() - found->sent);
        xcb_change_property(x_.get(), XCB_PROP_MODE_REPLACE, to, property, found->form, 8,
                            static_cast<std::uint32_t>(size), found->text->data() + found->sent);
        xcb_flush(x_.get());
        found->sent += size;
        if (size == 0) {
            sending_.erase(found);
        }
    }

    void leaveToManager() {
        x_.ask(Manager, SaveTargets); // without a manager, the server refuses at once
        const auto end = Clock::now() + kPatience;
        while (const Event event = x_.next(end)) {
            if (kindOf(event) == XCB_SELECTION_NOTIFY) {
                return;
            }
            handle(event);
        }
    }

    Connection x_;
    int wake_; ///< eventfd that wakes the thread
    std::mutex mutex_;
    std::shared_ptr<const std::string> offered_;
    std::vector<Sending> sending_;
};

std::unique_ptr<X11Clipboard> X11Clipboard::open() {
    std::unique_ptr<X11Clipboard> clipboard(new X11Clipboard());
    if (!clipboard->owner_->good()) {
        return nullptr;
    }
    clipboard->thread_ = std::jthread([&owner = *clipboard->owner_](const std::stop_token &stop) { owner.run(stop); });
    return clipboard;
}

X11Clipboard::X11Clipboard() : owner_(std::make_unique<Owner>()) {}

X11Clipboard::~X11Clipboard() = default;

void X11Clipboard::offer(std::string svg) {
    owner_->offer(std::move(svg));
}

std::string X11Clipboard::take() {
    const Connection x;
    if (!x.good()) {
        return {};
    }
    x.ask(Clipboard, Svg);
    if (!answered(x)) {
        return {};
    }
    Left left = takeProperty(x);
    return left.inPieces ? takePieces(x) : std::move(left.bytes);
}

} // namespace forefront
