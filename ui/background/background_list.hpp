#pragma once

#include "core/engine/base/assert.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace forefront {

class BackgroundActivity;

/// When the window draws a frame for the results of an activity.
enum class NewsPace : std::uint8_t {
    AtOnce,
    WithMesh,    ///< as fast as new meshes can be drawn
    WithPreview, ///< during a gesture, together with the mesh that is being made
    WhenUsed     ///< no frame is drawn for them; they are used when something else is drawn
};

/// All activities that run in the background of a window. From it, the window knows whether it is at rest and whether
/// there are results to draw. Use it on one thread, except the function that wake() returns.
class BackgroundList {
  public:
    /// `wake` ends the sleep of the window; it is called from any thread when there is a result.
    explicit BackgroundList(std::function<void()> wake) : wake_(std::move(wake)) {}
    ~BackgroundList() { FOREFRONT_ASSERT(activities_.empty()); }
    BackgroundList(const BackgroundList &) = delete;
    BackgroundList &operator=(const BackgroundList &) = delete;

    const std::function<void()> &wake() const { return wake_; }
    std::size_t size() const { return activities_.size(); }
    /// Returns true if no activity is working or has results that the window waits for.
    bool atRest() const;
    /// Returns true if an activity has results and `due` returns true for its pace.
    bool hasNews(const std::function<bool(NewsPace)> &due) const;

  private:
    friend class BackgroundActivity;

    std::function<void()> wake_;
    std::vector<const BackgroundActivity *> activities_;
};

/// Something that works in the background of a window. It is in the list of the window from its construction to its
/// destruction, so the window cannot miss it.
class BackgroundActivity {
  public:
    explicit BackgroundActivity(BackgroundList &list, NewsPace pace = NewsPace::AtOnce) : list_(list), pace_(pace) {
        list_.activities_.push_back(this);
    }
    virtual ~BackgroundActivity() { std::erase(list_.activities_, this); }
    BackgroundActivity(const BackgroundActivity &) = delete;
    BackgroundActivity &operator=(const BackgroundActivity &) = delete;

    /// Returns true while a result is awaited.
    virtual bool working() const = 0;
    /// Returns true if there is a result that has not been fetched.
    virtual bool hasNews() const = 0;
    NewsPace pace() const { return pace_; }

  protected:
    BackgroundList &list() const { return list_; }

  private:
    BackgroundList &list_;
    NewsPace pace_;
};

inline bool BackgroundList::atRest() const {
    return std::none_of(activities_.begin(), activities_.end(), [](const BackgroundActivity *activity) {
        return activity->working() || (activity->pace() != NewsPace::WhenUsed && activity->hasNews());
    });
}

inline bool BackgroundList::hasNews(const std::function<bool(NewsPace)> &due) const {
    return std::any_of(activities_.begin(), activities_.end(), [&due](const BackgroundActivity *activity) {
        return activity->pace() != NewsPace::WhenUsed && activity->hasNews() && due(activity->pace());
    });
}

} // namespace forefront
