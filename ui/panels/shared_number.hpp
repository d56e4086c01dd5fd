#pragma once

#include <optional>

namespace forefront {

/// A number that items share, unless they differ. An item may have none.
struct SharedNumber {
    std::optional<double> value; ///< of all items
    bool given = false;          ///< an item has one
    bool differs = false;

    void add(const std::optional<double> &number) {
        differs = differs || (any_ && number != value);
        given = given || number.has_value();
        value = differs ? std::nullopt : number;
        any_ = true;
    }
    /// Returns what an empty field shows: `none` if no item has a number.
    const char *hint(const char *none = "auto") const { return differs ? "several" : none; }

  private:
    bool any_ = false;
};

} // namespace forefront
