#pragma once

#include "core/edit/snap.hpp"
#include "ui/tools/tool.hpp"

#include <optional>
#include <string>

namespace forefront {

/// A pair of numbers typed as "x, y" or "@dx, dy".
struct TypedPair {
    Vec2 value;
    bool relative = false;
};

/// Parses one number, or two separated by a comma or blank; "@" in front makes a pair relative. The whole text counts.
std::optional<double> parseNumber(std::string_view text);
std::optional<TypedPair> parsePair(std::string_view text);

/// Numbers typed while drawing. X, Y, D or Q, then a number and Enter, lock a coordinate, the distance or the angle
/// (degrees) of the next node; a number typed alone is its distance along the pointer; two numbers are its place.
class NumericEntry {
  public:
    enum class Answer : std::uint8_t {
        Unused, ///< the event is for others
        Used,
        Place ///< what was typed determines the next node: place it
    };
    /// `anchored`: there is a last node to measure from; only then digits alone open the entry.
    Answer handle(const CanvasEvent &event, bool anchored);

    const SnapLocks &locks() const { return locks_; }
    /// A pair that was typed, until clear().
    const std::optional<TypedPair> &pair() const { return pair_; }
    bool isOpen() const { return open_; }
    /// Last text that could not be read, while it stands in the entry.
    bool isWrong() const { return wrong_; }
    /// After a node was placed, or the drawing was given up.
    void clear() { *this = {}; }
    /// "x 3.5   y 2_": what is locked and what is being typed; empty if nothing is.
    std::string label() const;

  private:
    enum class Field : std::uint8_t { Plain, X, Y, Distance, Angle };
    Answer key(const CanvasEvent &event, bool anchored);
    Answer accept();
    void openField(Field field);
    std::optional<double> &lock(Field field);

    Field field_ = Field::Plain;
    bool open_ = false, wrong_ = false;
    bool skipText_ = false; ///< the letter that opened a field arrives as text too
    std::string text_;
    SnapLocks locks_;
    std::optional<TypedPair> pair_;
};

} // namespace forefront
