#pragma once

#include "core/edit/snap.hpp"
#include "ui/parts/tool.hpp"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace forefront {

/// A pair of numbers typed as "x, y" or "@dx, dy".
struct TypedPair {
    Vec2 value;
    bool relative = false;
};

/// Parses two numbers separated by a comma or a space; "@" in front makes them relative. The entire text must be
/// consumed.
std::optional<TypedPair> parsePair(std::string_view text);

/// A quantity that can be typed while drawing. Lengths in domain units, angles in degrees.
enum class EntryField : std::uint8_t { X, Y, Distance, Angle, Width, Height, Radius };
inline constexpr std::size_t kEntryFields = 7;

/// Handles numbers typed while drawing. A digit opens the first field that the tool shows, Tab and Shift+Tab move
/// between fields, X, Y, D and Q open a field by its letter, and Enter accepts. Typed numbers take effect immediately,
/// so that the drawing shows them before Enter. Two numbers ("3, 4" or "@1, 0") are a point.
class NumericEntry {
  public:
    enum class Answer : std::uint8_t {
        Unused, ///< the event was not handled
        Used,
        Place ///< the typed numbers determine the next node: place it
    };
    /// Handles an event. `fields` are those that the tool shows now, in Tab order; X first if there is no node to
    /// measure from.
    Answer handle(const CanvasEvent &event, std::span<const EntryField> fields);

    /// Returns the value of a field, including the number being typed into it.
    std::optional<double> value(EntryField field) const;
    /// Returns the values that fix coordinates, distance (or radius) and angle.
    SnapLocks locks() const;
    /// Returns the pair being typed, or the one just accepted, until clear().
    std::optional<TypedPair> pair() const;
    bool isOpen() const { return open_.has_value(); }
    /// Returns true while the text is invalid.
    bool isWrong() const { return wrong_; }
    /// Clears all fields, after a node was placed or the drawing was cancelled.
    void clear() { *this = {}; }
    /// Returns the visible fields in one line: "w 6   h 5_". Empty if nothing is typed.
    std::string label() const;

  private:
    Answer key(const CanvasEvent &event);
    Answer text(char32_t character);
    Answer letter(EntryField field);
    Answer accept();
    void moveOn(bool back);
    bool store();
    bool determined() const;
    bool anchored() const { return fields_.empty() || fields_.front() != EntryField::X; }
    bool shows(EntryField field) const;
    std::vector<EntryField> visible() const;
    std::optional<double> &slot(EntryField field) { return values_[static_cast<std::size_t>(field)]; }

    std::vector<EntryField> fields_;
    std::array<std::optional<double>, kEntryFields> values_;
    std::optional<EntryField> open_;
    std::string text_;
    bool wrong_ = false;
    bool byDigit_ = false;    ///< the field was opened by a digit, so a single number may suffice
    bool skipLetter_ = false; ///< the letter that opened a field arrives as text too
};

} // namespace forefront
