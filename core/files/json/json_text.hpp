#pragma once

#include "core/engine/base/vec2.hpp"
#include "core/files/text/text_writer.hpp"

#include <cmath>

namespace forefront {

/// Writes JSON values as text. A number that JSON cannot hold is written as null, which readers refuse with its place.
class JsonText {
  public:
    explicit JsonText(TextWriter &out) : out_(out) {}

    /// Writes text or an integer as it is.
    template <class Value>
    JsonText &operator<<(const Value &value) {
        out_ << value;
        return *this;
    }
    void number(double value) {
        if (std::isfinite(value)) {
            out_ << value;
        } else {
            out_ << "null";
        }
    }
    void point(Vec2 p) {
        out_ << '[';
        number(p.x);
        out_ << ", ";
        number(p.y);
        out_ << ']';
    }
    /// Calls write(item) for all items, with the separator between them.
    template <class Range, class Write>
    void list(const Range &range, const char *separator, Write write) {
        bool first = true;
        for (const auto &item : range) {
            out_ << (first ? "" : separator);
            first = false;
            write(item);
        }
    }

  private:
    TextWriter &out_;
};

} // namespace forefront
