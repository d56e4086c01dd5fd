#pragma once

#include "ui/parts/action.hpp"

#include <string>
#include <utility>

namespace forefront {

/// The list of all commands with their keys. A click on a key waits for another one; keys that several commands share
/// are marked, since only the first of them that is enabled runs.
class KeyList {
  public:
    KeyList() = default;
    /// Lists only the commands that contain a text.
    explicit KeyList(std::string query) : query_(std::move(query)) {}

    void draw(Shell &context);
    /// Returns true while waiting for a key.
    bool capturing() const { return !capturing_.empty(); }

  private:
    void drawRow(Shell &context, const Action &action);
    void capture(Shell &context);

    std::string query_;
    std::string capturing_; ///< id of the action that waits for a key; empty: none
    bool justBegun_ = false;
};

} // namespace forefront
